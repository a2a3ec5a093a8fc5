// SPDX-License-Identifier: MIT
//
// mirocup grade: the scores of entries in a sheet of exercises.
#include "programs/mirocup/commands.hpp"
#include "programs/mirocup/sheet_report.hpp"
#include "programs/mirocup/tested_teams.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <unistd.h>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;

struct GradeOptions : DrillTerms {
  std::string sheet;                 // "list", a name, or a path
  std::vector<std::string> entries;  // teams, and folders of leagues
  std::string seed_file;             // "": the public tries
  bool json = false;
  bool csv = false;
  bool gradescope = false;
};

// With fewer bytes the tries could be guessed.
constexpr std::size_t shortest_secret = 16;

Result<drills::Sheet> read_sheet(const std::string& path) {
  MIROCUP_TRY(const auto text, system::Disk().read_named(path, system::size_limit::note));
  return drills::parse_sheet(text, path);
}

Result<int> list_sheets() {
  const std::string folder = system::course_folder();
  MIROCUP_TRY(const auto names, system::Disk().names_in(folder));
  for (const std::string& name : names) {
    if (!name.ends_with(".json")) continue;
    MIROCUP_TRY(const auto sheet, read_sheet(folder + "/" + name));
    std::cout << sheet.name << "  " << sheet.title << "; start in " << folder << '/' << sheet.name
              << '\n';
  }
  return exit_yes;
}

// A team is a file.
bool is_league(const std::string& word) {
  std::error_code none;
  return fs::is_directory(word, none);
}

// Returns a path beside the sheet, if the word is one, or the word.
std::string beside(const std::string& sheet, const std::string& word) {
  const std::string path = (fs::path(sheet).parent_path() / word).string();
  return system::Disk().exists(path) ? path : word;
}

Result<std::vector<drills::Drill>> read_drills_of(const drills::Sheet& sheet,
                                                  const std::string& path) {
  std::vector<drills::Drill> drills;
  for (const drills::SheetDrill& one : sheet.drills) {
    const std::string own = beside(path, one.drill);
    const std::string file =
        own != one.drill ? own : (fs::path(system::drill_folder()) / (own + ".json")).string();
    const std::string at = path + ": /drills/" + std::to_string(drills.size()) + ": ";
    const auto named = [&at](const Error& error) { return Error{Errc::input, at + error.what}; };
    MIROCUP_TRY(const auto text,
                system::Disk().read_named(file, system::size_limit::note).map_error(named));
    MIROCUP_TRY(auto drill, drills::parse_changed_drill(text, file, one).map_error(named));
    drills.push_back(std::move(drill));
  }
  return drills;
}

// Start and reference are tried with the same seeds as the entries, so the scale is never stale.
Result<SheetScale> measured_scale(const drills::Sheet& sheet, const std::string& path,
                                  const std::vector<drills::Drill>& drills, DrillTerms terms) {
  terms.replay_folder = "";
  std::vector<TestedTeam> ends;
  for (const auto& [key, word] :
       {std::pair(": /start: ", sheet.start), {": /reference: ", sheet.reference}}) {
    auto team = tested_team(beside(path, word), NamedAfter::file);
    const std::string why = team ? team->fault : team.error().what;
    if (!why.empty()) return fail(Errc::input, path + key + why);
    ends.push_back(std::move(*team));
  }
  MIROCUP_TRY(auto reports, try_drills(ends, drills, {}, {}, terms));
  for (std::size_t i = 0; i < drills.size(); ++i) {
    if (score_of(reports[1].tries[i]).value <= score_of(reports[0].tries[i]).value)
      return fail(Errc::input, path + ": /drills/" + std::to_string(i) +
                                   ": the reference has no more marks than the start");
  }
  return SheetScale{std::move(reports[0]), std::move(reports[1])};
}

// An entry that cannot be tried has the reason as its fault.
Result<TestedTeam> entry_of(const std::string& text) {
  auto team = tested_team(text, NamedAfter::file);
  if (team || (team.error().code != Errc::input && team.error().code != Errc::unavailable))
    return team;
  return TestedTeam{text, split_team(text).first, team.error().what};
}

Result<std::vector<TestedTeam>> entries_of(const GradeOptions& options, const std::string& sheet) {
  std::vector<TestedTeam> entries;
  for (const std::string& word : options.entries) {
    if (!is_league(word)) {
      MIROCUP_TRY(auto entry, entry_of(word));
      entries.push_back(std::move(entry));
      continue;
    }
    MIROCUP_TRY(const auto of_league, entries_of_league(word, sheet));
    for (const auto& [team, path] : of_league) {
      entries.push_back({"", team, "no entry was accepted"});
      if (path.empty()) continue;
      MIROCUP_TRY(entries.back(), entry_of(team + "=" + path));
    }
  }
  std::set<std::string> names;
  for (const TestedTeam& entry : entries) {
    if (!names.insert(entry.name).second)
      return fail(Errc::input, "two entries are called \"" + entry.name +
                                   "\": NAME=ENTRY gives an entry another name");
  }
  return entries;
}

// Returns what the source of an entry has that the sheet does not allow; "" if it has nothing, or
// is not at hand: a file of Python is its own source, and a league keeps that of a library.
std::string misuse(const drills::Sheet& sheet, const std::string& entry) {
  const std::string path = split_team(entry).second;
  const std::string beside_it = (fs::path(path).parent_path() / "source").string();
  const bool is_kept =
      fs::path(path).filename() == "strategy.so" && system::Disk().exists(beside_it);
  const auto source =
      system::Disk().read_named(is_kept ? beside_it : path, system::size_limit::note);
  const std::string found = source ? drills::found_word(*source, sheet.not_allowed) : "";
  return found.empty() ? "" : found + ", which the sheet does not allow";
}

Result<std::uint64_t> first_seed(const GradeOptions& options, const std::string& sheet) {
  if (options.seed_file.empty()) return options.first_seed;
  MIROCUP_TRY(const auto secret,
              system::Disk().read_named(options.seed_file, system::size_limit::note));
  if (secret.size() < shortest_secret)
    return fail(Errc::input, options.seed_file + ": at least 16 bytes are needed: " +
                                 "head -c 24 /dev/urandom | base64");
  // 52 bits, which all readers of JSON keep. Each sheet has tries of its own, so seeds of a sheet
  // may be published when it is over.
  return std::stoull(system::sha256(sheet + "\n" + secret).substr(0, 13), nullptr, 16);
}

// Prints a row for each student of a league in Gradescope's columns.
Result<int> print_by_student(const std::string& league, const std::string& csv) {
  MIROCUP_TRY(const auto file, system::sealed_copy(csv));
  const std::string path =
      "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(file.get());
  return system::run_child({.arguments = {system::sibling_program("mirocup-league"), "grades",
                                          league, "--drills", path, "--gradescope"}});
}

Result<int> run_grade(const GradeOptions& options) {
  if (options.sheet == "list") return list_sheets();
  if (options.entries.empty())
    return fail(Errc::input, "an entry is needed: mirocup grade SHEET ENTRY");
  if (options.gradescope && !is_league(options.entries.front()))
    return fail(Errc::input, "--gradescope is for a league, whose class list has the students");
  const std::string own = system::course_folder() + "/" + options.sheet + ".json";
  const bool is_own = options.sheet.find('/') == std::string::npos && system::Disk().exists(own);
  const std::string path = is_own ? own : options.sheet;
  if (!system::Disk().exists(path))
    return fail(Errc::input, "\"" + path +
                                 "\" is neither a sheet nor a file; mirocup grade list prints "
                                 "all names of sheets");
  MIROCUP_TRY(const auto sheet, read_sheet(path));
  MIROCUP_TRY(const auto drills, read_drills_of(sheet, path));
  MIROCUP_TRY(const auto entries, entries_of(options, sheet.name));
  DrillTerms terms = options;
  MIROCUP_TRY(terms.first_seed, first_seed(options, sheet.name));
  MIROCUP_TRY(const auto scale, measured_scale(sheet, path, drills, terms));
  MIROCUP_TRY(const auto reports, try_drills(entries, drills, {}, {}, terms));
  record::Json json = sheet_json(sheet, terms.first_seed, scale, reports);
  bool has_notes = false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    record::Json& note = json["teams"][i]["note"];
    if (note.is_null()) note = record::or_null(misuse(sheet, entries[i].text));
    has_notes = has_notes || !note.is_null();
  }
  if (options.gradescope) return print_by_student(options.entries.front(), sheet_csv(json));
  std::cout << (options.csv    ? sheet_csv(json)
                : options.json ? record::json_text(json) + "\n"
                               : sheet_text(json));
  return has_notes ? exit_no : exit_yes;
}

}  // namespace

void add_grade(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_grade, "grade", for_teams,
                   "Print the score of entries in a sheet of exercises, or list the sheets",
                   {"mirocup grade list", "mirocup grade driving mine.so --replay failed",
                    "mirocup grade driving spring --seed-file secret --csv"});
  command.option("SHEET", o.sheet, "list, the name of a sheet, or the path of a sheet's file")
      .required();
  command.option("ENTRY", o.entries,
                 "Teams to be graded: paths of libraries or of files of Python, names of house "
                 "teams, or the folder of a league; NAME=ENTRY: the name in the report");
  command.option("--seed-file FILE", o.seed_file,
                 "File from whose bytes the seeds of the tries are drawn, which students must not "
                 "know (default: the public tries, the seeds from 1)");
  command.jobs(o.jobs, "tries");
  command.option("--replay DIR", o.replay_folder,
                 "Folder to write files to: a record and a page of each failed try, and "
                 "index.html, which lists the failed tries");
  const system::Option csv = command.flag("--csv", o.csv, "Print a line of CSV for each entry");
  const system::Option json = command.flag("--json", o.json, "Print one JSON object");
  json.excludes(csv);
  command
      .flag("--gradescope", o.gradescope,
            "Print CSV in Gradescope's columns, for a league: a row for each student")
      .excludes(csv)
      .excludes(json);
}

}  // namespace mirocup::app
