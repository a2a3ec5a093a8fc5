// SPDX-License-Identifier: MIT
#include "server/app/entry_check.hpp"

#include "core/match/leg.hpp"
#include "plugins/host/elf.hpp"
#include "plugins/host/process_controller.hpp"
#include "plugins/host/sandbox/private_root.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "plugins/host/sealed_entry.hpp"
#include "server/pace/wall_clock.hpp"
#include "system/digest.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"

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
constexpr std::array<const char*, 10> check_names{
    "file",  "complete", "entry",      "libraries",  "loads",
    "ticks", "leg_blue", "leg_yellow", "repeatable", "budget"};

constexpr std::uint32_t first_ticks = 100;
constexpr double half_s = 8.0;                // of the trial legs
constexpr double max_playing_seconds = 14.0;  // all legs together, without waiting for a processor

// The clocks of the second leg of two that should be alike. The time of day has other remainders
// than the one that every other leg begins with, whatever it is divided by.
constexpr plugins::ClockReadings other_clocks{.time_of_day = 1'234'567'891, .uptime_behind = 17};

// An entry is refused if it would use this many times the processor time that its leg gives. The
// time that a team uses changes by less than that on a busy machine.
constexpr double refused_leg_share = 1.25;

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
  if (const auto cache = disk.read(
          plugins::loader_cache,
          {.max_size = system::size_limit::system_file, .links = system::Links::followed})) {
    // The cache holds paths that end with a zero.
    if (cache->find('/' + name + '\0') != std::string::npos) return true;
  }
  return std::any_of(std::begin(plugins::library_folders), std::end(plugins::library_folders),
                     [&](const char* folder) {
                       std::error_code unknown;  // of a name that no file can have, for example
                       return fs::exists(fs::path(folder) / name, unknown);
                     });
}

// Runs the checks of one entry, one after the other, and fills its report.
class Examination {
 public:
  Examination(std::string path, League league, std::optional<double> half,
              match::TeamParameters parameters, const StepListener& tell)
      : path_(std::move(path)), parameters_(std::move(parameters)), tell_(tell) {
    setup_.league = league;
    real_half_ = half.value_or(setup_.rules.half_s);
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
  Result<TrialLeg> play(Team team, std::uint32_t max_ticks,
                        const plugins::ClockReadings& clocks = {});
  void measure(plugins::ProcessController& process, std::uint32_t ticks);
  bool judge_time();
  bool is_over_time(const Seats& seats);
  static double delay_of(const Seats& seats);

  void tell_next() const {
    const std::size_t next = report_.checks.size();
    if (next < check_names.size())
      tell_(static_cast<int>(next) + 1, static_cast<int>(check_names.size()), check_names[next]);
  }

  // Each adds the result of the next check and returns true if it passed.
  bool pass(std::string text);
  bool fail_with(std::string text);
  bool judge(const TrialLeg& leg, std::string text);

  std::string path_;
  match::TeamParameters parameters_;
  const StepListener& tell_;
  match::Setup setup_;  // of the trial legs
  double real_half_;    // s, of the legs that the entry is for
  pace::SteadyWallClock clock_;
  double delay_ = 0.0;  // s that processes of earlier legs waited for a processor
  std::optional<plugins::SealedEntry> entry_;
  std::optional<plugins::SealedEntry> idle_;
  EntryReport report_;
};

bool Examination::pass(std::string text) {
  report_.checks.push_back({check_names[report_.checks.size()], true, std::move(text)});
  tell_next();
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
  tell_next();
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
      return fail_with("it needs " + system::printable(name) +
                       ", which this system does not have: link it statically");
    }
    names += (names.empty() ? "" : ", ") + system::printable(name);
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

  const auto again = play(Team::blue, UINT32_MAX, other_clocks);
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
  return judge(*again,
               "answers the same observations in the same way, also at another time of day") &&
         judge_time();
}

// A team that would lose each of its legs by its budget is told so now.
bool Examination::judge_time() {
  char text[200];
  std::snprintf(text, sizeof text,
                "a leg with halves of %g s would take %.1f s of processor time, %.0f %% of the "
                "%.1f s that it has",
                real_half_, report_.leg_seconds, 100.0 * report_.leg_share,
                report_.leg_seconds / report_.leg_share);
  if (report_.leg_share > refused_leg_share)
    return fail_with(std::string(text) + ": " + advice(match::FaultCode::budget));
  return pass(text);
}

Result<Examination::TrialLeg> Examination::play(Team team, std::uint32_t max_ticks,
                                                const plugins::ClockReadings& clocks) {
  match::Leg match(setup_);
  Seats seats;
  plugins::ProcessTerms terms;
  terms.isolation = report_.isolation;
  terms.budget = budget();
  terms.clocks = clocks;
  for (const Team seat : both_teams) {
    auto process = plugins::ProcessController::start(
        system::sibling_program("mirocup-plugin-host"), seat == team ? *entry_ : *idle_,
        match.briefing(seat), seat == team ? parameters_ : match::TeamParameters(), terms);
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
  report_.unknown_parameters = plugins::not_asked_for(parameters_, process.asked_parameters());
  if (ticks == 0 || (ticks < first_ticks && report_.mean_tick_ms > 0.0)) return;
  report_.mean_tick_ms = 1e3 * process.playing_seconds() / ticks;
  // In a leg of full length the bank's fixed part hardly counts.
  report_.bank_share = report_.mean_tick_ms / (1e3 * plugins::Budget().bank_per_tick);
  if (ticks <= first_ticks) return;
  // The cheapest of the legs counts: what disturbs a measurement only adds to it.
  const double legs = real_half_ / half_s;
  const double bank = plugins::Budget().bank;
  const double needed = legs * process.playing_seconds();
  const double share = needed / (bank + legs * (process.bank_seconds() - bank));
  if (report_.leg_seconds > 0.0 && share >= report_.leg_share) return;
  report_.leg_seconds = needed;
  report_.leg_share = share;
}

}  // namespace

const Check* EntryReport::failure() const {
  const auto found = std::find_if(checks.begin(), checks.end(),
                                  [](const Check& check) { return check.passed == false; });
  return found == checks.end() ? nullptr : &*found;
}

Result<EntryReport> check_entry(const std::string& path, League league, std::optional<double> half,
                                const match::TeamParameters& parameters, const StepListener& tell) {
  return Examination(path, league, half, parameters, tell).run();
}

}  // namespace mirocup::app
