// SPDX-License-Identifier: MIT
#include "programs/mirocup/tested_teams.hpp"

#include "plugins/host/sandbox/probe.hpp"
#include "record/json_reader.hpp"
#include "system/child_process.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/text.hpp"

#include <filesystem>
#include <iostream>
#include <unistd.h>

namespace mirocup::app {

namespace {

// `what` stands before `text` in the sentence about a team that is on the network.
Result<server::TeamChoice> choose(const std::string& text, const std::string& what) {
  const auto [name, team] = split_team(text);
  auto choice = server::choose_team(team);
  if (choice && team != text) choice->info.name = name;
  if (choice && record::is_on_network(choice->info.kind)) {
    return fail(Errc::input, what + text + ": drills are for libraries and house teams");
  }
  return choice;
}

Result<DrillTeams> teams_of(const drills::Drill& drill, const TestedTeam& team,
                            const match::TeamParameters& parameters) {
  MIROCUP_TRY(auto tested, choose(team.text, "TEAM "));
  DrillTeams teams{.tested = std::move(tested), .opponent = {}, .mates = std::nullopt};
  teams.tested.info.name = team.name;
  teams.tested.info.parameters = drill.parameters;
  for (const auto& [key, value] : parameters) teams.tested.info.parameters[key] = value;
  const auto choose_in_drill = [&drill](const std::string& text, const char* key) {
    return choose(text, "").map_error([&](const Error& error) {
      return Error{error.code, drill.name + ": " + key + ": " + error.what};
    });
  };
  MIROCUP_TRY(teams.opponent, choose_in_drill(drill.opponent, "/opponent"));
  if (drill.mates.empty()) return teams;
  MIROCUP_TRY(teams.mates, choose_in_drill(drill.mates, "/mates"));
  return teams;
}

}  // namespace

std::pair<std::string, std::string> split_team(const std::string& text) {
  const std::size_t equals = text.find('=');
  const bool is_named = equals != std::string::npos && equals < text.find('/');
  if (is_named) return {text.substr(0, equals), text.substr(equals + 1)};
  return {std::filesystem::path(text).stem().string(), text};
}

Result<TestedTeam> tested_team(const std::string& text, NamedAfter named_after) {
  MIROCUP_TRY(const auto choice, choose(text, "TEAM "));
  TestedTeam team{.text = text, .name = choice.info.name};
  if (choice.info.kind != record::TeamKind::plugin) return team;
  MIROCUP_TRY(const auto isolation, plugins::strongest_isolation());
  plugins::ProcessTerms terms;
  terms.isolation = isolation;
  const match::Leg leg(match::Setup{});
  MIROCUP_TRY(auto seat,
              server::TeamSeat::take_in_process(choice, leg.briefing(drills::tested), terms));
  const auto is_ready = seat.wait_until_ready();
  if (const auto* fault = is_ready ? nullptr : std::get_if<match::Fault>(&is_ready.error()))
    team.fault = fault_text(*fault);
  const std::string own = is_ready ? seat.own_name() : "";
  const bool is_named = split_team(text).second != text || named_after == NamedAfter::file;
  if (!is_named && !own.empty() && own.find('/') == std::string::npos) team.name = own;
  return team;
}

// Only mirocup-league can read a league.
Result<std::vector<LeagueEntry>> entries_of_league(const std::string& league,
                                                   const std::string& sheet) {
  const std::vector<std::string> words{system::sibling_program("mirocup-league"),
                                       "status",
                                       league,
                                       "--entries",
                                       "--json",
                                       "--sheet",
                                       sheet};
  MIROCUP_TRY(const auto answer, system::ask(words, {.seconds = 60.0}));
  const std::string last = system::last_line(answer.output);
  if (answer.code > exit_no) return fail(Errc::input, system::replaced(last, "mirocup: ", ""));
  return record::read_json<std::vector<LeagueEntry>>(
      last, league, Errc::input, [&](const record::JsonReader& json) {
        std::vector<LeagueEntry> entries;
        for (const record::JsonReader& team : json.at("teams").elements()) {
          entries.push_back({.team = team.at("team").text(), .path = {}});
          const record::JsonReader playing = team.at("plays_with");
          const record::JsonReader entry = team.has("by_deadline") ? team.at("by_deadline")
                                           : playing.is_null()     ? team.at("last_accepted")
                                                                   : playing;
          if (!entry.is_null())
            entries.back().path = league + "/entries/" + entries.back().team + '/' +
                                  std::to_string(entry.as<int>()) + "/strategy.so";
        }
        return entries;
      });
}

Result<std::vector<DrillReport>> try_drills(const std::vector<TestedTeam>& teams,
                                            const std::vector<drills::Drill>& drills,
                                            std::optional<int> tries,
                                            const match::TeamParameters& parameters,
                                            const DrillTerms& terms) {
  system::Disk disk;
  if (!terms.replay_folder.empty()) MIROCUP_TRY_VOID(disk.make_folder(terms.replay_folder));
  int all_tries = 0;  // of a team
  for (const drills::Drill& drill : drills) all_tries += tries.value_or(drill.tries);
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  std::vector<DrillReport> reports;
  for (const TestedTeam& team : teams) {
    const int before = all_tries * static_cast<int>(reports.size());
    DrillReport report;
    report.team = team.name;
    std::vector<DrillTask> tasks;
    for (const drills::Drill& drill : drills) {
      report.drills.push_back(&drill);
      if (!team.fault.empty()) {
        const auto seeds = static_cast<std::size_t>(tries.value_or(drill.tries));
        auto& untried = report.tries.emplace_back(seeds, PlayedTry{.fault = team.fault});
        for (std::size_t i = 0; i < seeds; ++i) untried[i].seed = terms.first_seed + i;
        continue;
      }
      MIROCUP_TRY(auto of_this, teams_of(drill, team, parameters));
      tasks.push_back({&drill, std::move(of_this), tries.value_or(drill.tries)});
    }
    if (!tasks.empty()) {
      auto played = play_drills(tasks, terms, [&](int done) {
        if (is_terminal)
          std::cerr << '\r' << before + done << " of " << all_tries * teams.size() << " tries"
                    << std::flush;
      });
      if (is_terminal) std::cerr << "\r\033[K" << std::flush;
      MIROCUP_TRY(report.tries, std::move(played));
    }
    reports.push_back(std::move(report));
  }
  if (!terms.replay_folder.empty()) {
    const std::string list = terms.replay_folder + "/index.html";
    MIROCUP_TRY_VOID(disk.write(list, failed_page(reports)));
    std::cerr << list << " lists the failed tries\n";
  }
  return reports;
}

}  // namespace mirocup::app
