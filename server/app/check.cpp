// SPDX-License-Identifier: MIT
//
// mirocup check FILE.so: prints whether the library would be accepted as an entry, and why.
#include "server/app/commands.hpp"
#include "server/app/entry_check.hpp"
#include "server/record/json_reader.hpp"
#include "server/record/match_record.hpp"
#include "server/record/team_parameters_json.hpp"
#include "system/printable.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

namespace mirocup::app {

namespace {

// An entry that uses a larger share of a leg's processor time gets a warning.
constexpr double max_leg_share = 0.6;

record::Json to_json(const CheckOptions& options, const EntryReport& report) {
  record::Json checks = record::Json::array();
  for (const Check& check : report.checks) {
    checks.push_back({{"name", check.name},
                      {"passed", check.passed ? record::Json(*check.passed) : record::Json()},
                      {"text", check.text}});
  }
  const Check* failure = report.failure();
  return {{"file", options.path},
          {"sha256", report.sha256.empty() ? record::Json() : record::Json(report.sha256)},
          {"accepted", failure == nullptr},
          {"reason", failure == nullptr ? record::Json()
                                        : record::Json(failure->name + ": " + failure->text)},
          {"checks", checks},
          {"isolation", to_string(report.isolation)},
          {"timing",
           {{"start_ms", report.start_ms},
            {"mean_tick_ms", report.mean_tick_ms},
            {"slowest_tick_ms", report.slowest_tick_ms},
            {"bank_share", report.bank_share},
            {"leg_seconds", report.leg_seconds},
            {"leg_share", report.leg_share}}},
          {"peak_memory_bytes", report.peak_memory},
          {"unknown_parameters", record::to_json(report.unknown_parameters)},
          {"log", report.log}};
}

void print(const CheckOptions& options, const EntryReport& report) {
  for (const Check& check : report.checks) {
    const char* mark = !check.passed ? "  - " : *check.passed ? " ok " : "NO  ";
    std::cout << mark << check.name << ": " << system::printable(check.text) << '\n';
  }
  char text[200];
  if (report.mean_tick_ms > 0.0) {
    std::snprintf(text, sizeof text,
                  "    a tick takes %.3f ms of processor time in the mean, %.3f ms at most; start "
                  "%.1f ms; memory %.1f MiB; sandbox %s\n",
                  report.mean_tick_ms, report.slowest_tick_ms, report.start_ms,
                  static_cast<double>(report.peak_memory) / (1 << 20),
                  std::string(to_string(report.isolation)).c_str());
    std::cout << text;
  }
  const Check* failure = report.failure();
  if (failure == nullptr && report.leg_share > max_leg_share) {
    std::snprintf(text, sizeof text,
                  "    warning: that is %.0f %% of the time that a leg has; leave room for slower "
                  "machines\n",
                  100.0 * report.leg_share);
    std::cout << text;
  }
  for (const auto& parameter : report.unknown_parameters) {
    std::cout << "    warning: the team did not ask for the parameter " << parameter.first << '\n';
  }
  if (!report.log.empty()) std::cout << "--- log\n" << report.log << "\n--- end of log\n";
  if (failure == nullptr) {
    std::cout << system::printable(options.path) << ": accepted\n";
  } else {
    std::cout << system::printable(options.path) << ": not accepted, " << failure->name << ": "
              << system::printable(failure->text) << '\n';
  }
}

}  // namespace

Result<int> run_check(const CheckOptions& options) {
  const auto parameters = record::parameters_with_changes({}, options.parameters, "--param");
  if (!parameters) return tl::unexpected(parameters.error());
  const auto tell = [&options](int number, int of, const char* name) {
    if (options.steps) std::cerr << "step " << number << " of " << of << ": " << name << std::endl;
  };
  const auto report = check_entry(options.path, *from_string<League>(options.league),
                                  options.half_s, *parameters, tell);
  if (!report) return tl::unexpected(report.error());
  if (options.json) {
    std::cout << record::json_text(to_json(options, *report)) << '\n';
  } else {
    print(options, *report);
  }
  return report->failure() == nullptr ? exit_yes : exit_no;
}

}  // namespace mirocup::app
