// SPDX-License-Identifier: MIT
#include "programs/mirocup/sheet_report.hpp"

#include "record/csv_rows.hpp"
#include "record/json_fields.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::app {

namespace {

using Json = nlohmann::ordered_json;

Json entry_json(const drills::Sheet& sheet, const SheetScale& scale, const DrillReport& entry) {
  Json json = json_of(entry);
  Score mean;
  double weights = 0.0;
  double below = 0.0;  // square of the distance to the lower end, a sum of independent parts
  double above = 0.0;  // and to the upper end
  for (std::size_t i = 0; i < sheet.drills.size(); ++i) {
    const double start = score_of(scale.start.tries[i]).value;
    const double reference = score_of(scale.reference.tries[i]).value;
    const Score marks = score_of(entry.tries[i]);
    const auto scaled = [&](double value) {
      return 100.0 * std::clamp((value - start) / (reference - start), 0.0, 1.0);
    };
    const Score score{scaled(marks.value), scaled(marks.low), scaled(marks.high)};
    const double weight = sheet.drills[i].weight;
    weights += weight;
    mean.value += weight * score.value;
    below += std::pow(weight * (score.value - score.low), 2.0);
    above += std::pow(weight * (score.high - score.value), 2.0);
    Json& drill = json["drills"][i];
    drill.update({{"weight", weight},
                  {"marks", drill["score"]},
                  {"start", to_a_tenth(start)},
                  {"reference", to_a_tenth(reference)}});
    set_score(drill, score);
  }
  mean.value /= weights;
  mean.low = std::max(0.0, mean.value - std::sqrt(below) / weights);
  mean.high = std::min(100.0, mean.value + std::sqrt(above) / weights);
  set_score(json, mean);
  const std::vector<std::string> faults = faults_of(entry);
  json["note"] = faults.empty() ? Json() : Json(faults.front());
  return json;
}

}  // namespace

Json sheet_json(const drills::Sheet& sheet, std::uint64_t first_seed, const SheetScale& scale,
                const std::vector<DrillReport>& entries) {
  Json teams = Json::array();
  for (const DrillReport& entry : entries) teams.push_back(entry_json(sheet, scale, entry));
  return {{"sheet", sheet.name},
          {"title", sheet.title},
          {"first_seed", first_seed},
          {"teams", std::move(teams)}};
}

std::string sheet_csv(const Json& json) {
  Json rows = json["teams"];
  for (Json& row : rows) row["sheet"] = json["sheet"];
  std::vector<std::string> columns{"team", "sheet", "score", "low", "high", "note"};
  const Json& drills = rows[0]["drills"];
  for (std::size_t i = 0; i < drills.size(); ++i)
    columns.push_back(record::text_in(drills[i], "name") + "=drills/" + std::to_string(i) +
                      "/score");
  std::string text = record::csv_of(rows, columns);
  std::erase(text, '\r');
  return text;
}

std::string sheet_text(const Json& json) {
  std::string text;
  for (const Json& team : json["teams"]) {
    const std::string note = record::text_in(team, "note");
    std::vector<std::string> notes;
    if (!note.empty()) notes.push_back(note);
    text += report_text(team, record::text_in(json, "sheet"), notes);
  }
  return text;
}

}  // namespace mirocup::app
