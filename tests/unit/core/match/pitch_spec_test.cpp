// SPDX-License-Identifier: MIT
#include "core/match/pitch_spec.hpp"

#include "core/match/leg.hpp"

#include <gtest/gtest.h>

namespace mirocup::match {
namespace {

// Catches a preset on which a leg cannot be played, and one that changes the default pitch.
TEST(PitchSpec, PresetsPlayLegs) {
  EXPECT_EQ(pitch_of(PitchPreset::mirosot).parameters.wheel_radius, 0.0225);
  for (const PitchPreset preset :
       {PitchPreset::mirosot, PitchPreset::vsss, PitchPreset::simurosot}) {
    match::Setup setup;  // a test has a member of that name
    setup.league = preset == PitchPreset::simurosot ? RobotLeague::middle : RobotLeague::small;
    setup.rules.half_s = 5.0;
    set_pitch(setup, pitch_of(preset));
    EXPECT_EQ(problem_with(setup.parameters), "");
    Leg leg(setup);
    Command command;
    command.wheels.fill({40.0, 35.0});
    while (!leg.is_over()) leg.advance({Answer(command), Answer(command)});
    EXPECT_EQ(leg.outcome().kind, OutcomeKind::full_time);
  }
}

}  // namespace
}  // namespace mirocup::match
