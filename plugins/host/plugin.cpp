// SPDX-License-Identifier: MIT
#include "plugins/host/plugin.hpp"

#include "plugins/host/floating_point.hpp"
#include "plugins/host/team_host.hpp"

#include <cstddef>
#include <dlfcn.h>
#include <exception>
#include <unistd.h>
#include <utility>

namespace mirocup::plugins {

namespace {

using match::Fault;
using match::FaultCode;

// The members of the first strategy.h of this version. A library may lack those that came later.
constexpr std::size_t min_strategy_size = offsetof(mirocup_strategy, place) + sizeof(void*);

tl::unexpected<Fault> fault(FaultCode code, std::string text) {
  return tl::unexpected<Fault>(Fault{code, std::move(text)});
}

// Runs foreign code and turns any exception into a fault with a sentence.
template <class Call>
tl::expected<void, Fault> guarded(const char* function, Call call) {
  try {
    call();
    return {};
  } catch (const std::exception& e) {
    return fault(FaultCode::crash, std::string(function) + "() threw: " + e.what());
  } catch (const char* text) {
    return fault(FaultCode::crash,
                 std::string(function) + "() threw: " + (text == nullptr ? "a null text" : text));
  } catch (const std::string& text) {
    return fault(FaultCode::crash, std::string(function) + "() threw: " + text);
  } catch (int number) {
    return fault(FaultCode::crash,
                 std::string(function) + "() threw the number " + std::to_string(number));
  } catch (...) {
    return fault(FaultCode::crash,
                 std::string(function) + "() threw something that is not a std::exception");
  }
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
    return fault(FaultCode::no_load, "create() returned null" + reason_in_log(setup));
  return plugin;
}

tl::expected<void, Fault> Plugin::check(const std::string& path) {
  const FloatingPointGuard guard;
  return open(path).map([](const Plugin&) {});
}

// Loads the library without creating its team.
tl::expected<Plugin, Fault> Plugin::open(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return fault(FaultCode::no_load, std::string("the library does not load: ") + dlerror());
  }
  Plugin plugin(library, nullptr, nullptr);

  using EntryFunction = const mirocup_strategy* (*)();
  const auto entry = reinterpret_cast<EntryFunction>(dlsym(library, "mirocup_entry"));
  if (entry == nullptr) {
    return fault(FaultCode::bad_abi, "the library exports no function mirocup_entry()");
  }
  MIROCUP_TRY_VOID(guarded("mirocup_entry", [&] { plugin.strategy_ = entry(); }));
  const mirocup_strategy* strategy = plugin.strategy_;
  if (strategy == nullptr) return fault(FaultCode::bad_abi, "mirocup_entry() returned null");
  if (strategy->abi_version != MIROCUP_ABI_VERSION) {
    return fault(FaultCode::bad_abi,
                 "the library was built for version " + std::to_string(strategy->abi_version) +
                     " of strategy.h, this is version " + std::to_string(MIROCUP_ABI_VERSION) +
                     ": build it again with today's strategy.h");
  }
  if (strategy->size < min_strategy_size || strategy->create == nullptr ||
      strategy->decide == nullptr) {
    return fault(FaultCode::bad_abi, "mirocup_entry() returned an incomplete structure");
  }
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
  tl::expected<void, Fault> called;
  {
    const FloatingPointGuard guard;
    called = guarded("decide", [&] { strategy_->decide(team_, &observation, &command); });
  }
  if (!called) return tl::unexpected(called.error());
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
  tl::expected<void, Fault> called;
  {
    const FloatingPointGuard guard;
    called = guarded("place", [&] { strategy_->place(team_, &observation, &placement); });
  }
  if (!called) return tl::unexpected(called.error());
  return placement;
}

}  // namespace mirocup::plugins
