// SPDX-License-Identifier: MIT
#include "server/record/rules_json.hpp"

#include <cmath>
#include <string>

namespace mirocup::record {

namespace {

using referee::Rules;
using Json = nlohmann::ordered_json;

// Calls visit(name, member) for every parameter, in the order of the header.
template <class R, class Visit>
void for_each_parameter(R& rules, Visit visit) {
  visit("half_s", rules.half_s);
  visit("mercy_goal_difference", rules.mercy_goal_difference);
  visit("stalemate_s", rules.stalemate_s);
  visit("stalemate_radius_m", rules.stalemate_radius_m);
  visit("keeper_hold_s", rules.keeper_hold_s);
  visit("contested_m", rules.contested_m);
  visit("kickoff_backward_required", rules.kickoff_backward_required);
  visit("kickoff_move_m", rules.kickoff_move_m);
  visit("kickoff_limit_s", rules.kickoff_limit_s);
  visit("ready_s", rules.ready_s);
  visit("forfeit_goals", rules.forfeit_goals);
}

Json json_of(double value) {
  return std::isinf(value) ? Json() : Json(value);
}
Json json_of(int value) {
  return value;
}
Json json_of(bool value) {
  return value;
}

bool read(const Json& json, double& value) {
  if (!json.is_number() && !json.is_null()) return false;
  value = json.is_null() ? referee::off : json.get<double>();
  return value >= 0.0;
}
bool read(const Json& json, int& value) {
  if (!json.is_number_integer()) return false;
  value = json.get<int>();
  return value >= 0;
}
bool read(const Json& json, bool& value) {
  if (!json.is_boolean()) return false;
  value = json.get<bool>();
  return true;
}

}  // namespace

Json to_json(const Rules& rules) {
  Json object{{"preset", to_string(rules.preset)}};
  for_each_parameter(rules,
                     [&](const char* name, const auto& value) { object[name] = json_of(value); });
  return object;
}

Result<Rules> rules_from_json(const Json& object, Errc code) {
  if (!object.is_object()) return fail(code, "/rules: an object is expected");
  auto preset = referee::Preset::mirosot;
  if (object.contains("preset")) {
    const Json& name = object["preset"];
    const auto known =
        name.is_string() ? from_string<referee::Preset>(name.get<std::string>()) : std::nullopt;
    if (!known) {
      return fail(code,
                  "/rules/preset: one of " + list_of_names<referee::Preset>() + " is expected");
    }
    preset = *known;
  }
  Rules rules = referee::make_rules(preset);
  for (auto item = object.begin(); item != object.end(); ++item) {
    const std::string& key = item.key();
    const Json& value = *item;
    if (key == "preset") continue;
    bool known = false;
    bool good = false;
    for_each_parameter(rules, [&](const char* name, auto& member) {
      if (key != name) return;
      known = true;
      good = read(value, member);
    });
    if (!known) return fail(code, "/rules/" + key + ": there is no such parameter");
    if (!good) return fail(code, "/rules/" + key + ": " + value.dump() + " is not a value for it");
  }
  return rules;
}

}  // namespace mirocup::record
