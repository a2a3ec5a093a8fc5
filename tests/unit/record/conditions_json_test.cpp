// SPDX-License-Identifier: MIT
//
// Catches a value that is written but not read, a preset that is not the start of its changes, and
// a number out of its range that is taken.
#include "record/conditions_json.hpp"

#include "record/json_reader.hpp"
#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace mirocup::record {
namespace {

using match::Conditions;
using match::conditions_of;
using match::ConditionsPreset;
using Json = nlohmann::ordered_json;

std::string error_of(const std::string& change) {
  return test_support::why_not(conditions_with_changes(ConditionsPreset::hall, {change}));
}

TEST(ConditionsJson, EveryValueIsReadAsItWasWritten) {
  for (const auto preset :
       {ConditionsPreset::exact, ConditionsPreset::hall, ConditionsPreset::camera}) {
    std::optional<JsonProblem> problem;
    const Json json = to_json(conditions_of(preset));
    EXPECT_EQ(read_conditions(JsonReader(json, "", problem)), conditions_of(preset));
    EXPECT_FALSE(problem);
    const Json name = to_string(preset);
    EXPECT_EQ(read_conditions(JsonReader(name, "", problem)), conditions_of(preset));
  }
}

TEST(ConditionsJson, ChangesStartFromThePreset) {
  Conditions expected = conditions_of(ConditionsPreset::camera);
  expected.delay_ticks = 3;
  expected.radio_loss = 0.0;
  const auto changed =
      conditions_with_changes(ConditionsPreset::camera, {"delay_ticks=3", "radio_loss=0"});
  ASSERT_TRUE(test_support::is_ok(changed));
  EXPECT_EQ(*changed, expected);
}

TEST(ConditionsJson, AnErrorNamesTheKeyAndTheReason) {
  EXPECT_EQ(error_of("wind=1"), "/conditions/wind: there is no such condition");
  EXPECT_EQ(error_of("delay_ticks=9"), "/conditions/delay_ticks: 9 is not at most 8");
  EXPECT_EQ(error_of("place_sigma_m=-1"), "/conditions/place_sigma_m: -1 is not at least 0");
  EXPECT_EQ(error_of("place_sigma_m"), "--condition place_sigma_m: KEY=VALUE is expected");
}

}  // namespace
}  // namespace mirocup::record
