// SPDX-License-Identifier: MIT
#include "mirocup/skills/filter.hpp"

#include "core/base/random.hpp"
#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// What a camera with these properties shows of a field, without losses.
Observation picture_of(const SkillField& field, std::uint32_t tick, int age,
                       mirocup::Random& random) {
  const auto noise = [&] { return 0.0015 * std::sqrt(3.0) * random.uniform(-1.0, 1.0); };
  Observation seen = field.observation();
  seen.tick = tick;
  seen.ball_x += noise();
  seen.ball_y += noise();
  seen.own[0].x += noise();
  seen.own[0].y += noise();
  seen.ball_age_ticks = seen.own_age_ticks[0] = seen.opponent_age_ticks[0] = age;
  return seen;
}

// A camera that shows every picture one tick late, and a field under a given command.
class Late {
 public:
  explicit Late(SkillField& field) : field_(field) {}

  // Returns what is seen in the next tick, after the field moved under the answer given before.
  Observation next(Wheels answer) {
    if (tick_ > 0) field_.tick(in_flight_);
    in_flight_ = answer;
    const Observation taken = picture_of(field_, tick_, 1, random_);
    Observation shown = tick_ == 0 ? taken : before_;
    if (tick_ > 0) {  // velocities are differences of pictures
      shown.ball_vx = (before_.ball_x - earlier_.ball_x) / 0.033;
      shown.ball_vy = (before_.ball_y - earlier_.ball_y) / 0.033;
    }
    shown.tick = tick_++;
    earlier_ = tick_ > 1 ? before_ : taken;
    before_ = taken;
    return shown;
  }

 private:
  SkillField& field_;
  mirocup::Random random_{7};
  std::uint32_t tick_ = 0;
  Wheels in_flight_{};
  Observation before_{}, earlier_{};
};

// Catches a filter that lags behind: a ball that rolls freely is known ever better, to less than
// the noise of one picture and a tenth of the noise of a difference, two ticks later.
TEST(Filter, KnowsARollingBallBetterThanEachPicture) {
  SkillField field;
  field.put_robot({-0.6, -0.5}, 0.0);
  field.put_ball({-0.5, 0.1}, {0.9, 0.2});
  Late late(field);
  Filter filter(field.setup());
  for (int tick = 0; tick < 20; ++tick) {
    const Observation now = filter.see(late.next({}), 0);
    filter.sent({});
    if (tick < 12) continue;
    EXPECT_LT(length(ball(now) - field.ball()), 0.003) << tick;
    EXPECT_LT(length(ball_velocity(now) - field.ball_velocity()), 0.02) << tick;
  }
}

// Catches a filter that believes its prediction after a kick: two pictures later it has the new
// velocity.
TEST(Filter, FollowsAKick) {
  SkillField field;
  field.put_robot({-0.6, -0.5}, 0.0);
  field.put_ball({0.0, 0.0}, {0.5, 0.0});
  Late late(field);
  Filter filter(field.setup());
  for (int tick = 0; tick < 10; ++tick) filter.see(late.next({}));
  field.put_ball(field.ball(), {-0.5, 0.8});
  Observation now{};
  for (int tick = 0; tick < 4; ++tick) now = filter.see(late.next({}), 0);
  EXPECT_LT(length(ball(now) - field.ball()), 0.02);
  EXPECT_LT(length(ball_velocity(now) - field.ball_velocity()), 0.15);
}

// Catches a prediction without the commands in flight: a robot that starts is seen standing for two
// more ticks.
TEST(Filter, KnowsWhatItsRobotsWereTold) {
  SkillField field;
  field.put_robot({-0.5, 0.2}, 0.3);
  field.put_ball({0.5, 0.5});
  Late late(field);
  Filter filter(field.setup());
  Command command{};
  double raw = 0.0;
  for (int tick = 0; tick < 16; ++tick) {
    const Observation seen = late.next(command.wheels[0]);
    const Observation now = filter.see(seen, 0);
    command.wheels[0] = tick < 4 ? Wheels{} : Wheels{40.0 + tick, 35.0};
    filter.sent(command);
    if (tick < 6) continue;
    EXPECT_LT(length(position(now.own[0]) - position(field.robot())), 0.006) << tick;
    raw = std::max(raw, length(position(seen.own[0]) - position(field.robot())));
  }
  EXPECT_GT(raw, 0.03) << "what is seen";
}

// Catches a filter that stops where its pictures stop.
TEST(Filter, PredictsABodyThatIsNotSeen) {
  SkillField field;
  field.put_robot({-0.6, -0.5}, 0.0);
  field.put_ball({-0.5, 0.1}, {1.0, 0.0});
  Late late(field);
  Filter filter(field.setup());
  Observation last{};
  for (int tick = 0; tick < 18; ++tick) {
    Observation seen = late.next({});
    if (tick < 14) {
      last = seen;
    } else {  // held, and older in each tick
      seen.ball_x = last.ball_x;
      seen.ball_y = last.ball_y;
      seen.ball_vx = last.ball_vx;
      seen.ball_vy = last.ball_vy;
      seen.ball_age_ticks = 1 + tick - 13;
    }
    const Observation now = filter.see(seen, 0);
    if (tick <= 12) continue;
    EXPECT_LT(length(ball(now) - field.ball()), 0.006) << tick;
  }
}

// Catches a filter that blurs what is exact.
TEST(Filter, TakesWhatIsNotLateAsItIs) {
  const SkillField field;
  Filter filter(field.setup());
  for (std::uint32_t tick = 0; tick < 5; ++tick) {
    Observation seen = field.observation();
    seen.tick = tick;
    seen.ball_x = 0.1 * tick * tick;
    seen.own[0].x = -0.1 * tick;
    const Observation now = filter.see(seen, 0);
    EXPECT_EQ(now.ball_x, seen.ball_x);
    EXPECT_EQ(now.own[0].x, seen.own[0].x);
  }
}

}  // namespace
}  // namespace mirocup::strategy
