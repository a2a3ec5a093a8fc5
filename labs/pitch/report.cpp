// SPDX-License-Identifier: MIT
#include "labs/pitch/report.hpp"

#include "labs/pitch/page.hpp"
#include "record/json_reader.hpp"
#include "record/parameters_json.hpp"
#include "record/pitch_json.hpp"
#include "system/files.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::pitch {

namespace {

using Json = nlohmann::ordered_json;

Json estimate_json(const Estimate& e) {
  return {{"value", e.value}, {"low", e.low}, {"high", e.high}};
}

}  // namespace

Json pitch_json(const Identified& r, const match::PitchSpec& start, const std::string& name) {
  match::PitchSpec pitch = start;
  pitch.name = name;
  pitch.source = "identified by mirocup from recordings";
  pitch.parameters = r.guess.parameters;
  if (r.has_one_lag) pitch.parameters.turn_time_constant = 0.0;
  if (!r.has_brake) pitch.parameters.brake_time_constant = 0.0;
  // What a recording cannot tell is as it was before.
  Guess plain{start.parameters, 0.0};
  for (int u = 0; u < unknown_count; ++u) {
    if (r.known[u] || u == turn_lag || u == brake_lag || u == unknown_count - 1) continue;
    Guess now{pitch.parameters, 0.0};
    if (u == grip_limit && start.parameters.grip == simulator::infinite_grip) continue;
    set_value(now, u, value_of(plain, u));
    pitch.parameters = now.parameters;
  }
  match::Conditions conditions = match::conditions_of(match::ConditionsPreset::camera);
  conditions.see_sigma_m = r.position_noise.value;
  conditions.see_sigma_rad = r.heading_noise.value;
  conditions.unseen_rate = r.unseen;
  pitch.conditions = conditions;

  Json json = record::to_json(pitch);
  Json identified = Json::object();
  Json not_known = Json::object();
  for (int u = 0; u < unknown_count; ++u) {
    const std::string key(unknowns()[u].name);
    if (!r.known[u]) {
      not_known[key] = r.why_not[u];
      continue;
    }
    const Json value = estimate_json(*r.known[u]);
    if (u == turn_lag || u == brake_lag) {
      json["motor"][key] = value;
    } else if (u == unknown_count - 1) {
      identified[key] = value;
    } else if (const std::size_t bar = key.find('/'); bar != std::string::npos) {
      json["parameters"][key.substr(0, bar)][key.substr(bar + 1)] = value;
    } else {
      json["parameters"][key] = value;
    }
  }
  if (r.has_deceleration) identified["ball_deceleration"] = estimate_json(r.deceleration);
  identified["position_noise"] = estimate_json(r.position_noise);
  identified["heading_noise"] = estimate_json(r.heading_noise);
  identified["unseen"] = r.unseen;
  identified["outliers"] = r.outliers;
  json["identified"] = identified;
  json["not_known"] = not_known;
  return json;
}

Json to_json(const Validation& v) {
  Json kinds = Json::object();
  for (std::size_t kind = 0; kind < v.cells.size(); ++kind) {
    Json rows = Json::array();
    for (std::size_t h = 0; h < horizons.size(); ++h) {
      const ErrorCell& cell = v.cells[kind][h];
      if (cell.count == 0) continue;
      Json row{{"ahead", horizons[h]}, {"count", cell.count}};
      Json worse = Json::array();
      const int count = v.peer.empty() ? predictors - 1 : predictors;
      for (int k = 0; k < count; ++k) {
        row[std::string(to_string(static_cast<Predictor>(k)))] = cell.rms[k];
        if (cell.beats_simulator[k]) worse.push_back(to_string(static_cast<Predictor>(k)));
      }
      row["worse_than"] = worse;
      rows.push_back(row);
    }
    if (!rows.empty()) kinds[std::string(to_string(static_cast<EventKind>(kind)))] = rows;
  }
  Json json{
      {"period", v.period}, {"noise", v.noise}, {"kinds", kinds}, {"objections", v.objections}};
  if (!v.peer.empty()) json["peer"] = v.peer;
  return json;
}

Result<std::vector<CameraLog>> read_recordings(const std::vector<std::string>& paths) {
  std::vector<CameraLog> recordings;
  for (const std::string& path : paths) {
    MIROCUP_TRY(auto recording, read_recording(path));
    recordings.push_back(std::move(recording));
  }
  return recordings;
}

Result<ValidationReport> report_of(const ValidationRequest& request, const Peer* peer) {
  MIROCUP_TRY(const auto spec, record::pitch_of_option(request.pitch));
  MIROCUP_TRY(const auto recordings, read_recordings(request.recordings));
  const Validation result = validate(recordings, {spec.parameters, spec.command_delay}, peer);
  if (!request.page.empty()) {
    const std::string title = "The simulator with the pitch " + spec.name + " against recordings";
    system::Disk disk;
    MIROCUP_TRY_VOID(disk.write(request.page, page_of(result, title)));
  }
  return ValidationReport{
      request.json ? record::json_text(to_json(result)) + "\n" : text_of_result(result),
      !result.objections.empty()};
}

}  // namespace mirocup::pitch
