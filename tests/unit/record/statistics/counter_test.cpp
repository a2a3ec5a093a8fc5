// SPDX-License-Identifier: MIT
//
// Situations with known answers: ticks written by hand in which exactly one thing happens. Each is
// also played half-turned and with the colours exchanged, and must give the same.
#include "record/statistics/counter.hpp"

#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace mirocup::statistics {
namespace {

constexpr double period = 0.033;

// A view of the same play: with the ends or the colours exchanged.
struct View {
  bool is_turned = false;
  bool is_recoloured = false;

  Team of(Team team) const { return is_recoloured ? opponent_of(team) : team; }
};

// Writes a leg tick by tick. As told, blue defends the left end and attacks +x.
class Play {
 public:
  explicit Play(View view = {}) : view_(view), counter_(field_, period) {}

  // The ball moves to `ball` in one tick. `velocity`: at the end of it, m/s.
  Play& tick(const Vec2& ball, const Vec2& velocity = {0.0, 0.0}) {
    ball_ = ball;
    PlayTick t = next();
    t.ball = turned(ball);
    t.ball_velocity = turned(velocity);
    t.touched = std::exchange(touched_, {});
    t.driven = {0.01, 0.01};
    counter_.add(t);
    return *this;
  }

  // The robot touches the ball in the next tick.
  Play& touched_by(Team team, int robot) {
    touched_[index_of(view_.of(team))].set(static_cast<std::size_t>(robot));
    return *this;
  }

  // The ball rests for some ticks, and no robot touches it.
  Play& rest(double seconds) {
    for (double t = 0.0; t < seconds; t += period) tick(ball_);
    return *this;
  }

  // In the next tick the referee calls this, and play stops.
  Play& call(match::LoggedDecision d) {
    PlayTick t = next();
    t.ball = turned(ball_);
    t.touched = std::exchange(touched_, {});
    t.goes_on = false;
    d.tick = t.tick;
    t.decisions = {&d, 1};
    counter_.add(t);
    return *this;
  }

  // A tick between a decision and the whistle.
  Play& wait() {
    PlayTick t = next();
    t.is_play = false;
    counter_.add(t);
    return *this;
  }

  match::LoggedDecision goal(Team team, match::GoalKind kind, bool own_goal = false) const {
    match::LoggedDecision d = decision(referee::Verdict::GOAL, referee::Law::goal, team);
    d.decision.restart = referee::Restart::KICK_OFF;
    d.credit = match::GoalCredit{.scorer = {}, .assist = {}, .own_goal = own_goal, .kind = kind};
    return d;
  }

  match::LoggedDecision foul(Team team, referee::Law law) const {
    match::LoggedDecision d = decision(referee::Verdict::FREE_KICK, law, team);
    d.decision.restart = referee::Restart::FREE_KICK;
    d.taker = opponent_of(view_.of(team));
    d.parties = match::parties_of(d.decision, d.team, d.taker);
    return d;
  }

  // The numbers of a team, as it was told.
  TeamStatistics of(Team team) const {
    return counter_.statistics().teams[index_of(view_.of(team))];
  }
  LegStatistics leg() const { return counter_.statistics(); }
  Team seen(Team team) const { return view_.of(team); }

 private:
  match::LoggedDecision decision(referee::Verdict verdict, referee::Law law, Team team) const {
    match::LoggedDecision d;
    d.decision.verdict = verdict;
    d.decision.law = law;
    d.team = view_.of(team);
    return d;
  }

  PlayTick next() {
    PlayTick t;
    t.tick = tick_++;
    const bool blue_is_left = view_.is_turned == view_.is_recoloured;
    t.left = blue_is_left ? Team::blue : Team::yellow;
    return t;
  }

  Vec2 turned(const Vec2& v) const { return view_.is_turned ? Vec2(-v) : v; }

  View view_;
  field::Field field_ = field::make_field(RobotLeague::small);
  Counter counter_;
  std::uint32_t tick_ = 0;
  Vec2 ball_{0.0, 0.0};
  ByTeam<referee::RobotSet> touched_{};
};

class Views : public testing::TestWithParam<View> {};
INSTANTIATE_TEST_SUITE_P(All, Views,
                         testing::Values(View{false, false}, View{true, false}, View{false, true},
                                         View{true, true}));

// Catches a pass that is counted for the wrong team, or twice, and a touch of a mate that loses the
// ball.
TEST_P(Views, ATouchByAMateIsAPass) {
  Play play(GetParam());
  play.touched_by(Team::blue, 1).tick({-0.3, 0.0}).tick({-0.1, 0.0});
  play.touched_by(Team::blue, 2).tick({0.1, 0.0}).rest(1.0);
  EXPECT_EQ(play.of(Team::blue).passes, 1);
  EXPECT_EQ(play.of(Team::blue).all_losses(), 0);
  EXPECT_EQ(play.of(Team::yellow).passes, 0);
  EXPECT_EQ(play.of(Team::yellow).interceptions, 0);
}

// Catches a mark that stands where the ball was later, is another team's, or does not tell what
// became of the shot: one wide, one saved, one that goes in after a save, one that is pushed in.
TEST_P(Views, AShotHasItsPlaceAndItsEnd) {
  Play play(GetParam());
  const Team blue = play.seen(Team::blue), yellow = play.seen(Team::yellow);
  play.touched_by(Team::blue, 1).tick({0.1, 0.2}, {1.0, 0.2}).tick({0.2, 0.25}, {1.0, 0.2});
  play.rest(1.0);
  play.touched_by(Team::blue, 2).tick({0.2, -0.1}, {1.0, 0.1}).tick({0.5, -0.05}, {1.0, 0.1});
  play.touched_by(Team::yellow, 0).tick({0.7, 0.0}).rest(1.0);
  play.touched_by(Team::yellow, 1).tick({-0.2, 0.3}, {-1.5, -0.9});
  play.touched_by(Team::blue, 0).tick({-0.6, 0.0}, {-0.2, 0.0});
  play.call(play.goal(Team::yellow, match::GoalKind::open_play)).wait();
  play.touched_by(Team::blue, 1).tick({0.7, 0.0}, {0.1, 0.0});
  play.call(play.goal(Team::blue, match::GoalKind::open_play));
  const std::vector<ShotMark> shots = play.leg().shots;
  ASSERT_EQ(shots.size(), 4u);
  const auto shot = [&](std::size_t i, Team team, Vec2 place, bool on_goal, bool is_goal) {
    return shots[i] == ShotMark{shots[i].tick, team, place, on_goal, is_goal};
  };
  EXPECT_TRUE(shot(0, blue, {0.1, 0.2}, false, false));
  EXPECT_EQ(shots[0].tick, 0u);
  EXPECT_TRUE(shot(1, blue, {0.2, -0.1}, true, false));
  EXPECT_TRUE(shot(2, yellow, {0.2, -0.3}, true, true));
  EXPECT_TRUE(shot(3, blue, {0.7, 0.0}, true, true));
}

// Catches dribbling that counts as passing, and two mates beside each other who pass in every tick.
TEST_P(Views, ATouchByTheSameRobotOrOfABallThatHardlyMovedIsNoPass) {
  Play play(GetParam());
  play.touched_by(Team::blue, 1).tick({-0.3, 0.0}).tick({-0.1, 0.0});
  play.touched_by(Team::blue, 1).tick({0.1, 0.0}).tick({0.15, 0.0});
  play.touched_by(Team::blue, 2).tick({0.2, 0.0});  // 0.1 m
  EXPECT_EQ(play.of(Team::blue).passes, 0);
}

// Catches a robot that hands the ball over without a flight, and a pass across a stoppage.
TEST_P(Views, ABallThatWasNotOnItsWayIsNoPass) {
  Play play(GetParam());
  play.touched_by(Team::blue, 1).tick({-0.3, 0.0});
  play.touched_by(Team::blue, 2).tick({0.0, 0.0});  // no tick without a touch
  EXPECT_EQ(play.of(Team::blue).passes, 0);
  play.call(play.foul(Team::yellow, referee::Law::push)).wait().tick({0.3, 0.0});
  play.touched_by(Team::blue, 1).tick({0.5, 0.0});
  EXPECT_EQ(play.of(Team::blue).passes, 0);
}

// Catches an interception without its loss, one in the wrong third, and one that is a pass, too.
TEST_P(Views, ATouchByAnOpponentIsAnInterception) {
  Play play(GetParam());
  play.touched_by(Team::blue, 1).tick({-0.6, 0.1}).tick({-0.3, 0.1});
  play.touched_by(Team::yellow, 2).tick({0.0, 0.1}).rest(1.0);
  const TeamStatistics blue = play.of(Team::blue);
  const TeamStatistics yellow = play.of(Team::yellow);
  EXPECT_EQ(yellow.interceptions, 1);
  EXPECT_EQ(yellow.saves, 0);
  EXPECT_EQ(blue.passes, 0);
  EXPECT_EQ(blue.losses[at(Third::own)], 1);
  EXPECT_EQ(blue.all_losses(), 1);
  EXPECT_EQ(yellow.all_losses(), 0);
}

// Catches a tackle that counts as an interception.
TEST_P(Views, ABallTakenFromARobotIsALossWithoutAnInterception) {
  Play play(GetParam());
  play.touched_by(Team::blue, 1).tick({0.0, 0.0});
  play.touched_by(Team::yellow, 2).tick({0.01, 0.0}).rest(1.0);
  EXPECT_EQ(play.of(Team::yellow).interceptions, 0);
  EXPECT_EQ(play.of(Team::blue).losses[at(Third::middle)], 1);
}

// Catches a shot that counts in every tick of its way, one that is an interception, too, and a save
// that is counted before it is one.
TEST_P(Views, AShotThatAnOpponentKeepsOutIsASave) {
  Play play(GetParam());
  play.touched_by(Team::blue, 1).tick({0.3, 0.0}, {1.0, 0.0});
  for (const double x : {0.4, 0.5, 0.6}) play.tick({x, 0.0}, {1.0, 0.0});
  play.touched_by(Team::yellow, 0).tick({0.68, 0.0}, {-0.5, 0.0}).rest(1.0);
  const TeamStatistics blue = play.of(Team::blue);
  EXPECT_EQ(blue.shots, 1);
  EXPECT_EQ(blue.shots_on_goal, 1);
  EXPECT_EQ(play.of(Team::yellow).saves, 1);
  EXPECT_EQ(play.of(Team::yellow).interceptions, 0);
  EXPECT_EQ(blue.all_losses(), 1);
  EXPECT_EQ(blue.all_goals(), 0);
}

// Catches a parry that goes in all the same and counts as a save, and a goal that is two shots.
TEST_P(Views, AShotThatGoesInIsNoSave) {
  Play play(GetParam());
  play.touched_by(Team::blue, 1).tick({0.4, 0.0}, {1.0, 0.0}).tick({0.6, 0.0}, {1.0, 0.0});
  play.touched_by(Team::yellow, 0).tick({0.7, 0.0}, {0.6, 0.0});
  play.call(play.goal(Team::blue, match::GoalKind::open_play));
  EXPECT_EQ(play.of(Team::yellow).saves, 0);
  EXPECT_EQ(play.of(Team::blue).shots, 1);
  EXPECT_EQ(play.of(Team::blue).shots_on_goal, 1);
  EXPECT_EQ(play.of(Team::blue).goals[at(GoalOrigin::open_play)], 1);
}

// Catches a slow ball, one from far away, one that rolls home and one far beside the goal that
// count; and one just beside it that does not.
TEST_P(Views, AShotIsFastNearAndTowardsTheGoal) {
  const auto shots = [](const Vec2& ball, const Vec2& velocity) {
    Play play(GetParam());
    play.touched_by(Team::blue, 1).tick(ball, velocity);
    EXPECT_EQ(play.of(Team::yellow).shots, 0);
    return std::pair(play.of(Team::blue).shots, play.of(Team::blue).shots_on_goal);
  };
  EXPECT_EQ(shots({0.5, 0.0}, {0.4, 0.0}), std::pair(0, 0)) << "slow";
  EXPECT_EQ(shots({-0.5, 0.0}, {1.0, 0.0}), std::pair(0, 0)) << "far away";
  EXPECT_EQ(shots({-0.5, 0.0}, {-1.0, 0.0}), std::pair(0, 0)) << "towards the own goal";
  EXPECT_EQ(shots({0.5, 0.6}, {1.0, 0.0}), std::pair(0, 0)) << "far beside";
  EXPECT_EQ(shots({0.5, 0.3}, {1.0, 0.0}), std::pair(1, 0)) << "just beside";
  EXPECT_EQ(shots({0.5, 0.3}, {1.0, -1.0}), std::pair(1, 1)) << "across, into the goal";
}

// Catches a shot that is counted again while it is on its way, and a second one that is not.
TEST_P(Views, AShotEndsHalfASecondAfterItsCourse) {
  Play play(GetParam());
  const auto shoot = [&] { play.touched_by(Team::blue, 1).tick({0.5, 0.0}, {1.0, 0.0}); };
  shoot();
  play.tick({0.5, 0.0});
  shoot();
  EXPECT_EQ(play.of(Team::blue).shots, 1);
  play.rest(0.6);
  shoot();
  EXPECT_EQ(play.of(Team::blue).shots, 2);
}

// Catches goals of which no shot is known, own goals that count as shots, and an own goal that is
// credited to the team that made it.
TEST_P(Views, EveryGoalButAnOwnGoalIsAShotOnGoal) {
  Play play(GetParam());
  play.touched_by(Team::blue, 1).tick({0.74, 0.0}, {0.1, 0.0});
  play.call(play.goal(Team::blue, match::GoalKind::kick_off)).wait();
  play.touched_by(Team::yellow, 1).tick({0.74, 0.0}, {0.1, 0.0});
  play.call(play.goal(Team::blue, match::GoalKind::open_play, true));
  const TeamStatistics blue = play.of(Team::blue);
  EXPECT_EQ(blue.shots, 1);
  EXPECT_EQ(blue.shots_on_goal, 1);
  EXPECT_EQ(blue.goals[at(GoalOrigin::kick_off)], 1);
  EXPECT_EQ(blue.goals[at(GoalOrigin::own_goal)], 1);
  EXPECT_EQ(play.of(Team::yellow).all_goals(), 0);
  EXPECT_EQ(play.of(Team::yellow).shots, 0);
}

// Catches a scrum that is many duels, one that nobody wins, and a duel won by who lost the ball.
TEST_P(Views, ADuelIsWonByWhoHasTheBallAfterIt) {
  Play play(GetParam());
  const auto contest = [&] {
    play.touched_by(Team::blue, 1).touched_by(Team::yellow, 1).tick({0.0, 0.0});
  };
  play.touched_by(Team::blue, 1).tick({0.0, 0.0});
  contest();
  contest();
  play.rest(0.2);
  contest();
  EXPECT_EQ(play.leg().duels, 1);
  play.touched_by(Team::yellow, 1).tick({0.0, 0.0}).rest(0.6);
  EXPECT_EQ(play.of(Team::yellow).duels_won, 1);
  EXPECT_EQ(play.of(Team::blue).duels_won, 0);
  contest();
  play.call(play.foul(Team::blue, referee::Law::push));
  EXPECT_EQ(play.leg().duels, 2) << "play stopped: no team won it";
  EXPECT_EQ(play.of(Team::yellow).duels_won + play.of(Team::blue).duels_won, 1);
}

// Catches possession before the first touch, during dead ball, and by the wrong team; and a contest
// that takes the ball away.
TEST_P(Views, PossessionBeginsWithATouchAndEndsWithOneOfTheOthers) {
  Play play(GetParam());
  play.tick({0.0, 0.0});
  play.touched_by(Team::blue, 0).tick({0.1, 0.0}).tick({0.1, 0.0});
  play.touched_by(Team::blue, 0).touched_by(Team::yellow, 0).tick({0.1, 0.0});
  play.touched_by(Team::yellow, 0).tick({-0.1, 0.0});
  play.call(play.foul(Team::blue, referee::Law::push)).wait().wait().tick({-0.1, 0.0});
  EXPECT_NEAR(play.of(Team::blue).possession_s, 3 * period, 1e-9);
  EXPECT_NEAR(play.of(Team::yellow).possession_s, 2 * period, 1e-9);
  EXPECT_NEAR(play.leg().play_s, 7 * period, 1e-9);
  EXPECT_NEAR(play.leg().dead_ball_s, 2 * period, 1e-9);
  EXPECT_NEAR(play.of(Team::blue).opponent_half_s, 3 * period, 1e-9);
  EXPECT_NEAR(play.of(Team::yellow).opponent_half_s, 3 * period, 1e-9);
  EXPECT_NEAR(play.of(Team::blue).distance_m, 0.06, 1e-9);
  EXPECT_EQ(play.leg().stoppages, 1);
}

// Catches a foul of the wrong team or law, and a note that stops nothing and counts.
TEST_P(Views, FoulsAreCountedByLaw) {
  Play play(GetParam());
  play.tick({0.0, 0.0}).call(play.foul(Team::yellow, referee::Law::holding)).wait();
  match::LoggedDecision note = play.foul(Team::yellow, referee::Law::collision);
  note.decision.verdict = referee::Verdict::NONE;
  note.decision.restart = referee::Restart::none;
  play.call(note);
  EXPECT_EQ(play.of(Team::yellow).fouls[at(referee::Law::holding)], 1);
  EXPECT_EQ(play.of(Team::yellow).all_fouls(), 1);
  EXPECT_EQ(play.of(Team::blue).all_fouls(), 0);
  ASSERT_EQ(play.leg().fouls.size(), 1u);
  EXPECT_EQ(play.leg().fouls[0].tick, 1u);
}

// Catches a goal with another restart, time or loss than those before it.
TEST_P(Views, AGoalTellsWhatCameBeforeIt) {
  Play play(GetParam());
  play.tick({0.0, 0.0}).call(play.foul(Team::blue, referee::Law::push)).wait();
  play.touched_by(Team::yellow, 1).tick({-0.3, 0.0}).tick({-0.4, 0.2});
  play.touched_by(Team::blue, 0).tick({-0.6, 0.2}).tick({-0.4, 0.2});  // tick 5
  play.touched_by(Team::yellow, 2).tick({-0.3, 0.2});                  // tick 7
  play.touched_by(Team::yellow, 2).tick({-0.74, 0.0});
  play.call(play.goal(Team::yellow, match::GoalKind::open_play));
  ASSERT_EQ(play.leg().goals.size(), 1u);
  const Goal goal = play.leg().goals[0];
  EXPECT_EQ(goal.team, play.seen(Team::yellow));
  EXPECT_EQ(goal.restart, referee::Restart::FREE_KICK);
  EXPECT_EQ(goal.restart_law, referee::Law::push);
  EXPECT_EQ(goal.taker, play.seen(Team::yellow));
  EXPECT_EQ(goal.tick, 9u);
  EXPECT_NEAR(goal.since_restart, 7 * period, 1e-6);
  ASSERT_TRUE(goal.loss);
  EXPECT_EQ(goal.loss->tick, 7u);
  EXPECT_EQ(goal.loss->kind, LossKind::interception);
  EXPECT_EQ(goal.loss->third, Third::own);
  EXPECT_EQ(goal.loss->place, (Vec2{-0.6, 0.2})) << "in the frame of the team that lost it";
}

// Catches attempts of a shoot-out that count as play.
TEST(Counter, LeavesOutAShootOut) {
  Counter counter(field::make_field(RobotLeague::small), period);
  PlayTick tick;
  tick.phase = referee::Phase::SHOOT_OUT;
  tick.ball_velocity = {2.0, 0.0};
  tick.touched[0].set(0);
  counter.add(tick);
  EXPECT_EQ(counter.statistics().teams[0], TeamStatistics{});
  EXPECT_EQ(counter.statistics().play_s, 0.0);
}

LegStatistics counted(match::Leg& leg) {
  auto blue = test_support::ball_hunter();
  auto yellow = test_support::random_team(5);
  LegCounter counter(leg);
  while (!leg.is_over()) {
    leg.advance(blue, yellow);
    counter.add(leg);
  }
  return counter.statistics();
}

// Sums hold in legs that are played. Catches numbers that are counted twice or by other rules than
// the referee's.
TEST(Counter, SumsHoldInLegsOfEveryLeague) {
  int goals = 0;
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle, RobotLeague::large}) {
    match::Setup setup = test_support::short_setup(7, 40.0, league);
    setup.rules.mercy_goal_diff = 0;
    match::Leg leg(setup);
    const LegStatistics s = counted(leg);
    EXPECT_NEAR(s.play_s + s.dead_ball_s, leg.tick() * setup.control_period, 1e-3);
    double possession = 0.0;
    int won = 0;
    for (const Team team : both_teams) {
      const TeamStatistics& own = s.teams[index_of(team)];
      const TeamStatistics& other = s.teams[index_of(opponent_of(team))];
      const int scored = own.all_goals() - own.goals[at(GoalOrigin::own_goal)];
      EXPECT_EQ(own.all_goals(), leg.outcome().played[index_of(team)]);
      EXPECT_GE(own.shots, own.shots_on_goal);
      EXPECT_GE(own.shots_on_goal, scored + other.saves);
      const auto marked = [&](const auto& marks, const auto& is_one) {
        return std::count_if(marks.begin(), marks.end(),
                             [&](const auto& mark) { return mark.team == team && is_one(mark); });
      };
      const auto any = [](const auto&) { return true; };
      EXPECT_EQ(marked(s.shots, any), own.shots);
      EXPECT_EQ(marked(s.shots, [](const ShotMark& shot) { return shot.on_goal; }),
                own.shots_on_goal);
      EXPECT_EQ(marked(s.shots, [](const ShotMark& shot) { return shot.is_goal; }), scored);
      EXPECT_EQ(marked(s.passes, any), own.passes);
      EXPECT_GE(other.all_losses(), own.interceptions);
      possession += own.possession_s;
      won += own.duels_won;
      goals += own.all_goals();
    }
    EXPECT_LE(possession, s.play_s + 1e-3);
    EXPECT_LE(won, s.duels);
    EXPECT_EQ(s.goals.size(),
              static_cast<std::size_t>(s.teams[0].all_goals() + s.teams[1].all_goals()));
    EXPECT_EQ(s.fouls.size(),
              static_cast<std::size_t>(s.teams[0].all_fouls() + s.teams[1].all_fouls()));
  }
  EXPECT_GT(goals, 0) << "otherwise little is tested";
}

}  // namespace
}  // namespace mirocup::statistics
