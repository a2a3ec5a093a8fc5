// SPDX-License-Identifier: MIT
//
// Small facts about worlds; whole scenes are in tests/scenes.
#include "core/simulator/world.hpp"

#include "tests/support/exact_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirocup::simulator {
namespace {

// Everything is followed, however long it takes.
Tolerances patient() {
  Tolerances tolerances;
  tolerances.event_budget = 1'000'000;
  return tolerances;
}

// The sharper a turn changes, the slower its series converge. Catches a segment that is longer than
// its series are good for.
TEST(World, RobotsAreExactWhenTheirTurnIsReversed) {
  Parameters parameters;
  parameters.grip = infinite_grip;
  for (const double turn : {8.0, 20.0, 50.0}) {
    const BodyState start{{0.0, 0.0}, {}, {1.0, 0.0, turn}};
    const double u = -turn * parameters.wheel_distance / (2.0 * parameters.wheel_radius);
    const WheelCommand reversed = WheelSpeeds{-u, u};
    World world(nullptr, parameters, Tolerances{}, 1, false);
    world.set_robot(0, start);
    world.advance({&reversed, 1}, 0.033);
    const BodyState exact = test_support::rounded(
        test_support::drive_exactly(parameters, test_support::exactly(start), reversed, 0.033L));
    EXPECT_LE((world.robot(0).position - exact.position).norm(), 1e-12) << turn;
    EXPECT_NEAR(world.robot(0).heading.sin, exact.heading.sin, 1e-12) << turn;
  }
}

// WheelState of infinite grip hold nothing while they are off the ground; put down, they hold at once.
TEST(World, LiftedRobotsSlideWhateverTheGrip) {
  Parameters parameters;
  parameters.grip = infinite_grip;
  World world(nullptr, parameters, Tolerances{}, 1, false);
  world.set_robot(0, {{0.0, 0.0}, {}, {0.0, 0.5, 0.0}});
  const WheelCommand lifted;
  world.advance({&lifted, 1}, 0.1);
  EXPECT_NEAR(world.robot(0).position.y(), 0.05, 1e-15);
  EXPECT_EQ(world.robot(0).twist.left, 0.5);
  const WheelCommand standing = WheelSpeeds{};
  world.advance({&standing, 1}, 0.1);
  EXPECT_NEAR(world.robot(0).position.y(), 0.05, 1e-15);
  EXPECT_EQ(world.robot(0).twist.left, 0.0);
}

// Catches a rebound that is taken for rest because it is slow.
TEST(World, SlowReboundsAreRebounds) {
  const field::Field field = field::make_field(League::small);
  Parameters parameters;
  parameters.restitution.ball_wall = 1e-4;
  parameters.rolling_resistance = 0.0;
  parameters.viscous_friction = 0.0;
  World world(&field, parameters, Tolerances{}, 0, true);
  for (const double side : {-1.0, 1.0}) {
    world.set_ball({{0.0, side * (field.half_width - 0.05)}, {0.0, side * 1.0}});
    EXPECT_EQ(world.advance({}, 0.033).impacts, 1);
    EXPECT_NEAR(world.ball().velocity.y(), -side * 1e-4, 1e-12);
  }
}

// Mirror images that press a ball between them: what rounding leaves sideways grows with each term
// of the ball's series from its turning point on. Catches a curve that is as long as it stays small.
TEST(World, ASymmetricPinchStaysSymmetric) {
  Parameters parameters;
  parameters.restitution.ball_robot = 0.10662284917722653;
  World world(nullptr, parameters, Tolerances{}, 2, true);
  const Heading heading = Heading::from_angle(-0.20089410070816699);
  world.set_robot(
      0, {{0.0, 0.067858439702832701}, heading, {0.15426211078335478, 0.0, -1.5341704755924441}});
  world.set_robot(1, {{0.0, -0.067858439702832701},
                      {heading.cos, -heading.sin},
                      {0.15426211078335478, 0.0, 1.5341704755924441}});
  world.set_ball({{-0.2, 0.0}, {3.8793614464732951, 0.0}});
  const std::array<WheelCommand, 2> commands{WheelSpeeds{34.604004210975262, -22.411810073882403},
                                             WheelSpeeds{-22.411810073882403, 34.604004210975262}};
  for (int tick = 0; tick < 5; ++tick) {
    world.advance(commands, 0.033);
    EXPECT_NEAR(world.ball().position.y(), 0.0, 1e-10) << tick;
    EXPECT_NEAR(world.robot(0).heading.sin, -world.robot(1).heading.sin, 1e-9) << tick;
  }
}

// A goal post's corner in a robot's side: the post is the point's side of that contact, and no
// body. Catches a correction that moves "body -1", which is the memory before the bodies.
TEST(World, PostsPushRobotsOutAndNothingElse) {
  const field::Field field = field::make_field(League::small);
  const Parameters parameters;
  World world(&field, parameters, Tolerances{}, 1, false);
  const double overlap = 1e-6;
  const double diagonal = std::sqrt(0.5);
  const Vec2 outwards{-diagonal, -diagonal};
  const Vec2 post{field.half_length, field.goal_half_width};
  const double reach = parameters.robot_side / 2.0 - overlap;
  const BodyState start{post + reach * outwards, {diagonal, diagonal}, {}};
  world.set_robot(0, start);
  const solver::InverseMass before = world.static_world().grounded_robot;
  const WheelCommand standing = WheelSpeeds{};
  world.advance({&standing, 1}, 0.033);
  EXPECT_NEAR(outwards.dot(world.robot(0).position - start.position), overlap, 1e-9);
  EXPECT_EQ(world.static_world().grounded_robot.forward, before.forward);
  EXPECT_EQ(world.static_world().grounded_robot.left, before.left);
  EXPECT_EQ(world.static_world().grounded_robot.omega, before.omega);
}

// WheelState that are stopped push others that stand, these slide, stop and push back, ever less.
TEST(World, SlidesOfACrowdAreStoppedTogether) {
  const field::Field field = field::make_field(League::large);
  World world(&field, Parameters{}, Tolerances{}, 9, false);
  world.set_robot(0, {{0x1.f666666666667p+0, 0x1.4acd29693ca5dp+0},
                      {0x1.1dfeb78f6b579p-49, 0x1p+0},
                      {0x1.27dc779bfbbc3p-60, 0x0p+0, 0x1.219a344ccffd8p-59}});
  world.set_robot(1, {{0x1.d70286a5f89bdp+0, 0x1.2d9a75af259bp+0},
                      {0x1.57241af92ed9ep-1, 0x1.7bff6748dd1cep-1},
                      {-0x1.ac24c11a4d2edp-9, 0x1.af58dda2aa9cfp-17, 0x1.70e4d58a2164dp-4}});
  world.set_robot(2, {{0x1.e52421c7979cdp+0, 0x1.3b47937d0adfbp+0},
                      {-0x1.6a96aea0e5e73p-1, 0x1.697ce75b17afap-1},
                      {0x1.84875233b83f8p-9, -0x1.690e0738fa71p-14, -0x1.116347a2c63e2p-8}});
  world.set_robot(3, {{0x1.d6ea2c9b0b01cp+0, 0x1.483443280dd1ap+0},
                      {-0x1.6a96aea0e5e78p-1, 0x1.697ce75b17af6p-1},
                      {0x1.866eb14e8b056p-9, 0x1.a0ed7c82459c2p-14, -0x1.116347a2c6415p-8}});
  world.set_robot(4, {{0x1.e3f12b9600772p+0, 0x1.5bd49eece99d2p+0},
                      {0x1.fd13da408c588p-1, -0x1.b502f8764206p-4},
                      {-0x1.a05dabc936baep-59, 0x0p+0, 0x1.db2b7754a0919p-55}});
  world.set_robot(5, {{0x1.b5320fe86c4b4p+0, 0x1.5ccccccccccccp+0},
                      {0x1.4327ec40b1569p-51, 0x1p+0},
                      {-0x1.73a56bcb1d1c7p-59, 0x1.0d2dda32bd9d2p-8, 0x1.8e5309799b088p-55}});
  world.set_robot(6, {{0x1.cc5f3ab8590c8p+0, 0x1.58d2d530133ecp+0},
                      {-0x1.6a96aea0e5e78p-1, 0x1.697ce75b17af6p-1},
                      {0x1.7d3151a64416dp-9, 0x1.7c1904613f66ap-9, -0x1.116347a2c64p-8}});
  world.set_robot(7, {{0x1.b8f91d4978946p+0, 0x1.45a43559eae7fp+0},
                      {0x1.56fb778963664p-1, 0x1.7c2415bb0199bp-1},
                      {-0x1.b57347e61bfecp-10, 0x1.642c866246cb6p-9, 0x1.b57b4c23105f8p-3}});
  world.set_robot(8, {{0x1.b8262d3d4a6dfp+0, 0x1.2c889e4401689p+0},
                      {0x1.569c7f0497fcp-1, 0x1.7c79b034c2bdcp-1},
                      {0x1.3816aee5da206p-3, 0x0p+0, 0x1.6aa7c80dcc672p+2}});
  const std::array<WheelCommand, 9> commands{
      WheelSpeeds{0x1.cb7a1ef453207p+4, 0x1.8c68b16cb4fdap+3},
      WheelSpeeds{-0x1.36afcb9d47e2p+0, 0x1.22bf75b938075p+5},
      WheelSpeeds{0x1.30aecb2b74dep+5, -0x1.02f3201d6950fp+4},
      WheelSpeeds{0x1.534a6c1828096p+6, -0x1.ed79727bd1aa8p+2},
      WheelSpeeds{0x1.2dc104beb6204p+4, 0x1.66bf712f59d3p+4},
      WheelSpeeds{0x1.e89b81af98638p+3, -0x1.94c61ab49984p+1},
      WheelSpeeds{0x1.4853c6e606baap+6, 0x1.fca55462c1ab2p+4},
      WheelSpeeds{0x1.cad8e0280effp+5, 0x1.2ce0b1fd66a2ap+6},
      WheelSpeeds{0x1.033929f45ed6cp+6, 0x1.eef21471f2117p+4}};
  for (int tick = 0; tick < 3; ++tick) {
    EXPECT_LE(world.advance(commands, 0.033).events, 80) << tick;
  }
}

// Three robots and the ball wedged between two walls, found in a long scrum: what little is left of
// speeds is rounding. Catches wheels that are decided to slide one way and then pulled the other,
// again and again at one instant, until the tick has to go on in small steps.
TEST(World, AWedgeAtRestIsNotFollowedForEver) {
  const field::Field field = field::make_field(League::small);
  World world(&field, Parameters{}, patient(), 3, true);
  world.set_robot(0, {{-0x1.9ffff2841aa0ap-1, 0x1.6f00baf7bdd15p-5},
                      {-0x1.ffffffff81bcap-1, 0x1.67930d873ec06p-17},
                      {0x1.076f56eaa11ap-34, 0.0, 0x1.b70f109226337p-30}});
  world.set_robot(1, {{-0x1.8c85a6ea4f122p-1, 0x1.eab323409c43dp-4},
                      {-0x1.ffffffff81bc4p-1, 0x1.6793843427096p-17},
                      {0x1.beb4543b6db5dp-4, -0x1.035f016b27c3bp-34, -0x1.d515dc41c0ca9p-30}});
  world.set_robot(2, {{-0x1.79998c1dbdb27p-1, 0x1.6eff0b7a32268p-5},
                      {-0x1.ffffffff81bcap-1, 0x1.67930d8735cecp-17},
                      {0x1.076f17d1c63f6p-34, 0.0, 0x1.b70f546a7866fp-30}});
  world.set_ball({{-0x1.98b12a2aedfc6p-1, 0x1.6de00d1b71759p-3},
                  {0x1.37ac2794a5b5fp-17, 0x1.315ef22e07964p-60}});
  const std::array<WheelCommand, 3> commands{
      WheelSpeeds{0x1.e1e7576053341p+5, -0x1.f0255b0cb35cp-1},
      WheelSpeeds{0x1.9e1d62e49c9bcp+4, -0x1.eb68a16e662cp+3},
      WheelSpeeds{0x1.6f537cc77144cp+5, 0x1.1b2427f7c1168p+3}};
  for (int tick = 0; tick < 4; ++tick) {
    const TickEvents& events = world.advance(commands, 0.033);
    EXPECT_LE(events.events, 40) << tick;
    EXPECT_FALSE(events.stepped) << tick;
  }
}

// Fifteen robots wedged in a corner of the large field, and the ball at rest between them, found in a
// crowd of 22. Catches velocities that are fitted to a heap, contradict each other by 5e-10 m/s, and
// set the ball going: it stopped within 7 ns, and so on until the tick went on in small steps.
TEST(World, ABallAtRestInAHeapStaysAtRest) {
  const field::Field field = field::make_field(League::large);
  World world(&field, Parameters{}, patient(), 15, true);
  world.set_robot(0, {{0x1.0e66663e8ac9ap+1, 0x1.1de6960e07f6fp-4},
                      {-0x1.09b8197ec0727p-21, 0x1.ffffffffffbb1p-1},
                      {-0x1.fd0611d5402bap-31, 0x0p+0, -0x1.be16553ccf239p-47}});
  world.set_robot(1, {{0x1.f32af6ab5da59p+0, 0x1.196be3c9e792p-2},
                      {0x1.bfeed157f028ep-2, -0x1.cc6a88f5dacabp-1},
                      {-0x1.f336711a31c6ap-6, -0x1.a736122f7f54ap-8, 0x1.1add84274ce26p+0}});
  world.set_robot(2, {{0x1.e1f2127764dap+0, 0x1.eef08c2b1bfccp-3},
                      {0x1.bfeed157f027bp-2, -0x1.cc6a88f5dacaep-1},
                      {0x1.1314cb2890b11p-4, -0x1.8b29f1385a44bp-8, 0x1.1add84274ce25p+0}});
  world.set_robot(3, {{0x1.f8561e714f3ddp+0, 0x1.9b43fdabdcc9fp-3},
                      {0x1.cc6a88f5dacafp-1, 0x1.bfeed157f027cp-2},
                      {0x1.395dc53d047d8p-7, 0x0p+0, 0x1.1add84274ce6ep+0}});
  world.set_robot(4, {{0x1.e7121fb4e3d69p+0, 0x1.58135e45125ebp-3},
                      {0x1.cc6a88f5dacaep-1, 0x1.bfeed157f027bp-2},
                      {0x1.395dc53d046d4p-7, -0x1.5370382f290a1p-4, 0x1.1add84274ce24p+0}});
  world.set_robot(5, {{0x1.e333333333334p+0, 0x1.5fc0bd5f9042bp-2},
                      {0x1p+0, 0x1.7ea5009075e45p-48},
                      {-0x1.55e4e423c8a6dp-59, 0x0p+0, -0x1.7251235162c4ep-53}});
  world.set_robot(6, {{0x1.0e66666666666p+1, 0x1.c226809d49519p-3},
                      {0x1p+0, -0x1.611188bb8375cp-50},
                      {0x1.1d0b29af3ad35p-56, 0x0p+0, -0x1.e47a08191164bp-52}});
  world.set_robot(7, {{0x1.f078c1cdc1c97p+0, 0x1.a3b39c45b7bb2p-4},
                      {-0x1.bfeed157f0283p-2, 0x1.cc6a88f5dacaep-1},
                      {-0x1.3fbc64738e7cap-4, 0x1.8316cae13fbf7p-5, 0x1.1add84274ce11p+0}});
  world.set_robot(8, {{0x1.03dae131d48a1p+1, 0x1.182b05fd5d223p-3},
                      {0x1.f823254c188f3p-1, 0x1.6589c362258cbp-3},
                      {0x1.cd6bd21f51da8p-9, 0x0p+0, -0x1.778e41c61e6a7p-5}});
  world.set_robot(9, {{0x1.0dd968f32ca9bp+1, -0x1.4e6d6cb523d65p-4},
                      {-0x1.3852e883a121ep-5, 0x1.ffa0b495557f6p-1},
                      {-0x1.349c35e459d27p-10, 0x0p+0, 0x1.f2b396a1ee9f6p-6}});
  world.set_robot(10, {{0x1.ce8794214ffa4p+0, 0x1.279c6c7fd6606p-2},
                       {0x1.b34522788dcb6p-1, -0x1.0d9983641c431p-1},
                       {0x1.102e9fc993816p-4, 0x0p+0, -0x1.c8cb0f91cd08cp-55}});
  world.set_robot(11, {{0x1.0dbf6b7efc7edp+1, -0x1.40fcc983791e7p-3},
                       {-0x1.3852e883a121ep-5, 0x1.ffa0b495557f6p-1},
                       {-0x1.51c6a9c8b706cp-10, 0x0p+0, 0x1.f2b396a1eea3p-6}});
  world.set_robot(12, {{0x1.0e3309eff3711p+1, 0x1.288ce48614c15p-3},
                       {0x1.ffffffffffbb1p-1, 0x1.09ab40598fdd4p-21},
                       {0x1.ea67bede5e47ep-10, 0x0p+0, -0x1.a81b442c18723p-26}});
  world.set_robot(13, {{0x1.0dd117244934ap+1, -0x1.b0b29e5848556p-8},
                       {0x1.3852e883a121ep-5, -0x1.ffa0b495557f6p-1},
                       {0x1.1fce18a05b123p-10, 0x0p+0, 0x1.f2b396a1eea22p-6}});
  world.set_robot(14, {{0x1.f666666666667p+0, 0x1.74ab64e2cc67fp-2},
                       {0x1p+0, 0x1.28cbae72e6577p-49},
                       {-0x1.5617bded02408p-59, 0x0p+0, -0x1.c7fd85c7a64c3p-53}});
  world.set_ball({{0x1.1056dc7378b31p+1, 0x1.1d566cf41f213p-2}, {0x1.03cd3875bf0dfp-54, 0x0p+0}});
  const std::array<WheelCommand, 15> commands{
      WheelSpeeds{-0x1.c8d7fda433648p+1, -0x1.776342c556cf3p+4},
      WheelSpeeds{0x1.f047eb9a449ebp+4, 0x1.dbdd9c4eb12eap+5},
      WheelSpeeds{0x1.701d56c0beb92p+5, 0x1.15d50f2d07109p+6},
      WheelSpeeds{-0x1.8df65111f7795p+3, 0x1.1bc3f27d615fp+4},
      WheelSpeeds{0x1.56382851a076cp+5, 0x1.9df3d7253f2f1p+4},
      WheelSpeeds{0x1.bd8689e91b5aap+5, 0x1.d6c9584bd4744p+4},
      WheelSpeeds{0x1.c6c2ad1b4ddeep+5, 0x1.206e005f7f9c3p+6},
      WheelSpeeds{0x1.2c0a4f054749ap+5, 0x1.10d7facb5b7dcp+5},
      WheelSpeeds{-0x1.bc8d92c7e8ebp+2, 0x1.48e6195d14754p+4},
      WheelSpeeds{0x1.41739e196933p+0, 0x1.2a9e1df194fap+5},
      WheelSpeeds{0x1.c864800024034p+4, 0x1.1daaee8e55be3p+6},
      WheelSpeeds{0x1.f2141123ffeap+5, 0x1.0da6ff100e57p+6},
      WheelSpeeds{-0x1.0c0c7a3b79f84p+4, -0x1.55eb3bd42b3a4p+3},
      WheelSpeeds{0x1.5e6ddedd18144p+3, 0x1.99152958be358p+6},
      WheelSpeeds{-0x1.b5ad3ce17442p-1, 0x1.42ca9972f9ed9p+4}};
  EXPECT_LE(world.advance(commands, 0.033).events, 120);
}

}  // namespace
}  // namespace mirocup::simulator
