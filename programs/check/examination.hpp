// SPDX-License-Identifier: MIT
//
// The state of the checks of one entry, and their common functions. Each kind of check is a source:
// file_checks.cpp looks at the bytes, play_checks.cpp lets the entry play, and repeat_checks.cpp
// repeats legs. Checks run one after the other, until one fails.
#pragma once

#include "core/replay/recording.hpp"
#include "plugins/host/elf.hpp"
#include "plugins/host/sealed_entry.hpp"
#include "programs/check/check_plan.hpp"
#include "programs/check/entry_advice.hpp"
#include "programs/check/entry_check.hpp"

namespace mirocup::app {

// The terms of a leg that the entry plays in the sandbox.
struct TrialTerms {
  match::Setup setup;
  const plugins::SealedEntry* opponent = nullptr;
  Team team = Team::blue;  // the colour of the entry
  std::uint32_t max_ticks = UINT32_MAX;
  // The entry's share of the processor time of the check, s, without loading. A leg of a team that
  // is quick enough does not stop there, see CheckPlan::most_use().
  double max_seconds = CheckPlan::longest;
  WatchedTeam::Show show = {};  // changes what the entry sees
  plugins::Surroundings surroundings = {};
  bool is_careful = false;  // true: played by mirocup-careful-host
};

// The result of a trial leg. A leg that was stopped early has no fault.
struct TrialLeg {
  std::optional<match::Fault> fault;
  std::optional<plugins::LastWords> words;  // of a process that ended by itself
  std::vector<match::TickLog> log;
  double start_seconds = 0.0;                  // time to load and create the team; 0: it failed
  double playing_seconds = 0.0;                // processor time
  double slowest_tick_ms = 0.0;                // processor time
  std::uint32_t places = 0;                    // number of calls of place()
  double slept_seconds = 0.0;                  // sleep; waiting for a processor does not count
  std::size_t peak_memory = 0;                 // bytes
  std::size_t grown = 0;                       // memory taken since the team was created, bytes
  std::optional<replay::Recording> recording;  // only of a leg that was played to its end
  LegStory story;
  std::string output;
  std::uint32_t asked_parameters = 0;

  std::uint32_t ticks() const { return static_cast<std::uint32_t>(log.size()); }
  // Returns the entry's answer in a tick; no speeds if the leg ended before.
  match::DrivenCommand answer(std::size_t tick) const {
    return tick < log.size() ? log[tick].commands[index_of(story.team)] : match::DrivenCommand();
  }
};

struct Examination {
  std::string path;
  EntryTerms terms;
  match::Setup setup{};  // the setup of the trial legs
  std::optional<plugins::SealedEntry> entry{}, idle{}, striker{};
  plugins::SharedLibrary library{};  // what an entry that is a library needs and exports
  std::array<TrialLeg, 2> whole{};   // the legs as blue and as yellow
  TrialLeg knockout{};
  std::string requests{};             // lines of ProcessController::requests()
  std::optional<Check> difference{};  // the failure of an entry that does not repeat its answers
  CheckPlan plan{};
  EntryReport report{};
};

// A check: its name, and its function. An error is a failure of the host.
struct Step {
  const char* name;
  Result<Check> (*run)(Examination&);
};
// All checks, in the order in which they run.
extern const std::vector<Step> file_checks, play_checks, repeat_checks;

// Results of a check. A failure has its place in the leg or the file, if there is one.
Check passed(std::string finding);
Check failed(const std::string& what, const std::string& cure, const std::string& where = "");
// Passes with the finding, or fails with the fault of the leg and advice.
Result<Check> judge(Examination& e, const TrialLeg& leg, const TrialTerms& terms,
                    std::string finding);

// Adds the warning of that code, with the values of its sentence.
void note(Examination& e, const char* code, const std::string& first = "",
          const std::string& second = "");
// Adds notes about the play of an entry that has passed.
Result<void> note_play(Examination& e);
// Add a note about a mistake of steering, or about a wrong end, and return true if there is one.
// A team whose wheels turn slowly, though it drives to a ball, has their speeds in m/s.
Result<bool> tell_steering(Examination& e, bool is_slow, bool is_at_wall);
Result<bool> tell_end(Examination& e);

// Returns the terms of the knock-out leg, which has every phase of a match. It and the legs that
// follow, so many `legs`, share the time that is left.
TrialTerms knockout_terms(const Examination& e, int legs);
inline constexpr int repeated_legs = 2;  // the leg as blue, and the knock-out leg

// Plays the leg, or as much of it as the terms allow, and counts its use.
Result<TrialLeg> play(Examination& e, const TrialTerms& terms);
// Adds the entry's use and play in a leg to the report.
void note_use(Examination& e, const TrialLeg& leg, const TrialTerms& terms);

// Returns the sentence of a fault, and its code.
std::string described(const match::Fault& fault);
// True if the careful process, which watches memory, has found a fault.
bool is_memory_mistake(const TrialLeg& leg);

}  // namespace mirocup::app
