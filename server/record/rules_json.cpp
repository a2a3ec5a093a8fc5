// SPDX-License-Identifier: MIT
#include "server/record/rules_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <utility>

namespace mirocup::record {

namespace {

using referee::Rules;
using Json = nlohmann::ordered_json;

// Calls visit(name, member) for every parameter, in the order of the header.
template <class R, class Visit>
void for_each_parameter(R& rules, Visit visit) {
  visit("half_s", rules.half_s);
  visit("half_break_s", rules.half_break_s);
  visit("golden_goal_s", rules.golden_goal_s);
  visit("extra_halves_s", rules.extra_halves_s);
  visit("shoot_out_rounds", rules.shoot_out_rounds);
  visit("shoot_out_most_rounds", rules.shoot_out_most_rounds);
  visit("attempt_s", rules.attempt_s);
  visit("attempt_hold_s", rules.attempt_hold_s);
  visit("time_outs", rules.time_outs);
  visit("time_out_s", rules.time_out_s);
  visit("mercy_goal_diff", rules.mercy_goal_diff);
  visit("forfeit_goals", rules.forfeit_goals);
  visit("ready_s", rules.ready_s);
  visit("touch_m", rules.touch_m);
  visit("drive_mps", rules.drive_mps);
  visit("contested_m", rules.contested_m);
  visit("zone_margin_m", rules.zone_margin_m);
  visit("shoved_s", rules.shoved_s);
  visit("advantage_s", rules.advantage_s);
  visit("kickoff_backward_required", rules.kickoff_backward_required);
  visit("kickoff_move_m", rules.kickoff_move_m);
  visit("kickoff_limit_s", rules.kickoff_limit_s);
  visit("def_max", rules.def_max);
  visit("pa_def_max", rules.pa_def_max);
  visit("def_dwell_s", rules.def_dwell_s);
  visit("att_max", rules.att_max);
  visit("pa_att_max", rules.pa_att_max);
  visit("att_dwell_s", rules.att_dwell_s);
  visit("keeper_hold_s", rules.keeper_hold_s);
  visit("charge_s", rules.charge_s);
  visit("charge_speed_mps", rules.charge_speed_mps);
  visit("push_in_s", rules.push_in_s);
  visit("push_in_m", rules.push_in_m);
  visit("block_s", rules.block_s);
  visit("block_gap_m", rules.block_gap_m);
  visit("block_ball_m", rules.block_ball_m);
  visit("stalemate_s", rules.stalemate_s);
  visit("stalemate_radius_m", rules.stalemate_radius_m);
  visit("push_dist_m", rules.push_dist_m);
  visit("push_angle_rad", rules.push_angle_rad);
  visit("cooldown_s", rules.cooldown_s);
  visit("collision_mps", rules.collision_mps);
  visit("collision_differ_mps", rules.collision_differ_mps);
  visit("hide_m", rules.hide_m);
  visit("hide_s", rules.hide_s);
  visit("wall_push", rules.wall_push);
  visit("wall_ball_m", rules.wall_ball_m);
  visit("wall_robot_m", rules.wall_robot_m);
  visit("wall_s", rules.wall_s);
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
  if (json.is_null()) {
    value = 0;
    return true;
  }
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

Result<Rules> rules_from_json(const Json& object, Errc code, League league) {
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
  Rules rules = referee::make_rules(preset, league);
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

Result<Rules> rules_with_changes(Json object, const std::vector<std::string>& changes,
                                 League league) {
  for (const std::string& change : changes) {
    const std::size_t equals = change.find('=');
    const std::string text = equals == std::string::npos ? "" : change.substr(equals + 1);
    Json value = Json::parse(text, nullptr, false);
    if (value.is_discarded()) {
      return fail(Errc::input, "--rule " + change + ": KEY=VALUE is expected");
    }
    object[change.substr(0, equals)] = std::move(value);
  }
  return rules_from_json(object, Errc::input, league);
}

}  // namespace mirocup::record
