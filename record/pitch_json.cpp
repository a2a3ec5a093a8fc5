// SPDX-License-Identifier: MIT
#include "record/pitch_json.hpp"

#include "record/conditions_json.hpp"
#include "record/json_reader.hpp"
#include "record/parameters_json.hpp"
#include "system/files.hpp"

namespace mirocup::record {

namespace {

using match::PitchPreset;
using match::PitchSpec;
using Json = nlohmann::ordered_json;

constexpr std::string_view pitch_schema = "mirocup/pitch/1";

bool has_two_lags(const simulator::Parameters& p) {
  return p.turn_time_constant > 0.0 || p.brake_time_constant > 0.0;
}

// The motors of a pitch. Their first constant is the parameter motor_time_constant.
void read_motor(const JsonReader& json, simulator::Parameters& p) {
  if (!json.expect_object({"kind", "turn_time_constant", "brake_time_constant"})) return;
  const std::string kind = json.at("kind").text();
  if (kind != "one_lag" && kind != "two_lags") {
    json.at("kind").complain("\"one_lag\" or \"two_lags\" is expected, not " +
                             json.at("kind").quoted());
    return;
  }
  Json lags = json.json();
  p.turn_time_constant = p.brake_time_constant = 0.0;
  if (kind == "one_lag") {
    if (lags.size() > 1) json.complain("a motor with one lag has no other time constants");
    return;
  }
  for (const auto& [key, value] : {std::pair{"turn_time_constant", &p.turn_time_constant},
                                   std::pair{"brake_time_constant", &p.brake_time_constant}}) {
    if (!json.has(key)) continue;
    const JsonReader given = json.at(key);
    *value = (given.has("value") ? given.at("value") : given).number(0.0);
  }
  if (!has_two_lags(p)) json.complain("turn_time_constant or brake_time_constant is expected");
}

}  // namespace

Json to_json(const PitchSpec& pitch) {
  Json parameters = to_json(pitch.parameters);
  Json motor{{"kind", has_two_lags(pitch.parameters) ? "two_lags" : "one_lag"}};
  for (const char* key : {"turn_time_constant", "brake_time_constant"}) {
    if (!parameters.contains(key)) continue;
    motor[key] = parameters[key];
    parameters.erase(key);
  }
  Json json{{"schema", pitch_schema}, {"name", pitch.name}};
  if (!pitch.source.empty()) json["source"] = pitch.source;
  json["parameters"] = parameters;
  json["motor"] = motor;
  if (pitch.parameters.robot_corners.corners > 0) json["outline"] = outline_json(pitch.parameters);
  if (pitch.conditions) json["conditions"] = to_json(*pitch.conditions);
  if (pitch.control_period) json["control_period"] = *pitch.control_period;
  return json;
}

PitchSpec read_pitch(const JsonReader& json) {
  if (json.is_string()) return match::pitch_of(json.name<PitchPreset>());
  if (!json.expect_object({"schema", "preset", "name", "source", "parameters", "motor", "outline",
                           "conditions", "control_period", "identified", "not_known"})) {
    return {};
  }
  if (json.has("schema")) json.expect_schema(pitch_schema);
  PitchSpec pitch = match::pitch_of(PitchPreset::mirosot);
  if (json.has("preset")) pitch = match::pitch_of(json.at("preset").name<PitchPreset>());
  json.read_if_present("name", pitch.name);
  if (json.has("parameters")) pitch.source.clear();
  json.read_if_present("source", pitch.source);
  if (json.has("parameters")) read_physics(json.at("parameters"), pitch.parameters);
  if (json.has("motor")) read_motor(json.at("motor"), pitch.parameters);
  if (json.has("outline")) pitch.parameters.robot_corners = read_outline(json.at("outline"));
  if (json.has("conditions")) pitch.conditions = read_conditions(json.at("conditions"));
  if (json.has("control_period")) {
    pitch.control_period = json.at("control_period").number(min_control_period, max_control_period);
  }
  if (const auto identified = json.find("identified")) {
    if (const auto delay = identified->find("command_delay")) {
      const JsonReader given = delay->has("value") ? delay->at("value") : *delay;
      pitch.command_delay = given.number(0.0, 10.0);
    }
  }
  if (const std::string problem = match::problem_with(pitch.parameters); !problem.empty()) {
    (json.has("parameters") ? json.at("parameters") : json).complain(problem);
  }
  return pitch;
}

Result<PitchSpec> parse_pitch(std::string_view text, const std::string& path) {
  return read_json<PitchSpec>(text, path, Errc::input, read_pitch);
}

Result<PitchSpec> pitch_of_option(const std::string& option) {
  if (const auto preset = from_string<PitchPreset>(option)) return match::pitch_of(*preset);
  if (option.starts_with("{")) return parse_pitch(option, "--pitch");
  system::Disk disk;
  if (!disk.exists(option))
    return fail(Errc::input, "--pitch " + option +
                                 ": there is no such file, and no pitch of that "
                                 "name: " +
                                 list_of_names<PitchPreset>());
  MIROCUP_TRY(const auto text, disk.read_named(option, system::size_limit::note));
  return parse_pitch(text, option);
}

}  // namespace mirocup::record
