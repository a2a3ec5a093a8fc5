// SPDX-License-Identifier: MIT
//
// Plays legs between two libraries in this process and prints what they show of the teams, as one
// line of JSON. tests/bench/ladder starts it and reads it.
//
//   ladder_figures A.so B.so FIXTURES SEED HALF LEAGUE RULES
//
// A fixture is two legs of one seed, in which the colours change. Every number is counted in play:
//   passes     a robot lets go of the ball, and a mate touches it next, 0.15 m away at least
//   shots      balls that leave a robot more than 0.4 m before the goal line and would go in
//   saves      those that the opponents touch, or that do not score
//   slow_s     the ball is slower than 0.03 m/s
//   half_s     the ball is in the opponents' half
//   behind     the mean share of the robots that are between the ball and their goal line
//   fouls      calls against the team; `laws` says how many under each law
#include "core/match/leg.hpp"
#include "plugins/host/trusted_controller.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace mirocup {
namespace {

struct TeamFigures {
  int legs_won = 0, fixtures_won = 0, goals = 0, own_goals = 0, penalties = 0, penalty_goals = 0;
  int fouls = 0, passes = 0, shots = 0, saves = 0;
  double half_s = 0.0, behind_s = 0.0;
  std::map<std::string_view, int> laws;  // how often it broke each
};

struct Figures {
  std::array<TeamFigures, 2> teams;  // A and B
  int legs = 0;
  double play_s = 0.0, slow_s = 0.0;
};

template <class E>
E enum_of(const std::string& text) {
  for (std::size_t i = 0; i < enum_names<E>.size(); ++i) {
    if (enum_names<E>[i] == text) return static_cast<E>(i);
  }
  std::fprintf(stderr, "ladder_figures: %s is no league and no preset\n", text.c_str());
  std::exit(2);
}

// Counts one leg. `swapped`: team A is yellow.
class Counter {
 public:
  Counter(const match::Leg& leg, bool swapped, Figures& figures)
      : leg_(leg), swapped_(swapped), figures_(figures) {}

  void count_tick() {
    if (leg_.judged()) count_play();
    for (; seen_ < leg_.decisions().size(); ++seen_) count_decision(leg_.decisions()[seen_]);
  }

 private:
  static constexpr double shot_distance = 0.4;   // m
  static constexpr double pass_distance = 0.15;  // m

  int index(Team team) const { return static_cast<int>(index_of(team)) ^ (swapped_ ? 1 : 0); }
  Team colour(int team) const { return (team == 1) != swapped_ ? Team::yellow : Team::blue; }
  double period() const { return leg_.setup().control_period; }

  void count_play() {
    const simulator::BallState ball = leg_.ball();
    const int left = index(leg_.snapshot().left);
    figures_.play_s += period();
    if (std::sqrt(ball.velocity.squaredNorm()) < 0.03) figures_.slow_s += period();
    figures_.teams[ball.position.x() > 0.0 ? left : 1 - left].half_s += period();
    for (int team = 0; team < 2; ++team) {
      const double sign = team == left ? 1.0 : -1.0;
      int behind = 0;
      for (int i = 0; i < leg_.field().robots_per_team; ++i) {
        if (sign * (ball.position.x() - leg_.robot(colour(team), i).position.x()) > 0.0) ++behind;
      }
      figures_.teams[team].behind_s += period() * behind / leg_.field().robots_per_team;
    }
    count_touch(ball, left);
  }

  void count_touch(const simulator::BallState& ball, int left) {
    const auto touch = leg_.last_touch();
    if (!touch) {
      if (is_touched_) look_for_shot(ball, left);
      is_touched_ = false;
      return;
    }
    const int team = index(touch->team);
    if (shooter_ >= 0 && shooter_ != team) save();
    const bool is_other = has_last_ && last_.team == touch->team && last_.robot != touch->robot;
    const Vec2 way = ball.position - last_place_;
    if (is_other && !is_touched_ && way.squaredNorm() > pass_distance * pass_distance) {
      ++figures_.teams[team].passes;
    }
    last_ = *touch;
    has_last_ = true;
    last_place_ = ball.position;
    is_touched_ = true;
  }

  void look_for_shot(const simulator::BallState& ball, int left) {
    const int team = index(last_.team);
    const double sign = team == left ? 1.0 : -1.0;
    const bool is_far = leg_.field().half_length - sign * ball.position.x() > shot_distance;
    const End goal = team == left ? End::right : End::left;
    if (sign * ball.velocity.x() < 0.3 || !is_far) return;
    if (!match::would_go_in(ball, goal, leg_.field(), leg_.setup().parameters, period())) return;
    shooter_ = team;
    ++figures_.teams[team].shots;
  }

  void save() {
    ++figures_.teams[1 - shooter_].saves;
    shooter_ = -1;
  }

  void count_decision(const match::LoggedDecision& logged) {
    const referee::Decision& d = logged.decision;
    if (d.verdict == referee::Verdict::GOAL) {
      TeamFigures& scorer = figures_.teams[index(*logged.parties.gainer)];
      ++scorer.goals;
      if (logged.credit->own_goal) ++figures_.teams[1 - index(*logged.parties.gainer)].own_goals;
      if (logged.credit->kind == match::GoalKind::penalty) ++scorer.penalty_goals;
      shooter_ = -1;
    } else if (logged.parties.offender && d.verdict != referee::Verdict::NONE) {
      TeamFigures& offender = figures_.teams[index(*logged.parties.offender)];
      ++offender.fouls;
      ++offender.laws[to_string(d.law)];
    }
    if (d.restart == referee::Restart::none) return;
    if (shooter_ >= 0) save();
    if (d.restart == referee::Restart::PENALTY_KICK)
      ++figures_.teams[index(logged.taker)].penalties;
    has_last_ = false;
    is_touched_ = false;
  }

  const match::Leg& leg_;
  bool swapped_;
  Figures& figures_;
  std::size_t seen_ = 0;
  match::Touch last_;
  bool has_last_ = false;
  Vec2 last_place_{0.0, 0.0};
  bool is_touched_ = false;  // in the last tick
  int shooter_ = -1;         // team whose shot is on its way; -1: none
};

std::unique_ptr<match::Controller> load(const char* path, const match::Briefing& briefing) {
  auto controller = plugins::TrustedController::load(path, briefing, {});
  if (controller) return std::move(*controller);
  std::fprintf(stderr, "ladder_figures: %s\n", controller.error().text.c_str());
  std::exit(3);
}

// Returns half points of team A: 2, 1 or 0.
int play_leg(const match::Setup& setup, const char* a, const char* b, bool swapped,
             Figures& figures) {
  match::Leg leg(setup);
  const auto blue = load(swapped ? b : a, leg.briefing(Team::blue));
  const auto yellow = load(swapped ? a : b, leg.briefing(Team::yellow));
  Counter counter(leg, swapped, figures);
  while (!leg.is_over()) {
    leg.advance(*blue, *yellow);
    counter.count_tick();
  }
  const auto& score = leg.outcome().score;
  const int own = score[swapped ? 1 : 0];
  const int other = score[swapped ? 0 : 1];
  ++figures.legs;
  if (own > other) ++figures.teams[0].legs_won;
  if (own < other) ++figures.teams[1].legs_won;
  return own > other ? 2 : own == other ? 1 : 0;
}

nlohmann::json json_of(const TeamFigures& t) {
  return {{"legs_won", t.legs_won},
          {"fixtures_won", t.fixtures_won},
          {"goals", t.goals},
          {"own_goals", t.own_goals},
          {"penalties", t.penalties},
          {"penalty_goals", t.penalty_goals},
          {"fouls", t.fouls},
          {"passes", t.passes},
          {"shots", t.shots},
          {"saves", t.saves},
          {"half_s", t.half_s},
          {"behind_s", t.behind_s},
          {"laws", t.laws}};
}

}  // namespace
}  // namespace mirocup

int main(int argc, char** argv) {
  using namespace mirocup;
  if (argc != 8) {
    std::fprintf(stderr, "usage: ladder_figures A.so B.so FIXTURES SEED HALF LEAGUE RULES\n");
    return 2;
  }
  match::Setup setup;
  setup.league = enum_of<RobotLeague>(argv[6]);
  setup.rules = referee::make_rules(enum_of<referee::Preset>(argv[7]), setup.league);
  setup.rules.half_s = std::atof(argv[5]);
  setup.conditions = match::conditions_of(match::ConditionsPreset::hall);
  setup.control_period = match::control_period_of(setup.rules.preset);
  Figures figures;
  for (int fixture = 0; fixture < std::atoi(argv[3]); ++fixture) {
    setup.seed = std::strtoull(argv[4], nullptr, 10) + static_cast<std::uint64_t>(fixture);
    const int points = play_leg(setup, argv[1], argv[2], false, figures) +
                       play_leg(setup, argv[1], argv[2], true, figures);
    if (points > 2) ++figures.teams[0].fixtures_won;
    if (points < 2) ++figures.teams[1].fixtures_won;
  }
  const nlohmann::json json{{"legs", figures.legs},
                            {"play_s", figures.play_s},
                            {"slow_s", figures.slow_s},
                            {"A", json_of(figures.teams[0])},
                            {"B", json_of(figures.teams[1])}};
  std::puts(json.dump().c_str());
}
