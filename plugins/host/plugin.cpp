// SPDX-License-Identifier: MIT
#include "plugins/host/plugin.hpp"

#include "core/base/error.hpp"
#include "plugins/host/floating_point.hpp"
#include "plugins/host/team_host.hpp"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <cxxabi.h>
#include <dlfcn.h>
#include <exception>
#include <memory>
#include <typeinfo>
#include <unistd.h>
#include <utility>

namespace mirocup::plugins {

namespace {

using match::Fault;
using match::FaultCode;

// The members of the first strategy.h of this version. A library may lack those that came later.
constexpr std::size_t min_strategy_size = offsetof(mirocup_strategy, place) + sizeof(void*);

// Versions of strategy.h are small numbers; larger ones are what lay in memory.
constexpr std::uint32_t latest_version = 999;

tl::unexpected<Fault> fault(FaultCode code, std::string text, std::string cause = "") {
  return tl::unexpected<Fault>(Fault{code, std::move(text), std::move(cause)});
}

// Returns "exception " and the type of the exception: "exception std::out_of_range".
std::string cause_of(const std::exception& e) {
  const std::unique_ptr<char, decltype(&std::free)> name(
      ::abi::__cxa_demangle(typeid(e).name(), nullptr, nullptr, nullptr), std::free);
  return std::string("exception ") + (name ? name.get() : "");
}

// Runs foreign code, restores the floating-point mode after it, and turns any exception into a
// fault with a sentence. Nothing is called before that code, so that a careful host finds the stack
// as it was filled.
template <class Call>
tl::expected<void, Fault> guarded(const char* function, Call call) {
  const auto threw = [function](const std::string& what, std::string cause = "exception",
                                int line = 0) {
    return tl::unexpected<Fault>(
        Fault{FaultCode::crash, std::string(function) + "() threw" + what, std::move(cause), line});
  };
  const FloatingPointGuard guard;
  try {
    call();
    return {};
  } catch (const RaisedError& e) {
    return threw(std::string(": ") + e.what(), e.cause, e.line);
  } catch (const std::exception& e) {
    return threw(std::string(": ") + e.what(), cause_of(e));
  } catch (const char* text) {
    return threw(std::string(": ") + (text == nullptr ? "a null text" : text));
  } catch (const std::string& text) {
    return threw(": " + text);
  } catch (int number) {
    return threw(" the number " + std::to_string(number));
  } catch (...) {
    return threw(" something that is not a std::exception");
  }
}

// Returns what the structure lacks; "" if it is complete.
std::string lack_of(const mirocup_strategy& strategy) {
  if (strategy.size < min_strategy_size)
    return "its size is " + std::to_string(strategy.size) + ", and a mirocup_strategy has " +
           std::to_string(sizeof(mirocup_strategy)) + " bytes";
  constexpr const char* names[] = {"create", "decide", "destroy", "place"};  // in their order
  void* functions[4];
  const auto* const bytes = reinterpret_cast<const char*>(&strategy);
  std::memcpy(functions, bytes + offsetof(mirocup_strategy, create), sizeof functions);
  for (int i = 0; i < 4; ++i) {
    Dl_info library;
    if (functions[i] == nullptr && i < 2) return names[i] + std::string(" is null");
    if (functions[i] != nullptr && dladdr(functions[i], &library) == 0)
      return names[i] + std::string(" is not a function, but what lay in that memory");
  }
  return "";
}

}  // namespace

void write_line(const char* text) {
  const std::string line = std::string(text) + "\n";
  (void)!write(STDERR_FILENO, line.data(), line.size());
}

tl::expected<Plugin, Fault> Plugin::load(const std::string& path, const mirocup_setup& setup) {
  const FloatingPointGuard guard;
  auto plugin = open(path);
  if (!plugin) return plugin;
  const auto create = [&] { plugin->team_ = plugin->strategy_->create(&setup); };
  MIROCUP_TRY_VOID(guarded("create", create));
  if (plugin->team_ == nullptr)
    return fault(FaultCode::no_load, "create() returned null" + reason_in_log(setup), "no_team");
  return plugin;
}

tl::expected<void, Fault> Plugin::check(const std::string& path) {
  const FloatingPointGuard guard;
  return open(path).map([](const Plugin&) {});
}

// Loads the library without creating its team.
tl::expected<Plugin, Fault> Plugin::open(const std::string& path) {
  errno = 0;
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* cause = errno == ENOMEM ? "large_tables" : "";
    const std::string why = dlerror();
    if (why.find("undefined symbol: mirocup_") != std::string::npos) cause = "skills_not_linked";
    return fault(FaultCode::no_load, "the library does not load: " + why, cause);
  }
  Plugin plugin(library, nullptr, nullptr);

  using EntryFunction = const mirocup_strategy* (*)();
  const auto entry = reinterpret_cast<EntryFunction>(dlsym(library, "mirocup_entry"));
  if (entry == nullptr) {
    return fault(FaultCode::bad_abi, "the library exports no function mirocup_entry()");
  }
  MIROCUP_TRY_VOID(guarded("mirocup_entry", [&] { plugin.strategy_ = entry(); }));
  const mirocup_strategy* strategy = plugin.strategy_;
  if (strategy == nullptr)
    return fault(FaultCode::bad_abi, "mirocup_entry() returned null", "no_strategy");
  if (strategy->abi_version != MIROCUP_ABI_VERSION)
    return fault(FaultCode::bad_abi,
                 "the library was built for version " + std::to_string(strategy->abi_version) +
                     " of strategy.h, this is version " + std::to_string(MIROCUP_ABI_VERSION) +
                     ": build it again with today's strategy.h",
                 strategy->abi_version == 0               ? "no_version"
                 : strategy->abi_version > latest_version ? "wild_version"
                                                          : "");
  if (std::string what = lack_of(*strategy); !what.empty())
    return fault(FaultCode::bad_abi, "mirocup_entry() returned an incomplete structure: " + what,
                 "incomplete");
  return plugin;
}

Plugin::Plugin(Plugin&& other) noexcept
    : library_(std::exchange(other.library_, nullptr)),
      strategy_(std::exchange(other.strategy_, nullptr)),
      team_(std::exchange(other.team_, nullptr)) {}

Plugin::~Plugin() {
  if (library_ == nullptr) return;
  const FloatingPointGuard guard;
  if (team_ != nullptr && strategy_->destroy != nullptr) {
    // The team has ended, whether its destroy() throws or not.
    (void)guarded("destroy", [this] { strategy_->destroy(team_); });
  }
  dlclose(library_);
}

std::string Plugin::name() const {
  return strategy_->name == nullptr ? std::string() : std::string(strategy_->name);
}

tl::expected<mirocup_command, Fault> Plugin::decide(const mirocup_observation& observation) {
  mirocup_command command{};
  return decide(observation, command);
}

tl::expected<mirocup_command, Fault> Plugin::decide(const mirocup_observation& observation,
                                                    mirocup_command& command) {
  MIROCUP_TRY_VOID(guarded("decide", [&] { strategy_->decide(team_, &observation, &command); }));
  return command;
}

tl::expected<mirocup_placement, Fault> Plugin::place(const mirocup_observation& observation) {
  mirocup_placement placement{};
  placement.ball_x = observation.ball_x;
  placement.ball_y = observation.ball_y;
  for (int i = 0; i < observation.robots; ++i) {
    const mirocup_robot& robot = observation.own[i];
    placement.robots[i] = {robot.x, robot.y, robot.heading};
  }
  if (strategy_->place == nullptr) return placement;
  MIROCUP_TRY_VOID(guarded("place", [&] { strategy_->place(team_, &observation, &placement); }));
  return placement;
}

}  // namespace mirocup::plugins
