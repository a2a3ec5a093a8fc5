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
constexpr double few_goals = 3.0;           // own goals or fouls
constexpr double busy = 15.0;               // goals against the team in a minute
constexpr std::uint32_t calm_ticks = 4000;  // against a team that stands

std::string score_of(const LegStory& leg) {
  return system::formatted("%d : %d as %s", leg.score[0], leg.score[1], to_string(leg.team).data());
}

std::string text_of(const HabitRow& row, const LegStory& leg) {
  std::string ticks;
  for (const std::uint32_t tick : leg.count(row.habit).begun)
    ticks += (ticks.empty() ? " (from tick " : ", ") + std::to_string(tick);
  const double number =
      LegStory::is_counted(row.habit) ? leg.count(row.habit).sum : 100.0 * leg.of(row.habit);
  return sentence(row.code, std::to_string(std::lround(number)), ticks + ")");
}

// Adds notes about the commands of all legs, and returns true if they explain all that a leg shows.
// Sets is_slow if the wheels turn slowly.
bool note_commands(Examination& e, bool& is_slow) {
  const int robots = field::make_field(e.setup.league).robots_per_team;
  std::array<int, 2> any{};
  int told = 0, told_fast = 0;
  double ticks = 0.0;
  for (const LegStory& leg : e.report.legs) ticks += leg.count(Habit::stand).all;
  std::vector<Note> silent;
  for (int i = 0; i < robots; ++i) {
    std::array<int, 2> turned{};
    for (const LegStory& leg : e.report.legs) {
      for (const std::size_t side : {0u, 1u}) turned[side] += leg.turned[i][side];
      told_fast += i > 0 ? leg.turned_fast[i] : 0;
    }
    for (const std::size_t side : {0u, 1u}) any[side] += turned[side];
    const auto [less, more] = std::minmax(turned[0], turned[1]);
    told += i > 0 ? more : 0;
    // A keeper may stand.
    const bool has_stood = more <= silent_share * ticks;
    if (has_stood ? i == 0 : less > silent_share * more) continue;
    const char* const wheel = has_stood ? "a" : turned[0] < turned[1] ? "its left" : "its right";
    silent.push_back({"silent_robot", sentence("silent_robot", std::to_string(i), wheel)});
  }
  const char* const code = any[0] == 0 && any[1] == 0 ? "never_moved"
                           : any[0] == 0              ? "silent_left"
                           : any[1] == 0              ? "silent_right"
                                                      : nullptr;
  if (code != nullptr) return note(e, code), true;
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
    if (leg.of(row.habit) < (is_weak ? row.suspected : row.told)) continue;
    if (LegStory::is_counted(row.habit) && leg.count(row.habit).sum < few_goals) continue;
    if (row.is_alone && !notes.empty()) continue;
    notes.push_back({row.code, text_of(row, leg)});
    if (!LegStory::is_counted(row.habit) && 2.0 * other.of(row.habit) < leg.of(row.habit))
      notes.back().text += sentence("one_colour", std::string(to_string(leg.team)));
  }
  return notes;
}

// Adds one note about a team that loses more than one that stands, with the likely causes.
void note_weak(Examination& e, const LegStory& worst, const LegStory& other, const LegStory& calm) {
  std::vector<Note> causes = habits_of(worst, other, true);
  // Where a goal falls each few seconds, robots have no time for a habit.
  if (causes.empty() || worst.score[1] > busy * worst.minutes) {
    std::vector<Note> of_calm = habits_of(calm, calm, true);
    for (Note& cause : of_calm) cause.text = "against a team that stands, " + cause.text;
    if (!of_calm.empty()) causes = std::move(of_calm);
  }
  std::string text;
  for (const Note& cause : causes)
    text += (text.empty() ? ". Likely causes, the first one first: " : "; ") + cause.text;
  note(e, "weak", score_of(worst), text);
}

}  // namespace

Result<void> note_play(Examination& e) {
  const std::vector<LegStory>& legs = e.report.legs;
  if (legs.empty() || e.report.failure() != nullptr) return {};
  const LegStory& worst = *std::ranges::min_element(legs, {}, &LegStory::lead);
  if (worst.lead() > 0) return {};
  bool is_slow = false;
  if (note_commands(e, is_slow)) return {};
  const LegStory& other = worst.team == legs.front().team ? legs.back() : legs.front();
  const bool is_weak =
      e.report.strength.is_below_idle || strength_of({worst}, e.setup.league).is_below_idle;
  LegStory calm = worst;
  if (is_weak) {
    TrialTerms terms = trial(e, worst.team, *e.idle);
    terms.max_ticks = calm_ticks;
    MIROCUP_TRY(const auto leg, play(e, terms));
    calm = leg.story;
  }
  const bool is_at_wall = std::max(worst.of(Habit::wall), calm.of(Habit::wall)) > told_wall;
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
  if (is_weak) return note_weak(e, worst, other, calm), Result<void>();
  for (Note& told : habits_of(worst, other, e.report.strength.is_below_keeper))
    e.report.notes.push_back(std::move(told));
  return {};
}

}  // namespace mirocup::app
