// SPDX-License-Identifier: MIT
//
// Warnings from the whole legs of a team that has passed: one cause, or the likely causes. What
// follows from another cause is not told.
#include "core/field/field.hpp"
#include "programs/check/examination.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::app {

namespace {

// A habit, the code of its sentence, the share of it that is told of any team that does not win,
// and the share that is told of a team that loses more than one that stands. The last ones follow
// from others, so they are told alone.
struct HabitRow {
  Habit habit;
  const char* code;
  double told;
  double suspected;
  bool is_alone = false;
};
constexpr double told_wall = 0.6, told_stand = 0.9;
constexpr HabitRow habit_rows[] = {{Habit::wall, "wall", told_wall, 0.45},
                                   {Habit::stand, "stands", told_stand, 0.6},
                                   {Habit::turn, "turns", 0.6, 0.4},
                                   {Habit::backwards, "backwards", 0.8, 0.6},
                                   {Habit::open_goal, "open_goal", 1e9, 0.4},
                                   {Habit::own_goal, "own_goals", 0.5, 0.3, true},
                                   {Habit::kick_off, "kick_offs", 0.5, 0.5, true},
                                   {Habit::far, "far", 1e9, 0.5, true}};

// A wheel that turns in a smaller share of play is silent, and so are fast wheels.
constexpr double silent_share = 0.03;
// More speeds beyond the limit explain all that a leg shows.
constexpr int few_bad_speeds = 1000;
constexpr double few_goals = 3.0;  // own goals or fouls

// Adds notes about the commands of a leg, and returns true if they explain all that it shows. Sets
// is_slow if the wheels turn slowly.
bool note_commands(Examination& e, const LegStory& leg, bool& is_slow) {
  const int robots = field::make_field(e.setup.league).robots_per_team;
  const auto is_silent = [&leg](std::size_t side) {
    return std::ranges::all_of(leg.turned, [side](const auto& one) { return one[side] == 0; });
  };
  const bool any_left = !is_silent(0), any_right = !is_silent(1);
  if (!any_left || !any_right)
    return note(e, any_left ? "silent_right" : any_right ? "silent_left" : "never_moved"), true;
  int told = 0, told_fast = 0;
  std::vector<Note> silent;
  for (int i = 0; i < robots; ++i) {
    const auto [left, right, fast_ones] = leg.turned[i];
    const auto [less, more] = std::minmax(left, right);
    told += i > 0 ? more : 0;
    told_fast += i > 0 ? fast_ones : 0;
    // A keeper may stand.
    const bool has_stood = more <= silent_share * leg.count(Habit::stand).all;
    if (has_stood ? i == 0 : less > silent_share * more) continue;
    const char* const wheel = has_stood ? "a" : left < right ? "its left" : "its right";
    silent.push_back({"silent_robot", sentence("silent_robot", std::to_string(i), wheel)});
  }
  is_slow = told_fast <= silent_share * told;
  // Where all others stand, the reason is not the number of a robot.
  if (std::ssize(silent) >= robots - 1) silent.clear();
  std::ranges::move(silent, std::back_inserter(e.report.notes));
  if (!silent.empty() && is_slow) note(e, "slow_wheels");
  return !silent.empty() || e.report.bad_speeds[0].count > 0;
}

// Returns a note for each habit that the leg shows. A weak team is suspected earlier.
std::vector<Note> habits_of(const LegStory& leg, const LegStory& other, bool is_weak) {
  std::vector<Note> notes;
  for (const HabitRow& row : habit_rows) {
    const HabitCount& count = leg.count(row.habit);
    const double share = leg.of(row.habit);
    const bool is_counted = LegStory::is_counted(row.habit);
    if (share < (is_weak ? row.suspected : row.told)) continue;
    if (is_counted && count.sum < few_goals) continue;
    if (row.is_alone && !notes.empty()) continue;
    const auto number = std::to_string(std::lround(is_counted ? count.sum : 100.0 * share));
    std::string text = sentence(row.code, number, std::to_string(count.first));
    if (!is_counted && 2.0 * other.of(row.habit) < share)
      text += sentence("one_colour", std::string(to_string(leg.team)));
    notes.push_back({row.code, text});
  }
  return notes;
}

}  // namespace

Result<void> note_play(Examination& e) {
  const std::vector<LegStory>& legs = e.report.legs;
  if (legs.empty()) return {};
  const LegStory& worst = *std::ranges::min_element(legs, {}, &LegStory::lead);
  bool is_slow = false;
  if (worst.lead() > 0 || note_commands(e, worst, is_slow)) return {};
  const bool is_at_wall = worst.of(Habit::wall) > told_wall;
  MIROCUP_TRY(const bool is_steering, tell_steering(e, is_slow, is_at_wall));
  // Speeds that are too large may follow from a turn that is too large.
  if (is_steering)
    std::erase_if(e.report.notes, [](auto& told) { return told.code == "too_large"; });
  if (is_steering || e.report.bad_speeds[1].count > few_bad_speeds) return {};
  // A team at a wall, or one that stands, shows no end.
  if (!is_at_wall && worst.of(Habit::stand) < told_stand) {
    MIROCUP_TRY(const bool is_end, tell_end(e));
    if (is_end && e.setup.rules.preset == referee::Preset::simurosot) note(e, "simurosot_side");
    if (is_end) return {};
  }
  const bool is_weak =
      e.report.strength.is_below_idle || strength_of({worst}, e.setup.league).is_below_idle;
  const LegStory& other = worst.team == legs.front().team ? legs.back() : legs.front();
  std::string causes;
  for (Note& cause : habits_of(worst, other, is_weak || e.report.strength.is_below_keeper)) {
    causes += (causes.empty() ? ". Likely causes, the first one first: " : "; ") + cause.text;
    if (!is_weak) e.report.notes.push_back(std::move(cause));
  }
  const auto& [own, opponents] = worst.score;
  if (is_weak)
    note(e, "weak",
         system::formatted("%d : %d as %s", own, opponents, to_string(worst.team).data()), causes);
  return {};
}

}  // namespace mirocup::app
