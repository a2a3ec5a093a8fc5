// SPDX-License-Identifier: MIT
//
// The state of the checks of one entry, and their common functions. Each kind of check is a source:
// file_checks.cpp looks at the bytes, play_checks.cpp lets the entry play, and repeat_checks.cpp
// repeats legs. Checks run one after the other, in the order of check_names.
#pragma once

#include "plugins/host/sealed_entry.hpp"
#include "programs/check/check_plan.hpp"
#include "programs/check/entry_check.hpp"
#include "programs/check/trial_leg.hpp"

namespace mirocup::app {

// The names of all checks, in the order in which they run.
inline constexpr std::array<const char*, 12> check_names{
    "file",     "complete",   "entry",  "libraries", "loads",  "ticks",
    "leg_blue", "leg_yellow", "budget", "knockout",  "memory", "repeatable"};

struct Examination {
  std::string path;
  EntryTerms terms;
  const OnCheck& on_check;
  const OnStep& on_step;
  match::Setup setup{};  // the setup of the trial legs
  std::optional<plugins::SealedEntry> entry{}, idle{}, striker{};
  TrialLeg blue{}, knockout{};      // the leg as blue, and the knock-out leg
  std::set<MetRestart> restarts{};  // restarts in the legs so far
  double slept = 0.0;               // the entry's sleep, scaled to a leg of full length, s
  std::size_t grown = 0;            // largest growth of the entry's memory in a leg, bytes
  system::Processor needs{};        // as the instructions in the file say
  std::string requests{};           // lines of ProcessController::requests()
  CheckPlan plan{};
  EntryReport report{};
};

// The checks. Each function adds the results of some of check_names, and returns false after a
// failed check. An error is a failure of the host.
Result<bool> examine_file(Examination& e);
Result<bool> load_and_answer(Examination& e);
Result<bool> play_whole_legs(Examination& e);
Result<bool> play_knockout(Examination& e);
Result<bool> repeat_elsewhere(Examination& e);
// Adds the warning of that code, with the values of its sentence.
void note(Examination& e, const char* code, const std::string& first = "",
          const std::string& second = "");
// Adds notes about the play of an entry that has passed.
Result<void> note_play(Examination& e);
// Add a note about a mistake of steering, or about a wrong end, and return true if there is one.
// A team whose wheels turn slowly, though it drives to a ball, has their speeds in m/s.
Result<bool> tell_steering(Examination& e, bool is_slow, bool is_at_wall);
Result<bool> tell_end(Examination& e);

// Calls on_step for the next check.
void tell_next(const Examination& e);

// These functions add the result of the next check and return true if it passed.
bool pass(Examination& e, std::string text);
bool fail_with(Examination& e, Check failed);  // text and name follow from the parts of `failed`
// Passes with the text, or fails with the fault of the leg and advice.
Result<bool> judge(Examination& e, const TrialLeg& leg, const TrialTerms& terms, std::string text);

// Returns the terms of a leg that this entry plays as `team`. A whole leg is against striker.
TrialTerms trial(const Examination& e, Team team, const plugins::SealedEntry& opponent);
TrialTerms whole_leg_terms(const Examination& e, Team team);
// The knock-out leg, which has every phase of a match.
TrialTerms knockout_terms(const Examination& e);
inline constexpr int repeated_legs = 2;  // the leg as blue, and the knock-out leg

// Plays a leg, and counts its use.
Result<TrialLeg> play(Examination& e, const TrialTerms& terms);
// Adds the entry's use and play in a leg to the report.
void note_use(Examination& e, const TrialLeg& leg, const TrialTerms& terms);

// True if the careful process, which watches memory, has found the fault.
bool is_memory_mistake(const match::Fault& fault);

}  // namespace mirocup::app
