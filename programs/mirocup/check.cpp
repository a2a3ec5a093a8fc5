// SPDX-License-Identifier: MIT
//
// mirocup check FILE.so: prints whether the library would be accepted as an entry, and why.
#include "programs/check/entry_check.hpp"
#include "programs/mirocup/commands.hpp"
#include "record/match_record.hpp"
#include "record/rules_json.hpp"
#include "record/team_parameters_json.hpp"
#include "server/seats.hpp"
#include "system/text.hpp"

#include <sstream>

namespace mirocup::app {

namespace {

struct CheckOptions {
  std::string path;
  std::string league = "small";
  std::string rules = "mirosot";
  std::optional<double> half_s;  // of the legs that the entry is for
  std::string processor = "x86-64-v3";
  std::vector<std::string> parameters;  // KEY=VALUE
  std::string record_path;              // of a leg against striker; "": none is written
  bool ladder = false;
  bool json = false;
  std::string answer;  // file for the steps and the report, as JSON lines
};

record::Json to_json(const CheckOptions& options, const EntryReport& report) {
  record::Json checks = record::Json::array();
  for (const Check& check : report.checks) {
    record::Json one{{"name", check.name},
                     {"passed", check.passed ? record::Json(*check.passed) : record::Json()},
                     {"text", check.text}};
    if (check.passed == false) {
      one["what"] = check.what;
      one["where"] = check.where;
      one["cure"] = check.cure;
      if (!check.cause.empty()) one["cause"] = check.cause;
    }
    checks.push_back(std::move(one));
  }
  record::Json warnings = record::Json::array();
  record::Json notes = record::Json::array();
  for (const Note& note : report.notes) {
    warnings.push_back(note.text);
    notes.push_back({{"code", note.code}, {"text", note.text}});
  }
  const auto rows_of = [](const std::vector<LegStory>& legs) {
    record::Json rows = record::Json::array();
    for (const LegStory& leg : legs) {
      rows.push_back({{"colour", to_string(leg.team)},
                      {"opponent", leg.opponent},
                      {"score", leg.score},
                      {"own_goals", static_cast<int>(leg.count(Habit::own_goal).sum)},
                      {"standing", leg.of(Habit::stand)},
                      {"turning", leg.of(Habit::turn)},
                      {"backwards", leg.of(Habit::backwards)}});
    }
    return rows;
  };
  const Check* failure = report.failure();
  const auto of_failure = [failure](std::string Check::*part) {
    return failure == nullptr ? record::Json() : record::Json(failure->*part);
  };
  return {{"file", options.path},
          {"sha256", record::or_null(report.sha256)},
          {"accepted", failure == nullptr},
          {"reason", failure == nullptr ? record::Json()
                                        : record::Json(failure->name + ": " + failure->text)},
          {"where", of_failure(&Check::where)},
          {"cure", of_failure(&Check::cure)},
          {"checks", checks},
          {"legs", rows_of(report.legs)},
          {"ladder", rows_of(report.ladder)},
          {"strength", record::or_null(report.strength.text)},
          {"notes", notes},
          {"isolation", to_string(report.isolation)},
          {"timing",
           {{"check_seconds", report.used_seconds},
            {"start_ms", report.start_ms},
            {"mean_tick_ms", report.mean_tick_ms},
            {"slowest_tick_ms", report.slowest_tick_ms},
            {"bank_share", report.mean_tick_ms / (1e3 * plugins::Budget().bank_per_tick)},
            {"leg_seconds", report.leg_seconds},
            {"leg_share", report.leg_share}}},
          {"peak_memory_bytes", report.peak_memory},
          {"unknown_parameters", record::to_json(report.unknown_parameters)},
          {"bad_values", report.bad_speeds[0].count + report.bad_speeds[1].count},
          {"moved_placements", report.moved_placements},
          {"warnings", warnings},
          {"log", report.log}};
}

void print(const Check& check) {
  std::cout << (*check.passed ? " ok " : "NO  ") << check.name << ": "
            << system::printable(check.text) << std::endl;  // at once: the next one takes a while
}

// Prints the log, without its middle if it is long.
void print_log(const std::string& log) {
  constexpr std::size_t shown = 20;  // lines at each end
  std::vector<std::string> lines;
  std::istringstream in(log);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::cout << "--- log\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines.size() > 2 * shown && i == shown)
      std::cout << "--- " << lines.size() - 2 * shown << " lines more\n";
    if (i < shown || i + shown >= lines.size()) std::cout << lines[i] << '\n';
  }
  std::cout << "--- end of log\n";
}

void print(const CheckOptions& options, const EntryReport& report) {
  if (report.mean_tick_ms > 0.0) {
    std::cout << system::formatted(
        "    a tick takes %.3f ms of processor time in the mean, %.3f ms at most; start "
        "%.1f ms; memory %.1f MiB; sandbox %s\n",
        report.mean_tick_ms, report.slowest_tick_ms, report.start_ms,
        static_cast<double>(report.peak_memory) / (1 << 20), to_string(report.isolation).data());
  }
  for (const LegStory& leg : report.ladder) std::cout << "    " << text_of(leg) << '\n';
  if (!report.strength.text.empty()) std::cout << "    " << report.strength.text << '\n';
  for (const Note& note : report.notes) std::cout << "    warning: " << note.text << '\n';
  for (const auto& parameter : report.unknown_parameters) {
    std::cout << "    warning: the team did not ask for the parameter " << parameter.first << '\n';
  }
  if (!report.log.empty()) print_log(report.log);
  const Check* failure = report.failure();
  if (failure != nullptr) {
    std::cout << "what:  " << system::printable(failure->what)
              << "\nwhere: " << system::printable(failure->where)
              << "\ndo:    " << system::printable(failure->cure)
              << "\nplays: the entry that played before; a refused entry changes nothing\n";
  }
  std::cout << system::printable(options.path)
            << (failure == nullptr ? ": accepted" : ": not accepted, see " + failure->name) << '\n';
}

// Writes the leg against striker, if it came to its end.
Result<void> write_gate_leg(const CheckOptions& options, const EntryReport& report) {
  if (options.record_path.empty() || !report.gate_leg) return {};
  record::MatchRecord record;
  record.software = record::this_software();
  record.isolation = to_string(report.isolation);
  const auto& [colour, recording] = *report.gate_leg;
  const int own = index_of(colour);
  record.teams[own] = {.name = "entry", .sha256 = report.sha256};
  record.teams[1 - own] = {.name = "striker", .kind = record::TeamKind::house, .sha256 = {}};
  record.budget[own].slowest_tick_ms = report.slowest_tick_ms;
  record.recording = recording;
  system::Disk disk;
  return record::save(disk, options.record_path, record);
}

Result<int> run_check(const CheckOptions& options, const record::WriteAnswer& answer) {
  MIROCUP_TRY(const auto parameters,
              record::parameters_with_changes({}, options.parameters, "--param"));
  const auto tell = [&answer](int number, int of, const char* name) {
    (void)answer({{"step", number}, {"of", of}, {"name", name}});  // only to be looked at
  };
  EntryTerms terms;
  terms.league = *from_string<RobotLeague>(options.league);
  terms.rules = referee::make_rules(*from_string<referee::Preset>(options.rules), terms.league);
  if (options.half_s) terms.rules.half_s = *options.half_s;
  terms.parameters = parameters;
  terms.processor = *from_string<system::Processor>(options.processor);
  terms.ladder = options.ladder;
  server::stay_on_this_core();  // the teams and this process take turns
  MIROCUP_TRY(const auto report,
              check_entry(
                  options.path, terms,
                  options.json ? OnCheck() : [](const Check& check) { print(check); }, tell));
  MIROCUP_TRY_VOID(write_gate_leg(options, report));
  const record::Json json = to_json(options, report);
  MIROCUP_TRY_VOID(answer(json));
  options.json ? print_json(json) : print(options, report);
  return report.failure() == nullptr ? exit_yes : exit_no;
}

}  // namespace

void add_check(system::Commands& commands) {
  const auto [command, o] =
      commands.add(answering<run_check, CheckOptions>, "check", for_teams,
                   "Check whether a library would be accepted as an entry",
                   {"mirocup check mine.so", "mirocup check mine.py --league large"});
  command.option("FILE", o.path, "Library of the team (.so), or its file of Python (.py)")
      .required();
  command
      .option("--league", o.league,
              "Field and number of robots: small (3 a side), middle (5), large (11)")
      .one_of({"small", "middle", "large"})
      .shows_default();
  command.option("--rules", o.rules, "Preset of the rules")
      .one_of(system::names_of<referee::Preset>())
      .shows_default();
  command
      .option("--half SECONDS", o.half_s,
              "Length of a half in the team's league, in seconds; a team's processor time in a leg "
              "depends on it (default: as in the rules)")
      .between(record::min_half_s, record::max_half_s);
  add_parameters(command, "--param", o.parameters, "the team");
  command
      .option("--processor", o.processor,
              "Oldest processor on which the team may play; a warning names instructions beyond it")
      .one_of(system::names_of<system::Processor>())
      .shows_default();
  command.option(
      "--record FILE.json", o.record_path,
      "File to write the record of the team's leg against striker to, for mirocup replay");
  command.flag("--ladder", o.ladder, "Also play two short legs against each house team");
  command.flag("--json", o.json, "Print the report as one JSON object");
  add_answer(command, o.answer);
}

}  // namespace mirocup::app
