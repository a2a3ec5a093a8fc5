// SPDX-License-Identifier: MIT
//
// Warnings from the whole legs of a team that has passed. A team that has not won its worst leg is
// shown its first tick with small changes, which tell mistakes of steering. If it plays badly and
// none was found, its worst leg is played again, each time with one thing swapped: the swap after
// which the team plays well names the mistake.
#include "core/base/math.hpp"
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
constexpr HabitRow habit_rows[] = {
    {Habit::own_goal, "own_goals", 0.9, 0.3},  {Habit::wall, "wall", 0.95, 0.5},
    {Habit::stand, "stands", 0.9, 0.6},        {Habit::turn, "turns", 0.6, 0.4},
    {Habit::backwards, "backwards", 0.8, 0.6}, {Habit::kick_off, "kick_offs", 0.9, 1e9},
    {Habit::open_goal, "open_goal", 1e9, 0.8}, {Habit::far, "far", 1e9, 0.4}};

// A team for one colour alone has scored this share of the goals of its opponent.
constexpr double told_of_one_colour = 0.3;
// No command turned a wheel faster: it is in m/s and not in rad/s.
constexpr double told_wheel = 5.0;
// Headings as a robot is seen, rad, and a change of its turn, as a difference of wheels, rad/s.
constexpr double small_turn = 0.01;
constexpr double at_pi = pi - 0.01;
constexpr double told_jump = 10.0;
constexpr Vec2 seen_balls[] = {{-0.4, 0.2}, {0.3, -0.3}};

void turn_ends(match::Observation& scene) {
  scene.ball = -scene.ball;
  scene.ball_velocity = -scene.ball_velocity;
  for (auto* robots : {&scene.own, &scene.opponent}) {
    for (match::ObservedRobot& robot : *robots) robot = match::team_frame(End::right, robot);
  }
}

// The things that a team may take for others. If the team plays well with one of them swapped, that
// one is its mistake, whose sentence has this code.
const std::pair<const char*, Trick> swaps[] = {
    {"own_goals", {turn_ends}},
    {"backwards", {{}, [](auto& wheels) { wheels.left *= -1.0, wheels.right *= -1.0; }}}};
constexpr std::uint32_t swapped_ticks = 4000;  // that are played again with a swap
// A swap is told if it adds at least this merit, goals a minute.
constexpr double least_gain = 2.0;
constexpr double least_merit = -3.5;  // a team that stands has -3.7
constexpr int least_goals = 2;        // or the swap has only made a bad team harmless

// How well a team plays, in goals a minute.
double merit(const LegStory& leg) {
  return leg.lead() / std::max(leg.minutes, 0.1);
}

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

// Plays the leg again, each time with one thing swapped. Adds a note if the team then plays well.
Result<void> tell_swap(Examination& e, const LegStory& leg) {
  Note found;
  double most = std::max(merit(leg) + least_gain, least_merit);
  for (const auto& [code, trick] : swaps) {
    TrialTerms terms = whole_leg_terms(e, leg.team);
    terms.max_ticks = swapped_ticks;
    terms.max_seconds = e.plan.share_of(static_cast<int>(std::size(swaps)));
    terms.trick = trick;
    MIROCUP_TRY(const auto swapped, play(e, terms));
    const LegStory& other = swapped.story;
    if (merit(other) < most || other.score[0] < least_goals) continue;
    most = merit(other);
    found = {code, sentence(std::string("swapped ") + code, score_of(other))};
  }
  if (!found.code.empty()) e.report.notes.push_back(std::move(found));
  return {};
}

// Returns the answer to the first tick of a leg in which the ball is seen at that place, and each
// own robot at an odd place, and then `change` is made.
template <class Change>
Result<match::DrivenCommand> answer_to(Examination& e, Vec2 ball, const Change& change) {
  TrialTerms terms = trial(e, Team::blue, *e.idle);
  terms.setup.start.emplace();
  terms.max_ticks = 1;
  terms.trick.show = [&](match::Observation& scene) {
    scene.ball = ball;
    for (match::ObservedRobot& robot : scene.own) robot.position += Vec2(0.013, 0.021);
    change(scene);
  };
  MIROCUP_TRY(const auto leg, play(e, terms));
  return leg.log.empty() ? match::DrivenCommand() : leg.log[0].commands[index_of(Team::blue)];
}

// Changes what the robots see a little, and adds a note if it shows a mistake: the wheels of a
// robot follow the heading of another one in place of its own; all robots but the keeper turn
// farther away; they all turn to the right if the ball is farther to the left; one turns otherwise
// on both sides of the heading pi, wherever the ball is, as a keeper may do.
Result<void> tell_steering(Examination& e) {
  const int robots = field::make_field(e.setup.league).robots_per_team;
  const auto turn_of = [](const match::DrivenCommand& command, int i) {
    return (command.wheels[i][1] - command.wheels[i][0]) * match::wheel_speed_step;
  };
  int away = 0, to_ball = 0, from_ball = 0;
  std::array<int, max_robots_per_team> jumps{};
  for (const Vec2 ball : seen_balls) {
    MIROCUP_TRY(const auto plain, answer_to(e, ball, [](auto&) {}));
    for (int j = 0; j < robots; ++j) {
      MIROCUP_TRY(const auto turned,
                  answer_to(e, ball, [j](auto& scene) { scene.own[j].heading -= small_turn; }));
      for (int i = 0; i < robots && turned.wheels[j] == plain.wheels[j]; ++i) {
        if (turned.wheels[i] == plain.wheels[i]) continue;
        note(e, "order", std::to_string(i), std::to_string(j));
        return {};
      }
      if (j == 0) continue;
      MIROCUP_TRY(const auto moved, answer_to(e, ball, [j](auto& scene) {
                    const Vec2 to = scene.ball - scene.own[j].position;
                    scene.ball += small_turn * Vec2(-to.y(), to.x());
                  }));
      away += turn_of(turned, j) < turn_of(plain, j) ? 1 : 0;
      to_ball += turn_of(moved, j) > turn_of(plain, j) ? 1 : 0;
      from_ball += turn_of(moved, j) < turn_of(plain, j) ? 1 : 0;
    }
    const auto at_heading = [&](double angle) {
      return answer_to(e, ball, [angle](auto& scene) {
        for (match::ObservedRobot& robot : scene.own) robot.heading = angle;
      });
    };
    MIROCUP_TRY(const auto left, at_heading(at_pi));
    MIROCUP_TRY(const auto right, at_heading(-at_pi));
    for (int i = 1; i < robots; ++i)
      jumps[i] += std::abs(turn_of(left, i) - turn_of(right, i)) > told_jump ? 1 : 0;
  }
  constexpr int all = static_cast<int>(std::size(seen_balls));
  const char* const code = away == all * (robots - 1)           ? "wrong_turn"
                           : std::ranges::count(jumps, all) > 0 ? "unwrapped"
                           : to_ball == 0 && from_ball >= all   ? "wrong_side"
                                                                : nullptr;
  if (code != nullptr) note(e, code);
  return {};
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
  if (told[0] == 0 || told[1] == 0) {
    note(e, told[0] != 0 ? "silent_right" : told[1] != 0 ? "silent_left" : "never_moved");
    return false;
  }
  for (unsigned i = 0; std::cmp_less(i, field::make_field(e.setup.league).robots_per_team); ++i) {
    const bool has_left = (told[0] >> i & 1U) != 0;
    const bool has_right = (told[1] >> i & 1U) != 0;
    if (!has_left || !has_right)
      note(e, "silent_robot", std::to_string(i),
           has_left    ? "its right"
           : has_right ? "its left"
                       : "a");
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
    if (row.habit != Habit::far || notes.empty()) notes.push_back({row.code, text_of(row, leg)});
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

Result<void> note_worst(Examination& e, const LegStory& worst) {
  const bool is_weak =
      e.report.strength.is_below_idle || strength_of({worst}, e.setup.league).is_below_idle;
  const std::size_t before = e.report.notes.size();
  const bool is_below_keeper = is_weak || e.report.strength.is_below_keeper;
  if (worst.lead() <= 0) MIROCUP_TRY_VOID(tell_steering(e));
  if (is_below_keeper && e.report.notes.size() == before) MIROCUP_TRY_VOID(tell_swap(e, worst));
  if (e.report.notes.size() > before) return {};
  if (is_weak) return note_weak(e, worst);
  for (Note& told : habits_of(worst, false)) e.report.notes.push_back(std::move(told));
  return {};
}

}  // namespace

Result<void> note_play(Examination& e) {
  const std::vector<LegStory>& legs = e.report.legs;
  if (legs.empty() || e.report.failure() != nullptr || !note_commands(e)) return {};
  const LegStory& worst = *std::ranges::min_element(legs, {}, &LegStory::lead);
  MIROCUP_TRY_VOID(note_worst(e, worst));
  const bool is_of_simurosot = e.setup.rules.preset == referee::Preset::simurosot;
  if (is_of_simurosot && worst.of(Habit::own_goal) >= told_of_one_colour) note(e, "one_colour");
  return {};
}

}  // namespace mirocup::app
