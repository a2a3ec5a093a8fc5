// SPDX-License-Identifier: MIT
#include "record/rules_json.hpp"

#include "record/json_reader.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace mirocup::record {

namespace {

using referee::Rules;
using Json = nlohmann::ordered_json;

// Calls visit(name, member) for every parameter, in the order of core/referee/rules.hpp. The names
// are the keys of JSON and of --rule.
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
  visit("substitutions", rules.substitutions);
  visit("half_late_s", rules.half_late_s);
  visit("mercy_goal_diff", rules.mercy_goal_diff);
  visit("forfeit_goals", rules.forfeit_goals);
  visit("ready_s", rules.ready_s);
  visit("touch_m", rules.touch_m);
  visit("drive_mps", rules.drive_mps);
  visit("contested_m", rules.contested_m);
  visit("zone_margin_m", rules.zone_margin_m);
  visit("zone_depth_m", rules.zone_depth_m);
  visit("zone_half_width_m", rules.zone_half_width_m);
  visit("shoved_s", rules.shoved_s);
  visit("advantage_s", rules.advantage_s);
  visit("kickoff_backward_required", rules.kickoff_backward_required);
  visit("kickoff_move_m", rules.kickoff_move_m);
  visit("kickoff_limit_s", rules.kickoff_limit_s);
  visit("kickoff_behind", rules.kickoff_behind);
  visit("def_max", rules.def_max);
  visit("pa_def_max", rules.pa_def_max);
  visit("def_dwell_s", rules.def_dwell_s);
  visit("def_at_once", rules.def_at_once);
  visit("att_max", rules.att_max);
  visit("pa_att_max", rules.pa_att_max);
  visit("att_dwell_s", rules.att_dwell_s);
  visit("att_at_once", rules.att_at_once);
  visit("att_cancels_goal", rules.att_cancels_goal);
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
  visit("stalemate_speed_mps", rules.stalemate_speed_mps);
  visit("stalemate_penalty", rules.stalemate_penalty);
  visit("push_dist_m", rules.push_dist_m);
  visit("push_angle_rad", rules.push_angle_rad);
  visit("cooldown_s", rules.cooldown_s);
  visit("collision_mps", rules.collision_mps);
  visit("collision_differ_mps", rules.collision_differ_mps);
  visit("collision_foul", rules.collision_foul);
  visit("hide_m", rules.hide_m);
  visit("hide_s", rules.hide_s);
  visit("wall_push", rules.wall_push);
  visit("wall_ball_m", rules.wall_ball_m);
  visit("wall_robot_m", rules.wall_robot_m);
  visit("wall_s", rules.wall_s);
  visit("hand_penalty", rules.hand_penalty);
}

// A limit that is off is null.
void read(const JsonReader& json, double& value) {
  value = json.is_null() ? referee::off : json.number(0.0);
}
// A count that is off is 0 or null.
void read(const JsonReader& json, int& value) {
  constexpr int max_count = 10'000;  // robots, goals, rounds
  value = json.is_null() ? 0 : json.integer<int>(0, max_count);
}
void read(const JsonReader& json, bool& value) {
  value = json.boolean();
}

}  // namespace

Json to_json(const Rules& rules) {
  Json object{{"preset", to_string(rules.preset)}};
  for_each_parameter(rules, [&](const char* name, const auto& value) {
    object[name] = std::isinf(static_cast<double>(value)) ? Json() : Json(value);
  });
  return object;
}

void read_parameters(const JsonReader& json, Rules& rules) {
  read_named_members(
      json, rules, "parameter", [](auto& r, auto visit) { for_each_parameter(r, visit); },
      [](const JsonReader& value, auto& member) { read(value, member); });
}

Rules read_rules(const JsonReader& json, RobotLeague league) {
  auto preset = referee::Preset::mirosot;
  if (json.expect_object()) json.read_if_present("preset", preset);
  Rules rules = referee::make_rules(preset, league);
  read_parameters(json, rules);
  return rules;
}

Result<Rules> rules_with_changes(Json object, const std::vector<std::string>& changes,
                                 RobotLeague league) {
  MIROCUP_TRY(const auto changed, with_changes(std::move(object), changes, "--rule"));
  std::optional<JsonProblem> problem;
  const Rules rules = read_rules(JsonReader(changed, "/rules", problem), league);
  if (problem) return fail(Errc::input, problem->pointer + ": " + problem->reason);
  return rules;
}

}  // namespace mirocup::record
