// SPDX-License-Identifier: MIT
//
// Catches a Welcome that a team reads other numbers from than the server wrote, and a briefing
// whose pointers lead out of the object that owns it.
#include "server/dds/convert.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace mirocup::dds {
namespace {

static_assert(!std::is_copy_constructible_v<OwnedBriefing> &&
                  !std::is_copy_assignable_v<OwnedBriefing>,
              "a copy would point into the original");
static_assert(!std::is_move_constructible_v<OwnedBriefing> &&
              !std::is_move_assignable_v<OwnedBriefing>);

mirocup_v1_Welcome some_welcome() {
  const field::Field field = field::make_field(RobotLeague::middle);
  simulator::Parameters parameters;
  parameters.grip = 0.625;
  referee::Rules rules;
  rules.half_s = 123.0;
  const match::Briefing briefing{.field = &field,
                                 .parameters = &parameters,
                                 .rules = &rules,
                                 .control_period = 0.033,
                                 .team = Team::yellow,
                                 .seed = 77};
  return to_sample(briefing, 5, 6);
}

TEST(OwnedBriefing, HasTheNumbersOfTheWelcomeAndPointsIntoItself) {
  OwnedBriefing owned;
  ASSERT_TRUE(from_sample(some_welcome(), owned));
  EXPECT_EQ(owned.briefing.field, &owned.field);
  EXPECT_EQ(owned.briefing.parameters, &owned.parameters);
  EXPECT_EQ(owned.briefing.rules, &owned.rules);
  EXPECT_EQ(owned.field.league, RobotLeague::middle);
  EXPECT_EQ(owned.parameters.grip, 0.625);
  EXPECT_EQ(owned.rules.half_s, 123.0);
  EXPECT_EQ(owned.briefing.control_period, 0.033);
  EXPECT_EQ(owned.briefing.team, Team::yellow);
  EXPECT_EQ(owned.briefing.seed, 77U);
}

TEST(OwnedBriefing, IsLeftAloneByAWelcomeWithAnUnknownLeagueOrColour) {
  OwnedBriefing owned;
  mirocup_v1_Welcome welcome = some_welcome();
  welcome.facts.league = static_cast<std::uint8_t>(3);
  EXPECT_FALSE(from_sample(welcome, owned));
  welcome = some_welcome();
  welcome.team = mirocup_v1_COLOUR_NEITHER;
  EXPECT_FALSE(from_sample(welcome, owned));
  EXPECT_EQ(owned.briefing.field, nullptr);
}

}  // namespace
}  // namespace mirocup::dds
