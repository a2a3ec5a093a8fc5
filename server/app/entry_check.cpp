// SPDX-License-Identifier: MIT
#include "server/app/entry_check.hpp"

#include "core/match/leg.hpp"
#include "plugins/host/elf.hpp"
#include "plugins/host/process_controller.hpp"
#include "plugins/host/sandbox/private_root.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "plugins/host/sealed_entry.hpp"
#include "server/pace/wall_clock.hpp"
#include "server/system/digest.hpp"
#include "server/system/files.hpp"
#include "server/system/locations.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <unistd.h>
#include <utility>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;

// The names of all checks, in the order in which they run.
constexpr std::array<const char*, 9> check_names{"file",      "complete",   "entry",
                                                 "libraries", "loads",      "ticks",
                                                 "leg_blue",  "leg_yellow", "repeatable"};

constexpr std::uint32_t first_ticks = 100;
constexpr double half_s = 8.0;                // of the legs
constexpr double max_playing_seconds = 14.0;  // all legs together, without waiting for a processor

// Stricter than in a match, so that the author of a slow team learns it soon.
plugins::Budget budget() {
  plugins::Budget budget;
  budget.start_cpu = 4.0;
  budget.start_wall = 5.0;
  budget.tick_wall = 5.0;
  return budget;
}

std::string milliseconds(double ms) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f ms", ms);
  return text;
}

const char* advice(match::FaultCode code) {
  using match::FaultCode;
  switch (code) {
    case FaultCode::no_load:
      return "link everything that it uses into the library, or use what the system has";
    case FaultCode::bad_abi:
      return "build it again against the strategy.h of this version, and export mirocup_entry()";
    case FaultCode::start_timeout:
      return "do less in create() and in static constructors";
    case FaultCode::crash:
      return "build it with -g -fsanitize=address,undefined and call decide() from a test of your "
             "own, or run mirocup match --trusted in a debugger";
    case FaultCode::hang:
    case FaultCode::budget:
      return "a tick has 1 ms of processor time in the mean of a leg; do not wait or sleep";
    case FaultCode::illegal_call:
      return "a strategy computes; files, network, processes and threads are not for it";
    default:
      return "see strategy.h";
  }
}

// True if the dynamic loader finds a library of that name in the sandbox.
bool is_on_this_system(const std::string& name) {
  if (name.find('/') != std::string::npos) return false;
  system::Disk disk;
  if (const auto cache = disk.read(plugins::loader_cache)) {
    // The cache holds paths that end with a zero.
    if (cache->find('/' + name + '\0') != std::string::npos) return true;
  }
  return std::any_of(std::begin(plugins::library_folders), std::end(plugins::library_folders),
                     [&](const char* folder) { return fs::exists(fs::path(folder) / name); });
}

// Runs the checks of one entry, one after the other, and fills its report.
class Examination {
 public:
  Examination(std::string path, League league) : path_(std::move(path)) {
    setup_.league = league;
    setup_.rules.half_s = half_s;
  }

  Result<EntryReport> run();

 private:
  using Seats = std::array<std::unique_ptr<plugins::ProcessController>, 2>;

  // The observations of one trial leg, or of its first ticks.
  struct TrialLeg {
    std::optional<match::Fault> fault;
    bool is_too_slow = false;
    std::vector<match::TickLog> ticks;
  };

  Result<bool> examine_file();
  Result<bool> examine_play();
  Result<TrialLeg> play(Team team, std::uint32_t max_ticks);
  void measure(plugins::ProcessController& process, std::uint32_t ticks);
  bool is_over_time(const Seats& seats);
  static double delay_of(const Seats& seats);

  // Each adds the result of the next check and returns true if it passed.
  bool pass(std::string text);
  bool fail_with(std::string text);
  bool judge(const TrialLeg& leg, std::string text);

  std::string path_;
  match::Setup setup_;
  pace::SteadyWallClock clock_;
  double delay_ = 0.0;  // s that processes of earlier legs waited for a processor
  std::optional<plugins::SealedEntry> entry_;
  std::optional<plugins::SealedEntry> idle_;
  EntryReport report_;
};

bool Examination::pass(std::string text) {
  report_.checks.push_back({check_names[report_.checks.size()], true, std::move(text)});
  return true;
}

bool Examination::fail_with(std::string text) {
  report_.checks.push_back({check_names[report_.checks.size()], false, std::move(text)});
  return false;
}

bool Examination::judge(const TrialLeg& leg, std::string text) {
  if (leg.fault) {
    return fail_with(leg.fault->text + " (" + std::string(to_string(leg.fault->code)) +
                     "): " + advice(leg.fault->code));
  }
  if (leg.is_too_slow) {
    return fail_with("it was stopped because this check may take 20 s only: " +
                     milliseconds(report_.mean_tick_ms) +
                     " of processor time for a tick; it has 1 ms, and should neither wait nor "
                     "sleep");
  }
  return pass(std::move(text));
}

Result<EntryReport> Examination::run() {
  auto looks_well = examine_file();
  if (!looks_well) return tl::unexpected(looks_well.error());
  if (*looks_well) {
    const auto isolation = plugins::strongest_isolation();
    if (!isolation) return tl::unexpected(isolation.error());
    report_.isolation = *isolation;
    if (auto played = examine_play(); !played) return tl::unexpected(played.error());
  }
  while (report_.checks.size() < check_names.size())
    report_.checks.push_back({check_names[report_.checks.size()], std::nullopt, "not tried"});
  return std::move(report_);
}

Result<bool> Examination::examine_file() {
  auto entry = plugins::SealedEntry::open(path_);
  if (!entry) {
    if (entry.error().code != Errc::input) return tl::unexpected(entry.error());
    return fail_with(entry.error().what);
  }
  report_.sha256 = system::sha256(entry->bytes());
  entry_ = std::move(*entry);
  pass("a regular file of " + std::to_string(entry_->bytes().size()) + " bytes");

  const auto library = plugins::read_shared_library(entry_->bytes());
  if (!library) return fail_with(library.error());
  pass("a complete shared library for this kind of processor");
  if (!library->exports_entry) {
    return fail_with(
        "it exports no function mirocup_entry(): write MIROCUP_EXPORT_TEAM(YourClass, \"name\"), "
        "or in C define mirocup_entry()");
  }
  pass("exports mirocup_entry()");
  std::string names;
  for (const std::string& name : library->needed) {
    if (!is_on_this_system(name)) {
      return fail_with("it needs " + plugins::escape_unprintable(name) +
                       ", which this system does not have: link it statically");
    }
    names += (names.empty() ? "" : ", ") + plugins::escape_unprintable(name);
  }
  return pass(names.empty() ? "needs no other library" : "needs " + names);
}

Result<bool> Examination::examine_play() {
  auto idle = plugins::SealedEntry::open(system::house_team("idle"));
  if (!idle) return tl::unexpected(idle.error());
  idle_ = std::move(*idle);

  const auto first = play(Team::blue, 0);
  if (!first) return tl::unexpected(first.error());
  if (!judge(*first, "loads and creates its team in " + milliseconds(report_.start_ms)))
    return false;
  const auto ticks = play(Team::blue, first_ticks);
  if (!ticks) return tl::unexpected(ticks.error());
  if (!judge(*ticks, "answers " + std::to_string(first_ticks) + " observations")) return false;

  const auto blue = play(Team::blue, UINT32_MAX);
  if (!blue) return tl::unexpected(blue.error());
  if (!judge(*blue, "plays a leg as blue against idle, in both halves")) return false;
  const auto yellow = play(Team::yellow, UINT32_MAX);
  if (!yellow) return tl::unexpected(yellow.error());
  if (!judge(*yellow, "plays a leg as yellow against idle, in both halves")) return false;

  const auto again = play(Team::blue, UINT32_MAX);
  if (!again) return tl::unexpected(again.error());
  // The hashes differ if the team asks for other poses at a restart.
  const auto differs =
      std::mismatch(blue->ticks.begin(), blue->ticks.end(), again->ticks.begin(),
                    again->ticks.end(), [](const match::TickLog& a, const match::TickLog& b) {
                      return a.commands == b.commands && a.hash == b.hash;
                    });
  if (differs.first != blue->ticks.end() && differs.second != again->ticks.end()) {
    return fail_with("to the same observations it answers differently in tick " +
                     std::to_string(differs.first - blue->ticks.begin()) +
                     ": take chance from setup.seed, and no clocks, addresses or memory that was "
                     "never written");
  }
  return judge(*again, "answers the same observations in the same way");
}

Result<Examination::TrialLeg> Examination::play(Team team, std::uint32_t max_ticks) {
  match::Leg match(setup_);
  Seats seats;
  const auto bell = std::make_shared<plugins::Doorbell>();
  for (const Team seat : both_teams) {
    auto process = plugins::ProcessController::start(
        system::sibling_program("mirocup-plugin-host"), report_.isolation,
        seat == team ? *entry_ : *idle_, match.briefing(seat), budget(), std::nullopt, bell);
    if (!process) return tl::unexpected(process.error());
    seats[index_of(seat)] = std::move(*process);
  }
  TrialLeg leg;
  plugins::ProcessController& own = *seats[index_of(team)];
  for (const auto& seat : seats) {
    const auto ready = seat->wait_until_ready();
    if (ready) continue;
    if (const auto* failure = std::get_if<match::HostFailure>(&ready.error()))
      return fail(Errc::host, failure->text);
    leg.fault = std::get<match::Fault>(ready.error());
  }
  while (!leg.fault && !match.is_over() && match.tick() < max_ticks && !leg.is_too_slow) {
    match.advance(*seats[0], *seats[1]);
    leg.is_too_slow = is_over_time(seats);
  }
  delay_ += delay_of(seats);
  if (match.is_over()) {
    if (match.outcome().kind == match::OutcomeKind::void_)
      return fail(Errc::host, match.outcome().why_void);
    if (!match.outcome().faults.empty()) leg.fault = match.outcome().faults.front().fault;
  }
  measure(own, match.tick());
  leg.ticks = match.log();
  return leg;
}

// Time in which the processes waited for a processor is not counted: a busy machine is not the
// entry's fault.
bool Examination::is_over_time(const Seats& seats) {
  const double all = clock_.now();
  if (all <= max_playing_seconds) return false;
  const double own_delay = plugins::Child::processor_delay(getpid()).value_or(0.0);
  return all - own_delay - delay_ - delay_of(seats) > max_playing_seconds;
}

// Returns the time for which the processes of both teams were runnable without a processor, s.
double Examination::delay_of(const Seats& seats) {
  double sum = 0.0;
  for (const auto& seat : seats) sum += seat->processor_delay().value_or(0.0);
  return sum;
}

// Times are those of the longest leg yet, the log is that of the last one.
void Examination::measure(plugins::ProcessController& process, std::uint32_t ticks) {
  report_.start_ms = 1e3 * process.start_seconds();
  report_.peak_memory = std::max(report_.peak_memory, process.peak_memory());
  report_.slowest_tick_ms = std::max(report_.slowest_tick_ms, process.slowest_tick_ms());
  report_.log = process.output();
  if (ticks == 0 || (ticks < first_ticks && report_.mean_tick_ms > 0.0)) return;
  report_.mean_tick_ms = 1e3 * process.playing_seconds() / ticks;
  // In a leg of full length the bank's fixed part hardly counts.
  report_.bank_share = report_.mean_tick_ms / (1e3 * plugins::Budget().bank_per_tick);
}

}  // namespace

const Check* EntryReport::failure() const {
  const auto found = std::find_if(checks.begin(), checks.end(),
                                  [](const Check& check) { return check.passed == false; });
  return found == checks.end() ? nullptr : &*found;
}

Result<EntryReport> check_entry(const std::string& path, League league) {
  return Examination(path, league).run();
}

}  // namespace mirocup::app
