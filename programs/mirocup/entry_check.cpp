// SPDX-License-Identifier: MIT
#include "programs/mirocup/entry_check.hpp"

#include "plugins/host/elf.hpp"
#include "plugins/host/file_advice.hpp"
#include "plugins/host/host_program.hpp"
#include "plugins/host/sandbox/private_root.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "plugins/host/sealed_entry.hpp"
#include "programs/mirocup/entry_advice.hpp"
#include "programs/mirocup/trial_leg.hpp"
#include "system/digest.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/memory.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <set>
#include <sstream>
#include <utility>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;
using plugins::Surroundings;

// The names of all checks, in the order in which they run.
constexpr std::array<const char*, 12> check_names{"file",   "complete", "entry",    "libraries",
                                                  "loads",  "ticks",    "leg_blue", "leg_yellow",
                                                  "budget", "knockout", "memory",   "repeatable"};

constexpr std::uint32_t first_ticks = 100;
// A team that needs this long for the first ticks waits or computes too long in each, s.
constexpr double max_first_seconds = 2.0;
constexpr double first_half = 10.0;  // s; longer than the first ticks

// A knock-out leg this short is level, so that extra time and shoot-out follow, s.
constexpr double knockout_half = 0.5;
constexpr double knockout_golden_goal = 1.0;

// The leg that is repeated in other surroundings is played this far at most.
constexpr std::uint32_t max_repeated_ticks = 6000;
constexpr int repeated_legs = 2;  // this one, and the knock-out leg

// The search for a cause goes on for this many ticks after the first difference, because two draws
// of a coarse number are often equal in one tick.
constexpr std::uint32_t ticks_after_difference = 100;

// Other surroundings. The time of day has other remainders than the one that every other leg begins
// with, whatever it is divided by.
// They go as in real time, which a wait of some seconds needs to be over; so far they are behind
// that they do not overtake the machine's.
constexpr plugins::ClockReadings other_clocks{
    .time_of_day = 1'234'567'891, .uptime_behind = 217, .between_calls = 33'000'000};
// A clock that counts how often it was read.
constexpr plugins::ClockReadings counting_clocks{.each_reading = 1000};
constexpr std::uint8_t other_fill = 0xC3;  // odd, negative, and no small number in any type
constexpr std::int32_t other_numbers = 4242;
constexpr Surroundings all_other{.clocks = other_clocks,
                                 .fixed_addresses = false,
                                 .memory_fill = other_fill,
                                 .number_offset = other_numbers};

// An entry is refused if it would use this many times the processor time that its leg gives. The
// time that a team uses changes by less than that on a busy machine.
constexpr double refused_leg_share = 1.25;

constexpr const char* depends_on_clock =
    "it depends on a clock: take chance from setup.seed, time from now.time, and stop thinking "
    "after a number of steps";

// A larger log, bytes, and a larger share of a leg's time are told.
constexpr std::size_t told_log = 60u << 10;
constexpr double told_leg_share = 0.6;

// A team that takes this much more memory in a leg than at its start is told, bytes.
constexpr std::size_t told_growth = 256u << 20;

// A restart that no other leg had is played for this many ticks: past the whistle, and into play.
// So is what follows a goal.
constexpr std::uint32_t restart_ticks = 60;

// The ball of a goal that falls in the first tick: m before the goal line, m/s.
constexpr double sure_goal_distance = 0.02;
constexpr double sure_goal_speed = 2.0;

std::string seconds(double s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", s);
  return text;
}

std::string milliseconds(double ms) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f ms", ms);
  return text;
}

// Returns the first tick in which the two legs differ; the hashes differ if the team asks for other
// poses at a restart.
std::optional<std::ptrdiff_t> first_difference(const TrialLeg& one, const TrialLeg& other) {
  const auto differs =
      std::mismatch(one.log.begin(), one.log.end(), other.log.begin(), other.log.end(),
                    [](const match::TickLog& a, const match::TickLog& b) {
                      return a.commands == b.commands && a.hash == b.hash;
                    });
  if (differs.first == one.log.end() || differs.second == other.log.end()) return std::nullopt;
  return differs.first - one.log.begin();
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

// Returns the sanitizer that the library was built with, or "".
std::string sanitizer_of(const plugins::SharedLibrary& library, std::string_view bytes) {
  constexpr std::array<std::pair<const char*, const char*>, 4> sanitizers{
      {{"asan", "address"}, {"tsan", "thread"}, {"msan", "memory"}, {"ubsan", "undefined"}}};
  for (const auto& [name, option] : sanitizers) {
    const std::string file = "lib" + std::string(name) + ".so";
    for (const std::string& needed : library.needed) {
      if (needed.rfind(file, 0) == 0) return option;
    }
    // clang links its run-time library into the program and not into a library.
    if (bytes.find("__" + std::string(name) + "_init") != std::string_view::npos) return option;
  }
  return "";
}

// What careful_memory.cpp says begins like this, in the words of the team's process.
bool is_memory_mistake(const std::string& text) {
  return text.find("says \"it wrote ") != std::string::npos ||
         text.find("says \"it freed ") != std::string::npos;
}

// Runs the checks of one entry, one after the other, and fills its report.
class Examination {
 public:
  Examination(std::string path, const EntryTerms& terms, const OnCheck& on_check,
              const OnStep& on_step)
      : path_(std::move(path)), terms_(terms), on_check_(on_check), on_step_(on_step) {
    setup_.league = terms.league;
    setup_.rules = terms.rules;
    setup_.control_period = match::control_period_of(setup_.rules.preset);
    setup_.rules.mercy_goal_diff = 0;  // so that the second half is played, whatever the score
  }

  Result<EntryReport> run();

 private:
  Result<bool> examine_file();
  Result<bool> examine_python();
  Result<bool> examine_play();
  Result<bool> load_and_answer();
  Result<bool> play_whole_legs();
  Result<bool> play_knockout();
  Result<bool> play_missing_restarts();
  Result<bool> play_goals();
  Result<bool> play_from(const match::Start& start);
  Result<bool> repeat_elsewhere();
  TrialTerms trial(Team team, const plugins::SealedEntry& opponent) const;
  Result<TrialLeg> play(const TrialTerms& terms);
  TrialTerms knockout_terms() const;
  Result<bool> repeat_leg(const TrialTerms& terms, const TrialLeg& first);
  Result<std::string> cause_of_difference(const TrialTerms& terms, const TrialLeg& first);
  Result<std::string> mistake_in_memory(const TrialTerms& terms, FaultEvidence& evidence);
  void note_use(const TrialLeg& leg, const TrialTerms& terms);
  void note_time(const TrialLeg& leg);
  bool judge_time();
  bool has_room_for_moment() const;
  void warn();

  void tell_next() const {
    const std::size_t next = report_.checks.size();
    if (on_step_ && next < check_names.size())
      on_step_(static_cast<int>(next) + 1, static_cast<int>(check_names.size()), check_names[next]);
  }

  // Each adds the result of the next check and returns true if it passed.
  bool add(bool passed, std::string text);
  bool pass(std::string text) { return add(true, std::move(text)); }
  bool fail_with(std::string text) { return add(false, std::move(text)); }
  Result<bool> judge(const TrialLeg& leg, const TrialTerms& terms, std::string text);

  std::string path_;
  EntryTerms terms_;
  const OnCheck& on_check_;
  const OnStep& on_step_;
  match::Setup setup_;  // of the trial legs
  std::optional<plugins::SealedEntry> entry_;
  std::optional<plugins::SealedEntry> idle_;
  std::optional<plugins::SealedEntry> striker_;
  TrialLeg blue_;  // the leg as blue
  TrialLeg knockout_;
  std::set<MetRestart> restarts_;  // in the legs so far
  double slept_ = 0.0;             // s, in a leg of full length
  std::size_t grown_ = 0;          // bytes that it took while a leg was played
  std::string requests_;           // of the team, a line each
  CheckPlan plan_;
  EntryReport report_;
};

Result<EntryReport> Examination::run() {
  tell_next();
  MIROCUP_TRY(auto looks_well, examine_file());
  if (looks_well) {
    MIROCUP_TRY(const auto isolation, plugins::strongest_isolation());
    report_.isolation = isolation;
    MIROCUP_TRY_VOID(examine_play());
  }
  while (report_.checks.size() < check_names.size())
    report_.checks.push_back({check_names[report_.checks.size()], std::nullopt, "not tried"});
  warn();
  report_.used_seconds = plan_.used();
  return std::move(report_);
}

bool Examination::add(bool passed, std::string text) {
  report_.checks.push_back({check_names[report_.checks.size()], passed, std::move(text)});
  if (on_check_) on_check_(report_.checks.back());
  if (passed) tell_next();
  return passed;
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

  if (entry_->is_python()) return examine_python();
  const auto library = plugins::read_shared_library(entry_->bytes());
  if (!library) {
    const std::string known = plugins::advice_on_file(entry_->bytes());
    return fail_with(known.empty() ? library.error() : known);
  }
  pass("a complete shared library for this kind of processor");
  if (!library->exports_entry) return fail_with(plugins::advice_on_missing_entry(entry_->bytes()));
  pass("exports mirocup_entry()");
  if (const std::string tool = sanitizer_of(*library, entry_->bytes()); !tool.empty()) {
    return fail_with("it was built with -fsanitize=" + tool +
                     ", which a sandbox does not allow: hand it in without, and use that build "
                     "with mirocup match --trusted");
  }
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

// Whether the text is a program and has a team, Python says when it is loaded.
Result<bool> Examination::examine_python() {
  MIROCUP_TRY_VOID(plugins::host_program(*entry_));
  pass("a text in Python");
  pass("imports mirocup.team");
  return pass("plays with this system's Python and what is installed for it");
}

Result<bool> Examination::examine_play() {
  MIROCUP_TRY(idle_, plugins::SealedEntry::open(system::house_team("idle")));
  MIROCUP_TRY(striker_, plugins::SealedEntry::open(system::house_team("striker")));

  for (const auto step : {&Examination::load_and_answer, &Examination::play_whole_legs,
                          &Examination::play_knockout, &Examination::repeat_elsewhere}) {
    const auto passed = (this->*step)();
    if (!passed || !*passed) return passed;
  }
  return true;
}

TrialTerms Examination::trial(Team team, const plugins::SealedEntry& opponent) const {
  TrialTerms terms;
  terms.setup = setup_;
  terms.opponent = &opponent;
  terms.team = team;
  terms.parameters = terms_.parameters;
  terms.isolation = report_.isolation;
  return terms;
}

Result<TrialLeg> Examination::play(const TrialTerms& terms) {
  auto leg = play_trial(*entry_, terms);
  if (leg) plan_.add(leg->used_seconds, leg->used_to_start);
  return leg;
}

// True if a few more ticks can be played before the legs that are repeated.
bool Examination::has_room_for_moment() const {
  return plan_.has_room_for(restart_ticks * 1e-3 * report_.mean_tick_ms, repeated_legs);
}

Result<bool> Examination::load_and_answer() {
  TrialTerms terms = trial(Team::blue, *idle_);
  terms.max_ticks = 0;
  MIROCUP_TRY(const auto loaded, play(terms));
  const auto is_loaded = judge(
      loaded, terms, "loads and creates its team in " + milliseconds(1e3 * loaded.start_seconds));
  if (!is_loaded || !*is_loaded) return is_loaded;

  // The legs of a test league may be over sooner.
  terms.setup.rules.half_s = std::max(setup_.rules.half_s, first_half);
  terms.max_ticks = first_ticks;
  terms.max_seconds = max_first_seconds;
  MIROCUP_TRY(const auto first, play(terms));
  if (!first.fault && first.ticks() < first_ticks) {
    note_use(first, terms);
    return fail_with("it needs " + milliseconds(1e3 * max_first_seconds / first.ticks()) +
                     " for a tick, and " + milliseconds(report_.mean_tick_ms) +
                     " of processor time; it has 1 ms, and should neither wait nor sleep");
  }
  return judge(first, terms, "answers " + std::to_string(first_ticks) + " observations");
}

Result<bool> Examination::play_whole_legs() {
  for (const Team team : both_teams) {
    TrialTerms terms = trial(team, *striker_);
    terms.setup.seed = team == Team::blue ? 1 : 2;
    terms.is_recorded = true;
    terms.max_seconds = plan_.share_of(team == Team::blue ? 5 : 4);  // two legs, and what follows
    MIROCUP_TRY(auto leg, play(terms));
    if (leg.recording && (team == Team::blue || leg.fault)) {
      report_.gate_leg = std::move(leg.recording);
      report_.gate_colour = team;
    }
    const auto passed =
        judge(leg, terms,
              "plays " + seconds(leg.ticks() * setup_.control_period) + " s of a leg as " +
                  std::string(to_string(team)) + " against striker");
    if (!passed || !*passed) return passed;
    note_time(leg);
    grown_ = std::max(grown_, leg.peak_memory - std::min(leg.peak_memory, leg.memory_at_start));
    restarts_.merge(leg.restarts);
    if (team == Team::blue) blue_ = std::move(leg);
  }
  return judge_time();
}

TrialTerms Examination::knockout_terms() const {
  TrialTerms terms = trial(Team::blue, *idle_);
  terms.setup.stage = referee::Stage::knockout;
  terms.setup.rules.half_s = knockout_half;
  terms.setup.rules.golden_goal_s = knockout_golden_goal;
  return terms;
}

Result<bool> Examination::play_knockout() {
  TrialTerms terms = knockout_terms();
  terms.max_seconds = plan_.share_of(1 + repeated_legs);
  MIROCUP_TRY(auto leg, play(terms));
  restarts_.merge(leg.restarts);
  knockout_ = std::move(leg);
  if (!knockout_.fault) {
    auto passed = play_missing_restarts();
    if (passed && *passed) passed = play_goals();
    if (!passed || !*passed) return passed;
  }
  return judge(knockout_, terms,
               knockout_.is_whole ? "plays extra time and a shoot-out"
                                  : "plays " + seconds(knockout_.ticks() * setup_.control_period) +
                                        " s of a knock-out leg");
}

// Returns false after a fault, which is added.
Result<bool> Examination::play_missing_restarts() {
  using referee::Restart;
  for (const Restart kind :
       {Restart::GOAL_KICK, Restart::PENALTY_KICK, Restart::FREE_KICK, Restart::FREE_BALL}) {
    for (const Team taker : both_teams) {
      if (restarts_.count({kind, taker == Team::blue}) != 0) continue;
      match::Start start;
      start.restart = match::RestartStart{kind, taker, {}};
      const auto passed = play_from(start);
      if (!passed || !*passed) return passed;
    }
  }
  return true;
}

// Lets a goal fall for each team: in the legs before, none may have fallen. Returns false after a
// fault, which is added.
Result<bool> Examination::play_goals() {
  const double line = field::make_field(setup_.league).half_length;
  for (const double side : {-1.0, 1.0}) {
    match::Start start;
    start.ball = simulator::BallState{{side * (line - sure_goal_distance), 0.0},
                                      {side * sure_goal_speed, 0.0}};
    const auto passed = play_from(start);
    if (!passed || !*passed) return passed;
  }
  return true;
}

// Plays restart_ticks as blue against idle. Returns false after a fault, which is added.
Result<bool> Examination::play_from(const match::Start& start) {
  if (!has_room_for_moment()) return true;
  TrialTerms terms = trial(Team::blue, *idle_);
  terms.setup.start = start;
  terms.max_ticks = restart_ticks;
  MIROCUP_TRY(const auto leg, play(terms));
  return leg.fault ? judge(leg, terms, "") : true;
}

// The knock-out leg, which has every phase of a match, and the leg as blue once more, where nothing
// is as it was but what the team may use.
Result<bool> Examination::repeat_elsewhere() {
  TrialTerms terms_of_short_one = knockout_terms();
  terms_of_short_one.max_seconds = plan_.share_of(repeated_legs);
  const auto short_one = repeat_leg(terms_of_short_one, knockout_);
  if (!short_one || !*short_one) return short_one;
  TrialTerms terms = trial(Team::blue, *striker_);
  terms.max_ticks = max_repeated_ticks;
  terms.max_seconds = plan_.share_of(1);
  const auto long_one = repeat_leg(terms, blue_);
  if (!long_one || !*long_one) return long_one;
  pass(entry_->is_python() ? "plays the same legs again without a fault"
                           : "writes only to memory of its own");
  return pass(
      "answers the same observations in the same way, also at another time of day, at other "
      "addresses and with other memory");
}

// Returns false after a fault or a different answer, which is added.
Result<bool> Examination::repeat_leg(const TrialTerms& terms_of_first, const TrialLeg& first) {
  TrialTerms terms = terms_of_first;
  terms.is_careful = true;
  terms.surroundings = all_other;
  MIROCUP_TRY(const auto again, play(terms));
  requests_ += again.requests;
  if (again.fault && is_memory_mistake(again.fault->fault.text)) return judge(again, terms, "");
  const auto tick = first_difference(first, again);
  // The last tick of a leg that ended by a fault has no answer.
  if (again.fault && (!tick || *tick + 1 >= std::ssize(again.log))) {
    if (again.ticks() >= first.ticks()) return judge(again, terms, "");
    terms.max_ticks = again.ticks() + ticks_after_difference;
    MIROCUP_TRY(const auto cause, cause_of_difference(terms, first));
    note_use(again, terms);
    return fail_with(again.fault->fault.text + " (" +
                     std::string(to_string(again.fault->fault.code)) +
                     "), and not when the leg was played before: " + cause);
  }
  if (!tick) return true;
  terms.max_ticks = static_cast<std::uint32_t>(*tick) + ticks_after_difference;
  MIROCUP_TRY(const auto cause, cause_of_difference(terms, first));
  pass("writes only to memory of its own");
  return fail_with("to the same observations it answers differently in tick " +
                   std::to_string(*tick) + ": " + cause);
}

// A team that differs from itself where nothing has changed draws its own chance. Otherwise one
// thing is changed at a time; the careful heap is kept, because its addresses are others.
Result<std::string> Examination::cause_of_difference(const TrialTerms& terms,
                                                     const TrialLeg& first) {
  plan_.look_for_causes();
  const auto leg_in = [&](const Surroundings& surroundings, bool is_careful) {
    TrialTerms one = terms;
    one.max_seconds = plan_.share_of(1);
    one.surroundings = surroundings;
    one.is_careful = is_careful;
    return play(one);
  };
  MIROCUP_TRY(const auto plain, leg_in({}, false));
  Surroundings counting;
  counting.clocks = counting_clocks;
  if (first_difference(first, plain)) {
    MIROCUP_TRY(const auto counted, leg_in(counting, false));
    MIROCUP_TRY(const auto counted_again, leg_in(counting, false));
    if (!first_difference(counted, counted_again)) return std::string(depends_on_clock);
    return std::string(entry_->is_python()
                           ? "chance of its own: take it from the module random, which setup.seed "
                             "has seeded, and not from clocks, os.urandom() or default_rng()"
                           : "chance of its own, such as std::random_device: take it from "
                             "setup.seed");
  }

  Surroundings clocks, memory, numbers, addresses;
  clocks.clocks = other_clocks;
  memory.memory_fill = other_fill;
  numbers.number_offset = other_numbers;
  addresses.fixed_addresses = false;
  const std::pair<Surroundings, const char*> changes[] = {
      {clocks, depends_on_clock},
      {memory,
       "it depends on memory that was never written, that was freed, or that is not its own: give "
       "each variable and member a value, look for an index out of bounds, and keep no pointer to "
       "what is gone after the call"},
      {numbers,
       "it depends on the number of its process, thread or processor: take chance from setup.seed"},
      {addresses,
       "it depends on addresses, such as the order of pointers in a set: compare numbers instead"}};
  MIROCUP_TRY(const auto careful, leg_in({}, true));
  for (const auto& [surroundings, cause] : changes) {
    if (!plan_.has_room_for(CheckPlan::shortest, 0)) break;
    MIROCUP_TRY(const auto leg, leg_in(surroundings, true));
    if (leg.fault || first_difference(careful, leg)) return std::string(cause);
  }
  return std::string(
      "take chance from setup.seed, and no clocks, addresses or memory that was never written");
}

// Plays a leg that ended in a crash again where the team's memory is watched. Returns what was
// found there before the crash, or "".
Result<std::string> Examination::mistake_in_memory(const TrialTerms& terms,
                                                   FaultEvidence& evidence) {
  TrialTerms careful = terms;
  careful.is_careful = true;
  plan_.look_for_causes();
  careful.max_seconds = plan_.share_of(1);
  MIROCUP_TRY(const auto again, play(careful));
  evidence.requests = again.requests;
  requests_ += again.requests;
  if (!again.fault || again.ticks() >= careful.max_ticks) return std::string();
  const std::string& text = again.fault->fault.text;
  return is_memory_mistake(text) ? "; with its memory watched, " + text : std::string();
}

Result<bool> Examination::judge(const TrialLeg& leg, const TrialTerms& terms, std::string text) {
  note_use(leg, terms);
  if (!leg.fault) return pass(std::move(text));
  FaultEvidence evidence = *leg.fault;
  evidence.is_python = entry_->is_python();
  std::string mistake;
  if (evidence.fault.code == match::FaultCode::crash && !terms.is_careful && !evidence.is_python) {
    MIROCUP_TRY(mistake, mistake_in_memory(terms, evidence));
  }
  return fail_with(evidence.fault.text + " (" + std::string(to_string(evidence.fault.code)) +
                   "): " + advice_on(evidence) + mistake);
}

void Examination::note_use(const TrialLeg& leg, const TrialTerms& terms) {
  report_.start_ms = 1e3 * leg.start_seconds;
  report_.peak_memory = std::max(report_.peak_memory, leg.peak_memory);
  report_.log = leg.output;
  report_.unknown_parameters = plugins::not_asked_for(terms_.parameters, leg.asked_parameters);
  report_.bad_values += leg.bad_values;
  report_.moved_placements += leg.moved_placements;
  report_.has_moved = report_.has_moved || leg.has_moved;
  if (leg.ticks() == 0 || terms.is_careful) return;  // a careful process takes longer
  report_.slowest_tick_ms = std::max(report_.slowest_tick_ms, leg.slowest_tick_ms);
  report_.mean_tick_ms = 1e3 * leg.playing_seconds / leg.ticks();
  // In a leg of full length the bank's fixed part hardly counts.
  report_.bank_share = report_.mean_tick_ms / (1e3 * plugins::Budget().bank_per_tick);
}

// Reckons what a leg of full length would take. The cheapest of the legs counts: what disturbs a
// measurement only adds to it.
void Examination::note_time(const TrialLeg& leg) {
  const plugins::Budget budget;
  const double played = leg.ticks() * setup_.control_period;
  const double legs = std::max(1.0, 2.0 * setup_.rules.half_s / played);
  const double needed = legs * leg.playing_seconds;
  const double share = needed / budget.bank_after(static_cast<std::uint32_t>(legs * leg.ticks()),
                                                  static_cast<std::uint32_t>(legs * leg.places));
  slept_ = std::max(slept_, legs * leg.slept_seconds);
  if (report_.leg_seconds > 0.0 && share >= report_.leg_share) return;
  report_.leg_seconds = needed;
  report_.leg_share = share;
}

// A team that would lose each of its legs by its budget is told so now.
bool Examination::judge_time() {
  char text[200];
  const double most_sleep = plugins::Budget().sleep;
  if (slept_ > most_sleep) {
    std::snprintf(text, sizeof text,
                  "in a leg with halves of %g s it would sleep for %.0f s, and it may for %.0f s: "
                  "do not sleep or wait in decide()",
                  setup_.rules.half_s, slept_, most_sleep);
    return fail_with(text);
  }
  std::snprintf(text, sizeof text,
                "a leg with halves of %g s would take %.1f s of processor time, %.0f %% of the "
                "%.1f s that it has",
                setup_.rules.half_s, report_.leg_seconds, 100.0 * report_.leg_share,
                report_.leg_seconds / report_.leg_share);
  if (report_.leg_share > refused_leg_share) {
    return fail_with(std::string(text) + ": " +
                     (entry_->is_python() ? advice_on_time_in_python : advice_on_time));
  }
  return pass(text);
}

// Tells what is allowed but hardly meant.
void Examination::warn() {
  const auto warn_if = [this](bool holds, std::string text) {
    if (holds) report_.warnings.push_back(std::move(text));
  };
  const bool has_played = blue_.ticks() > 0;
  warn_if(has_played && !report_.has_moved, "it never turned a wheel");
  warn_if(report_.bad_values > 0,
          std::to_string(report_.bad_values) +
              " values of its commands were not finite or too large, and were zeroed or clamped");
  warn_if(report_.moved_placements > 0,
          std::to_string(report_.moved_placements) +
              " of its placements were not legal: robots were moved; the decisions of a record say "
              "which and why");
  warn_if(report_.log.size() > told_log,
          "it logs so much that the middle of the log is left out: 64 KiB of a leg are kept");
  warn_if(report_.leg_share > told_leg_share,
          "it takes most of the time that a leg has; leave room for slower machines");
  warn_if(grown_ > told_growth,
          "it took " + system::mebibytes(grown_) +
              " of memory while a leg was played, and may take 1 GiB in all: free what it does not "
              "need any more");
  std::set<std::string> told;
  std::istringstream lines(requests_);
  for (std::string line; std::getline(lines, line);) {
    // Run-time libraries ask for variables of their own.
    if (line.rfind("variable OMP_", 0) == 0 || line.rfind("variable GOMP_", 0) == 0) continue;
    if (told.insert(line).second)
      warn_if(true, "it asked for a " + system::printable(line) + ", which no team gets");
  }
}

}  // namespace

const Check* EntryReport::failure() const {
  const auto found = std::find_if(checks.begin(), checks.end(),
                                  [](const Check& check) { return check.passed == false; });
  return found == checks.end() ? nullptr : &*found;
}

Result<EntryReport> check_entry(const std::string& path, const EntryTerms& terms,
                                const OnCheck& on_check, const OnStep& on_step) {
  return Examination(path, terms, on_check, on_step).run();
}

}  // namespace mirocup::app
