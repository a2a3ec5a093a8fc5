// SPDX-License-Identifier: MIT
//
// Warnings from the whole legs of a team that has passed. If the team plays badly, its worst leg is
// played again, each time with one thing swapped: the swap after which the team plays well names
// the mistake.
#include "core/field/field.hpp"
#include "programs/check/examination.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::app {

namespace {

// A habit, the code of its sentence, the share of it that is told of any team, and the share that
// is told of a team that loses more than one that stands.
struct HabitRow {
  Habit habit;
  const char* code;
  double told;
  double suspected;
};
constexpr double never = 1e9;
constexpr HabitRow habit_rows[] = {
    {Habit::own_goal, "own_goals", 0.9, 0.3},  {Habit::wall, "wall", 0.5, 0.3},
    {Habit::own_end, "own_end", never, 0.6},   {Habit::away, "away", never, 0.3},
    {Habit::standing, "stands", 0.9, 0.6},     {Habit::turning, "turns", 0.6, 0.4},
    {Habit::backwards, "backwards", 0.8, 0.6}, {Habit::far, "far", never, 0.4}};

constexpr std::pair<Swap, const char*> swap_rows[] = {
    {Swap::ends, "own_goals"}, {Swap::wheels, "wrong_turn"}, {Swap::directions, "backwards"}};
constexpr std::uint32_t swapped_ticks = 4000;  // that are played again with a swap
// A swap is told if it adds at least this merit, goals a minute.
constexpr double least_gain = 2.0;
constexpr double least_merit = -3.5;  // a team that stands has -3.7
constexpr int least_goals = 2;        // or the swap has only made a bad team harmless

// No command turned a wheel faster: it is in m/s and not in rad/s.
constexpr double told_wheel = 5.0;

// How well a team plays, in goals a minute.
double merit(const LegStory& leg) {
  return leg.lead() / std::max(leg.minutes, 0.1) - 4.0 * leg.of(Habit::own_end);
}

std::string score_of(const LegStory& leg) {
  return system::formatted("%d : %d as %s", leg.score[0], leg.score[1], to_string(leg.team).data());
}

std::string text_of(const HabitRow& row, const LegStory& leg) {
  std::string ticks;
  for (const std::uint32_t tick : leg.count(row.habit).begun)
    ticks += (ticks.empty() ? " (from tick " : ", ") + std::to_string(tick);
  const double number =
      row.habit == Habit::own_goal ? leg.count(row.habit).sum : 100.0 * leg.of(row.habit);
  return sentence(row.code, std::to_string(std::lround(number)), ticks + ")");
}

// Plays the leg again, each time with one thing swapped. Returns the warning if the team then plays
// well.
Result<std::vector<Note>> mistake_by_swaps(Examination& e, const LegStory& leg) {
  std::vector<Note> found;
  double most = std::max(merit(leg) + least_gain, least_merit);
  for (const auto& [swap, code] : swap_rows) {
    TrialTerms terms = whole_leg_terms(e, leg.team);
    terms.max_ticks = swapped_ticks;
    terms.swap = swap;
    MIROCUP_TRY(const auto swapped, play(e, terms));
    const LegStory& other = swapped.story;
    if (merit(other) < most || other.score[0] < least_goals) continue;
    most = merit(other);
    found = {{code, sentence(std::string("swapped ") + code, score_of(other))}};
  }
  return found;
}

// Adds notes about the commands of all legs. Returns false if the robots hardly move, or speeds
// were not finite, which explains all that a leg shows.
bool note_commands(Examination& e) {
  std::array<unsigned, 2> told{};
  double fastest = 0.0;
  for (const LegStory& leg : e.report.legs) {
    for (const std::size_t side : {0u, 1u}) told[side] |= leg.told_wheels[side];
    fastest = std::max(fastest, leg.fastest_wheel);
  }
  // Bit 0 and 1: left and right wheels of these robots, of which at least one was turned.
  const auto turned = [&told](unsigned robots) {
    return ((told[0] & robots) != 0 ? 1 : 0) + ((told[1] & robots) != 0 ? 2 : 0);
  };
  constexpr int both = 3;
  if (const int of_all = turned(~0U); of_all != both) {
    constexpr const char* codes[] = {"never_moved", "silent_right", "silent_left"};
    note(e, codes[of_all]);
    return false;
  }
  for (int i = 0; i < field::make_field(e.setup.league).robots_per_team; ++i) {
    constexpr const char* wheels[] = {"a", "its right", "its left"};
    const int of_one = turned(1U << static_cast<unsigned>(i));
    if (of_one != both) note(e, "silent_robot", std::to_string(i), wheels[of_one]);
  }
  if (fastest < told_wheel) note(e, "slow_wheels", std::to_string(fastest).substr(0, 4));
  return fastest >= told_wheel && e.report.bad_speeds[0].count == 0;
}

// Returns a note for each habit that the leg shows. A weak team is suspected earlier. Where its
// robots are, and the ball goes, is told only if no other habit says why.
std::vector<Note> habits_of(const LegStory& leg, bool is_weak) {
  std::vector<Note> notes;
  for (const HabitRow& row : habit_rows) {
    if (leg.of(row.habit) < (is_weak ? row.suspected : row.told)) continue;
    if ((row.habit != Habit::far && row.habit != Habit::own_end) || notes.empty())
      notes.push_back({row.code, text_of(row, leg)});
  }
  return notes;
}

// Adds one note about a team that loses more than one that stands, with the likely causes.
Result<void> note_weak(Examination& e, const LegStory& worst) {
  std::vector<Note> causes = habits_of(worst, true);
  // Where a goal falls each second, robots have no time for a habit.
  if (causes.empty()) {
    TrialTerms terms = trial(e, worst.team, *e.idle);
    terms.max_ticks = swapped_ticks;
    MIROCUP_TRY(const auto calm, play(e, terms));
    causes = habits_of(calm.story, true);
    for (Note& cause : causes) cause.text = "against a team that stands, " + cause.text;
  }
  std::string text;
  for (const Note& cause : causes)
    text += (text.empty() ? ". Likely causes, the first one first: " : "; ") + cause.text;
  note(e, "weak", score_of(worst), text);
  return {};
}

}  // namespace

Result<void> note_play(Examination& e) {
  const std::vector<LegStory>& legs = e.report.legs;
  if (legs.empty() || e.report.failure() != nullptr || !note_commands(e)) return {};
  const LegStory& worst = *std::ranges::min_element(legs, {}, &LegStory::lead);
  const bool is_weak =
      e.report.strength.is_below_idle || strength_of({worst}, e.setup.league).is_below_idle;
  std::vector<Note> found;
  if (is_weak || e.report.strength.is_below_keeper) {
    MIROCUP_TRY(found, mistake_by_swaps(e, worst));
  }
  if (found.empty() && is_weak) return note_weak(e, worst);
  if (found.empty()) found = habits_of(worst, false);
  for (Note& told : found) e.report.notes.push_back(std::move(told));
  return {};
}

}  // namespace mirocup::app
