// SPDX-License-Identifier: MIT
#include "programs/mirocup/sheet_report.hpp"

#include "record/csv_rows.hpp"
#include "record/json_fields.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::app {

namespace {

using Json = nlohmann::ordered_json;

void set_score(Json& json, const Score& score) {
  for (const auto& [key, value] :
       {std::pair("score", score.value), {"low", score.low}, {"high", score.high}})
    json[key] = std::round(10.0 * value) / 10.0;
}

Json entry_json(const drills::Sheet& sheet, const SheetScale& scale, const DrillReport& entry) {
  Json json = json_of(std::vector{entry});
  Score mean;
  double weights = 0.0;
  double below =
      0.0;  // square of the distance to the lower end; that of a sum of independent parts
  double above = 0.0;
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
                  {"start", json_of(std::vector{scale.start})["drills"][i]["score"]},
                  {"reference", json_of(std::vector{scale.reference})["drills"][i]["score"]}});
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
  const auto number = [](const Json& of, const char* key) {
    return record::value_in<double>(of, key);
  };
  const auto add_score = [&](const Json& of, const std::string& name) {
    text += system::formatted("  %-32s %5.1f  (%.0f to %.0f)", name.c_str(), number(of, "score"),
                              number(of, "low"), number(of, "high"));
  };
  for (const Json& team : json["teams"]) {
    text += system::printable(record::text_in(team, "team")) + "\n";
    for (const Json& drill : team["drills"]) {
      add_score(drill, record::text_in(drill, "name") +
                           system::formatted(" x%g", number(drill, "weight")));
      text += system::formatted("  marks %.1f; start %.1f, reference %.1f", number(drill, "marks"),
                                number(drill, "start"), number(drill, "reference"));
      if (const Json& failed = drill["failed_seeds"]; !failed.empty())
        text += "; failed first with seed " + record::json_text(failed[0]);
      text += "\n";
    }
    add_score(team, record::text_in(json, "sheet"));
    text += "\n";
    if (const std::string note = record::text_in(team, "note"); !note.empty())
      text += "  " + system::printable(note) + "\n";
  }
  return text;
}

}  // namespace mirocup::app
