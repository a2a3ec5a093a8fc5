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

double to_a_tenth(double value) {
  return std::round(10.0 * value) / 10.0;
}

std::vector<std::uint64_t> failed_seeds(const std::vector<PlayedTry>& tries) {
  std::vector<std::uint64_t> seeds;
  for (const PlayedTry& one : tries) {
    if (!one.result.passed) seeds.push_back(one.seed);
  }
  return seeds;
}

Json json_of(const DrillReport& report) {
  Json drills = Json::array();
  for (std::size_t i = 0; i < report.drills.size(); ++i) {
    const Score score = score_of(report.tries[i]);
    drills.push_back({{"name", report.drills[i]->name},
                      {"version", report.drills[i]->version},
                      {"score", to_a_tenth(score.value)},
                      {"low", to_a_tenth(score.low)},
                      {"high", to_a_tenth(score.high)},
                      {"tries", report.tries[i].size()},
                      {"failed_seeds", failed_seeds(report.tries[i])}});
  }
  return {{"team", report.team}, {"drills", drills}, {"score", to_a_tenth(report.score())}};
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

std::string text_of(const DrillReport& report) {
  std::string text = system::printable(report.team) + "\n";
  for (std::size_t i = 0; i < report.drills.size(); ++i) {
    const Score score = score_of(report.tries[i]);
    const auto failed = failed_seeds(report.tries[i]);
    text += formatted("  %-25s v%-2d %5.1f  (%.0f to %.0f)", report.drills[i]->name.c_str(),
                      report.drills[i]->version, score.value, score.low, score.high);
    if (!failed.empty()) {
      text += formatted("  failed %zu of %zu", failed.size(), report.tries[i].size());
      text += ", first with seed " + std::to_string(failed.front());
    }
    text += "\n";
  }
  if (report.drills.size() > 1) text += formatted("  %-28s %5.1f\n", "all", report.score());
  for (const std::string& fault : faults_of(report))
    text += "  fault: " + system::printable(fault) + "\n";
  return text;
}

Json json_of(const std::vector<DrillReport>& reports) {
  if (reports.size() == 1) return json_of(reports.front());
  Json teams = Json::array();
  for (const DrillReport& report : reports) teams.push_back(json_of(report));
  return {{"teams", teams}};
}

std::string csv_of(const std::vector<DrillReport>& reports) {
  Json rows = Json::array();
  for (const DrillReport& report : reports) {
    Json all{{"team", report.team}, {"name", "all"}, {"score", to_a_tenth(report.score())}};
    std::size_t tries = 0;
    Json drills = json_of(report)["drills"];
    for (Json& drill : drills) {
      tries += record::value_in<std::size_t>(drill, "tries");
      drill["team"] = report.team;
      rows.push_back(drill);
    }
    all["tries"] = tries;
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
