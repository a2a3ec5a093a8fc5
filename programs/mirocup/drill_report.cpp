// SPDX-License-Identifier: MIT
#include "programs/mirocup/drill_report.hpp"

#include "record/csv_rows.hpp"
#include "record/json_fields.hpp"
#include "record/wilson.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"
#include "web/design/template.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirocup::app {

namespace {

using system::formatted;
using Json = nlohmann::ordered_json;

std::vector<std::uint64_t> failed_seeds(const std::vector<PlayedTry>& tries) {
  std::vector<std::uint64_t> seeds;
  for (const PlayedTry& one : tries) {
    if (!one.result.passed) seeds.push_back(one.seed);
  }
  return seeds;
}

}  // namespace

Score score_of(const std::vector<PlayedTry>& tries) {
  const double n = static_cast<double>(tries.size());
  double sum = 0.0;
  for (const PlayedTry& one : tries) sum += one.result.marks;
  const double p = sum / n;
  const record::Interval interval = record::wilson_interval(p, n);
  return {.value = 100.0 * p, .low = 100.0 * interval.low, .high = 100.0 * interval.high};
}

double to_a_tenth(double score) {
  return std::round(10.0 * score) / 10.0;
}

void set_score(Json& json, const Score& score) {
  json["score"] = to_a_tenth(score.value);
  json["low"] = to_a_tenth(score.low);
  json["high"] = to_a_tenth(score.high);
}

double DrillReport::score() const {
  const double sum = std::accumulate(
      tries.begin(), tries.end(), 0.0,
      [](double so_far, const auto& of_a_drill) { return so_far + score_of(of_a_drill).value; });
  return sum / static_cast<double>(tries.size());
}

std::vector<std::string> faults_of(const DrillReport& report) {
  std::vector<std::string> faults;
  for (const auto& tries : report.tries) {
    for (const PlayedTry& one : tries) {
      const bool is_new = std::find(faults.begin(), faults.end(), one.fault) == faults.end();
      if (!one.fault.empty() && is_new) faults.push_back(one.fault);
    }
  }
  return faults;
}

Json json_of(const DrillReport& report) {
  Json drills = Json::array();
  for (std::size_t i = 0; i < report.drills.size(); ++i) {
    Json& drill = drills.emplace_back();
    drill["name"] = report.drills[i]->name;
    drill["version"] = report.drills[i]->version;
    set_score(drill, score_of(report.tries[i]));
    drill["tries"] = report.tries[i].size();
    drill["failed_seeds"] = failed_seeds(report.tries[i]);
  }
  return {{"team", report.team}, {"drills", drills}, {"score", to_a_tenth(report.score())}};
}

std::string report_text(const Json& team, const std::string& total,
                        const std::vector<std::string>& notes) {
  std::string text = system::printable(record::text_in(team, "team")) + "\n";
  const auto number = [](const Json& of, const char* key) {
    return record::value_in<double>(of, key);
  };
  const auto add_score = [&](const Json& of, const std::string& name) {
    text += formatted("  %-29s %5.1f", name.c_str(), number(of, "score"));
    if (of.contains("low"))
      text += formatted("  (%.0f to %.0f)", number(of, "low"), number(of, "high"));
  };
  for (const Json& drill : team["drills"]) {
    const bool is_of_sheet = drill.contains("weight");
    const std::string name = formatted("%-25s ", record::text_in(drill, "name").c_str());
    add_score(drill, name + formatted(is_of_sheet ? "x%g" : "v%g",
                                      number(drill, is_of_sheet ? "weight" : "version")));
    if (is_of_sheet)
      text += formatted("  marks %.1f; start %.1f, reference %.1f", number(drill, "marks"),
                        number(drill, "start"), number(drill, "reference"));
    if (const Json& failed = drill["failed_seeds"]; !failed.empty())
      text += formatted("  failed %zu of %.0f, first with seed ", failed.size(),
                        number(drill, "tries")) +
              record::json_text(failed[0]);
    text += "\n";
  }
  if (!total.empty()) {
    add_score(team, total);
    text += "\n";
  }
  for (const std::string& note : notes) text += "  " + system::printable(note) + "\n";
  return text;
}

std::string csv_of(const std::vector<DrillReport>& reports) {
  Json rows = Json::array();
  for (const DrillReport& report : reports) {
    Json all = json_of(report);
    std::size_t tries = 0;
    for (Json& drill : all["drills"]) {
      tries += record::value_in<std::size_t>(drill, "tries");
      drill["team"] = report.team;
      rows.push_back(drill);
    }
    all.update({{"name", "all"}, {"tries", tries}});
    rows.push_back(all);
  }
  std::string text = record::csv_of(
      rows, {"team", "drill=name", "score", "low", "high", "tries", "failed_seeds", "version"});
  std::erase(text, '\r');
  return text;
}

std::string failed_page(const std::vector<DrillReport>& reports) {
  Json tries = Json::array();
  for (const DrillReport& report : reports) {
    for (std::size_t k = 0; k < report.drills.size(); ++k) {
      for (const PlayedTry& one : report.tries[k]) {
        const bool is_untried = one.result.why.empty();
        if (one.result.passed || is_untried) continue;
        const std::string seed = std::to_string(one.seed);
        const std::string& drill = report.drills[k]->name;
        tries.push_back({{"team", system::printable(report.team)},
                         {"drill", drill},
                         {"page", system::percent_coded(report.team + "-" + drill + "-" + seed)},
                         {"seed", seed},
                         {"missing", system::printable(one.result.why)},
                         {"after", formatted("%.1f s", one.result.seconds)}});
      }
    }
  }
  const std::string number = std::to_string(tries.size());
  return web::filled(
      web::design_file, "failed_tries.html",
      {{"design", web::design_file("design.css")}, {"number", number}, {"tries", tries}});
}

}  // namespace mirocup::app
