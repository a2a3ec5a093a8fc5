// SPDX-License-Identifier: MIT
#include "record/conditions_json.hpp"

#include "core/base/math.hpp"
#include "record/json_fields.hpp"

#include <optional>

namespace mirocup::record {

namespace {

using match::Conditions;
using match::ConditionsPreset;
using Json = nlohmann::ordered_json;

// The largest values that still are disturbances. A draw is at most two sigma, so no wheel turns
// backwards and no floor drives the ball.
constexpr double max_length = 0.1;
constexpr double max_angle = pi / 2.0;
constexpr double max_share = 0.25;
constexpr double max_unseen_ticks = 1000.0;

// Calls visit(name, member, largest value) for every value, in the order of match::Conditions.
template <class C, class Visit>
void for_each_value(C& c, Visit visit) {
  visit("place_sigma_m", c.place_sigma_m, max_length);
  visit("place_sigma_rad", c.place_sigma_rad, max_angle);
  visit("wheel_gain_sigma", c.wheel_gain_sigma, max_share);
  visit("wheel_jitter_sigma", c.wheel_jitter_sigma, max_share);
  visit("rolling_sigma", c.rolling_sigma, max_share);
  visit("see_sigma_m", c.see_sigma_m, max_length);
  visit("see_sigma_rad", c.see_sigma_rad, max_angle);
  visit("delay_ticks", c.delay_ticks, match::max_delay_ticks);
  visit("unseen_rate", c.unseen_rate, 1.0);
  visit("unseen_mean_ticks", c.unseen_mean_ticks, max_unseen_ticks);
  visit("radio_loss", c.radio_loss, 1.0);
}

void read_values(const JsonReader& json, Conditions& conditions) {
  read_named_members(
      json, conditions, "condition", [](auto& c, auto visit) { for_each_value(c, visit); },
      [](const JsonReader& value, auto& member, auto max) {
        FieldReader::read(value, member, decltype(max){0}, max);
      });
}

}  // namespace

Json to_json(const Conditions& conditions) {
  Json object{{"preset", to_string(conditions.preset)}};
  for_each_value(conditions,
                 [&](const char* name, const auto& value, auto) { object[name] = value; });
  return object;
}

Conditions read_conditions(const JsonReader& json) {
  if (json.is_string()) return match::conditions_of(json.name<ConditionsPreset>());
  auto preset = match::default_preset;
  if (json.expect_object()) json.read_if_present("preset", preset);
  Conditions conditions = match::conditions_of(preset);
  read_values(json, conditions);
  return conditions;
}

Result<Conditions> conditions_with_changes(ConditionsPreset preset,
                                           const std::vector<std::string>& changes) {
  MIROCUP_TRY(const auto object,
              with_changes({{"preset", to_string(preset)}}, changes, "--condition"));
  std::optional<JsonProblem> problem;
  const Conditions conditions = read_conditions(JsonReader(object, "/conditions", problem));
  if (problem) return fail(Errc::input, problem->pointer + ": " + problem->reason);
  return conditions;
}

}  // namespace mirocup::record
