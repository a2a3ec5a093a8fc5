// SPDX-License-Identifier: MIT
//
// mirocup league export: table, legs and bracket as files, or the sources of the teams.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "system/locations.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/publish/exports.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

namespace fs = std::filesystem;

using system::Readers;

// Returns how the team has called its file; "" if that is not known.
std::string name_of_file(system::Files& files, const Folder& folder, const std::string& team,
                         int entry) {
  const auto text = files.read(folder.verdict(team, entry), {.max_size = system::size_limit::note});
  if (!text) return "";
  return record::text_in(record::parse_json(*text).value, "file");
}

// Writes the sources of an entry into a folder of the team. Returns what was written, or why
// nothing was: words for a person.
Result<std::string> write_sources(system::Files& files, const Folder& folder,
                                  const std::string& team, int entry, const std::string& to) {
  const system::ReadOptions any_entry{.max_size = system::size_limit::entry};
  std::string name = name_of_file(files, folder, team, entry);
  MIROCUP_TRY(auto source, files.read_if_there(folder.source(team, entry), any_entry));
  if (!source) {
    MIROCUP_TRY(source, files.read_if_there(folder.library(team, entry), any_entry));
    if (!source || source->starts_with("\177ELF")) return "a library without its source";
    name = "team.py";
  }
  MIROCUP_TRY_VOID(files.make_folder(to, Readers::owner));
  // A stranger's archive is unpacked in a sandbox or by a person, and not by this process.
  const bool is_packed = source_kind_of(name) == SourceKind::project;
  const std::string file =
      (is_packed ? "project" : "team") + (is_packed && name.ends_with(".tar.gz")
                                              ? std::string(".tar.gz")
                                              : fs::path(name).extension().string());
  MIROCUP_TRY_VOID(files.write(to + "/" + file, *source, Readers::owner));
  return is_packed ? file + ", to be unpacked" : file;
}

// README's first block of C++ is a team with which many begin.
std::string team_of_readme() {
  constexpr std::string_view begin = "```cpp\n";
  const std::string_view text = given_file("README.md");
  const std::size_t at = text.find(begin);
  if (at == std::string_view::npos) return "";
  const std::size_t first = at + begin.size();
  return std::string(text.substr(first, text.find("```", first) - first));
}

// Writes the files that `mirocup new` makes in each language, and the README's team.
Result<void> write_base(system::Files& files, const std::string& to) {
  std::error_code missing;
  for (const auto& language : fs::directory_iterator(system::team_kit().templates, missing)) {
    const std::string folder = to + "/" + language.path().filename().string();
    MIROCUP_TRY_VOID(files.make_folder(folder, Readers::owner));
    for (const auto& file : fs::directory_iterator(language.path(), missing)) {
      MIROCUP_TRY(const auto text,
                  files.read_named(file.path().string(), system::size_limit::system_file));
      MIROCUP_TRY_VOID(files.write(folder + "/" + file.path().filename().string(), text));
    }
  }
  MIROCUP_TRY_VOID(files.make_folder(to + "/readme", Readers::owner));
  return files.write(to + "/readme/mine.cpp", team_of_readme());
}

// Writes the sources of the entries that play, or will play next, into a new or empty folder that
// only this user can read, and prints a line for each team. Errors: Errc::input if the folder is
// not empty.
Result<void> export_sources(system::Files& files, const LeagueStore& store,
                            const std::string& output) {
  MIROCUP_TRY(const auto there, files.names_if_there(output));
  if (!there.empty())
    return fail(Errc::input, output + ": there is something in it already; name a new folder");
  MIROCUP_TRY_VOID(files.make_folder(output, Readers::owner));
  MIROCUP_TRY_VOID(files.make_folder(output + "/submissions", Readers::owner));
  MIROCUP_TRY_VOID(write_base(files, output + "/base"));
  MIROCUP_TRY(const auto book, Book::open(files, store.folder()));
  MIROCUP_TRY(const auto rows, roster(files, store, book.hand_ins()));
  for (const RosterRow& row : rows) {
    if (row.is_house) continue;
    const int entry = row.last_accepted > 0 ? row.last_accepted : row.playing_entry;
    std::string what = "no accepted entry";
    if (entry > 0) {
      MIROCUP_TRY(what, write_sources(files, store.folder(), row.team, entry,
                                      output + "/submissions/" + row.team));
    }
    std::cout << row.team << ": " << system::printable(what) << '\n';
  }
  return {};
}

struct ExportOptions : LeagueOptions {
  std::string output = "export";
  bool sources = false;
};

Result<int> run_export(system::Files& files, const LeagueStore& store,
                       const ExportOptions& options) {
  MIROCUP_TRY(const auto found, say_gaps(files, store));
  const int result = found.is_whole() ? exit_yes : exit_no;
  if (options.sources) {
    MIROCUP_TRY_VOID(export_sources(files, store, options.output));
    return result;
  }
  MIROCUP_TRY_VOID(files.make_folder(options.output));
  const Overview overview = league::overview(store.state());
  for (const auto& [name, make] : exports(overview)) {
    const std::string path = options.output + "/" + name;
    MIROCUP_TRY_VOID(files.write(path, make()));
    std::cout << path << '\n';
  }
  return result;
}

}  // namespace

void add_export(system::Commands& commands) {
  const auto [command, o] = add_command(commands, on_league<run_export, ExportOptions>, "export",
                                        to_show, "Write table, legs and bracket as files",
                                        {"mirocup league export spring -o tables",
                                         "mirocup league export spring --sources -o sources"});
  command.option("-o,--output DIR", o.output, "Folder for the files")
      .shows_default()
      .checked("DIR", problem_with_folder);
  command.flag("--sources", o.sources,
               "Write the sources of the teams, and the code that all teams were given, for JPlag");
}

}  // namespace mirocup::league
