// SPDX-License-Identifier: MIT
//
// mirocup rerun RECORD: lets the teams play again and compares their commands with the record.
#include "core/replay/recorded.hpp"
#include "core/replay/verification.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "programs/mirocup/commands.hpp"
#include "server/seats.hpp"
#include "system/digest.hpp"
#include "system/interrupt.hpp"

#include <filesystem>

namespace mirocup::app {

namespace {

struct RerunOptions {
  std::string record;
  std::string entries;  // folder of libraries; "": the entries of the league of the record
  bool json = false;
};

namespace fs = std::filesystem;

// The first difference between the record and the leg that is played again.
struct CommandDifference {
  std::uint32_t tick = 0;
  std::optional<Team> team;
  std::string what;
};

// The folder of the teams' libraries. In a league, records are in LEAGUE/records/ and entries in
// LEAGUE/entries/.
std::string entries_folder(const RerunOptions& options) {
  if (!options.entries.empty()) return options.entries;
  return (fs::absolute(options.record).parent_path().parent_path() / "entries").string();
}

// The path of the library in `folder` that has the digest; "" if there is none. With a recursive
// iterator the folders below it are searched, too.
template <class Iterator>
std::string library_with(system::Files& files, const fs::path& folder, const std::string& sha256) {
  std::error_code none;
  for (Iterator at(folder, none), end; !none && at != end; at.increment(none)) {
    if (at->path().extension() != ".so" && at->path().extension() != ".py") continue;
    const auto bytes = files.read(at->path().string(), {.max_size = system::size_limit::entry});
    if (bytes && system::sha256(*bytes) == sha256) return at->path().string();
  }
  return "";
}

Result<server::TeamChoice> choose_again(system::Files& files, const record::TeamInfo& team,
                                        const RerunOptions& options) {
  const std::string entries = entries_folder(options);
  if (record::is_on_network(team.kind))
    return fail(Errc::unavailable,
                "\"" + team.name + "\" played over the network: only its owner can run it again");
  const std::string sha256 = team.sha256.value_or("");
  if (team.kind == record::TeamKind::house) {
    auto choice = server::choose_team(team.name);
    if (choice && choice->info.sha256 == sha256) {
      choice->info = team;
      return choice;
    }
  }
  std::string library = library_with<fs::recursive_directory_iterator>(files, entries, sha256);
  // A student's own leg lies beside the library, or in the folder where it was built.
  for (const fs::path& folder :
       {fs::path(options.record).parent_path(), fs::path("."), fs::path("build")}) {
    if (!library.empty()) break;
    library = library_with<fs::directory_iterator>(files, folder.empty() ? "." : folder, sha256);
  }
  if (library.empty()) {
    return fail(Errc::unavailable, "the library of \"" + team.name + "\" (sha256 " + sha256 +
                                       ") is not in " + entries + "; name its folder by --entries");
  }
  auto choice = server::choose_team(library);
  if (choice) choice->info = team;
  return choice;
}

std::string wheels_text(const match::DrivenCommand& command, int robot) {
  const auto wheels = command.speeds(robot);
  return "(" + std::to_string(wheels.left) + ", " + std::to_string(wheels.right) + ") rad/s";
}

std::optional<CommandDifference> compare_commands(const replay::Recording& recording,
                                                  const match::Leg& again) {
  const std::uint32_t tick = again.tick() - 1;
  if (tick >= recording.ticks.size()) {
    return CommandDifference{tick, std::nullopt, "the record ends here, but the teams continue"};
  }
  for (const Team team : both_teams) {
    const match::DrivenCommand& recorded = recording.ticks[tick].commands[index_of(team)];
    const match::DrivenCommand& now = again.log()[tick].commands[index_of(team)];
    for (int i = 0; i < again.field().robots_per_team; ++i) {
      if (recorded.wheels[i] == now.wheels[i]) continue;
      return CommandDifference{tick, team,
                               "robot " + std::to_string(i) + " was driven at " +
                                   wheels_text(recorded, i) + " in the record, is now at " +
                                   wheels_text(now, i)};
    }
  }
  for (const Team team : both_teams) {
    const int robots = again.field().robots_per_team;
    const auto recorded = requested_in(recording, tick, team);
    const auto now = !again.placement_requests().empty() &&
                             again.placement_requests().back().tick == tick &&
                             again.placement_requests().back().team == team
                         ? std::optional(again.placement_requests().back().request)
                         : std::nullopt;
    if (!recorded && !now) continue;
    if (recorded && now && bit_equal(*recorded, *now, robots)) continue;
    return CommandDifference{tick, team, "it asks for other poses at a restart than in the record"};
  }
  return std::nullopt;
}

std::string end_text(const match::Outcome& result) {
  std::string text(to_string(result.kind));
  for (const match::TeamFault& f : result.faults) {
    text += ", " + std::string(to_string(f.team)) + " " + std::string(to_string(f.fault.code));
  }
  return text;
}

std::optional<CommandDifference> compare_ends(const replay::Recording& recording,
                                              const match::Leg& again) {
  const std::string recorded = end_text(recording.outcome);
  const std::string now = end_text(again.outcome());
  if (recorded == now && again.log().size() == recording.ticks.size()) {
    const auto result = replay::compare_results(recording, again);
    if (!result) return std::nullopt;
    return CommandDifference{result->tick, std::nullopt, result->what};
  }
  CommandDifference difference{again.tick(), std::nullopt,
                               "the recorded leg ends " + recorded + " after " +
                                   std::to_string(recording.ticks.size()) +
                                   " ticks, and this leg ends " + now};
  const auto& faults =
      again.outcome().faults.empty() ? recording.outcome.faults : again.outcome().faults;
  if (!faults.empty()) difference.team = faults.front().team;
  return difference;
}

// Returns the first difference, if there is one. A team that never becomes ready ends the match
// before its first tick. The ticks before `from` were played by other teams, and are only repeated.
Result<std::optional<CommandDifference>> play_again(
    const replay::Recording& recording, std::uint32_t from,
    const std::vector<server::TeamChoice>& choices) {
  system::Interrupt interrupt;
  server::stay_on_this_core();
  match::Leg match(recording.setup);
  while (match.tick() < from && !match.is_over()) {
    match.advance(replay::recorded_answers(recording, match.tick()));
  }
  std::vector<server::TeamSeat> seats;
  MIROCUP_TRY(const auto isolation, plugins::strongest_isolation());
  plugins::ProcessTerms terms;
  terms.isolation = isolation;
  for (const Team team : both_teams) {
    MIROCUP_TRY(auto seat, server::TeamSeat::take_in_process(choices[index_of(team)],
                                                             match.briefing(team), terms));
    seats.push_back(std::move(seat));
  }
  server::wait_until_ready(seats, match, &interrupt);
  while (!match.is_over()) {
    if (interrupt.is_asked_for()) return fail(Errc::interrupted, "interrupted");
    const std::size_t before = match.log().size();
    match.advance(seats[0].controller(), seats[1].controller());
    if (match.log().size() == before) break;  // a fault
    if (auto difference = compare_commands(recording, match)) return difference;
  }
  if (match.outcome().kind == match::OutcomeKind::void_) {
    return fail(Errc::host, match.outcome().why_void);
  }
  return compare_ends(recording, match);
}

void report(const RerunOptions& options, const std::optional<CommandDifference>& difference) {
  if (options.json) {
    record::Json answer{{"record", options.record}, {"reproduced", !difference}};
    answer["tick"] = difference ? record::Json(difference->tick) : record::Json();
    answer["team"] = difference && difference->team ? record::Json(to_string(*difference->team))
                                                    : record::Json();
    answer["what"] = difference ? record::Json(difference->what) : record::Json();
    print_json(answer);
  } else if (difference) {
    const std::string team =
        difference->team ? std::string(to_string(*difference->team)) + ": " : std::string();
    std::cout << system::printable(options.record) << ": differs from tick " << difference->tick
              << " on: " << team << system::printable(difference->what) << '\n';
  } else {
    std::cout << system::printable(options.record) << ": both teams give the recorded commands\n";
  }
}

Result<int> run_rerun(const RerunOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto record, record::load(disk, options.record));
  if (record.recording.outcome.kind == match::OutcomeKind::void_) {
    return fail(Errc::input, options.record + ": the leg is void, there is nothing to run again");
  }
  std::vector<server::TeamChoice> choices;
  for (const record::TeamInfo& team : record.teams) {
    MIROCUP_TRY(auto choice, choose_again(disk, team, options));
    choices.push_back(std::move(choice));
  }
  MIROCUP_TRY(const auto difference,
              play_again(record.recording, record.from ? record.from->tick : 0, choices));
  if (difference && record::has_other_behaviour(record)) {
    return tl::unexpected(record::behaviour_mismatch(options.record, record, difference->tick));
  }
  report(options, difference);
  return difference ? exit_no : exit_yes;
}

}  // namespace

void add_rerun(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_rerun, "rerun", after_a_leg,
                   "Let the teams of a record play again and compare their commands",
                   {"mirocup rerun leg.json --entries teams"});
  command.option("RECORD", o.record, "Match record").required();
  command.option("--entries DIR", o.entries,
                 "Folder with the teams' libraries, which are found by their sha256 (default: "
                 "the entries of the league that the record belongs to)");
  command.flag("--json", o.json, "Print the answer as one JSON object");
}

}  // namespace mirocup::app
