// SPDX-License-Identifier: MIT
//
// mirocup league index: the front page of the leagues of a host.
#include "programs/league/commands.hpp"
#include "system/text.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/site.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

struct IndexOptions {
  std::string folder;
  std::string title = "Leagues";
  bool is_static = false;  // links lead to the pages that publish has made
};

// A page that this command has made begins with it.
constexpr std::string_view mark = "<!-- mirocup league index -->\n";

// Says no number of legs, which a league may hide.
Json league_values(const IndexOptions& options, const std::string& name, const LeagueState& state) {
  const std::string page = options.is_static ? "site/index.html" : "";
  return {{"page", system::percent_coded(name) + "/" + page},
          {"title", state.file.title},
          {"teams", state.teams.size()},
          {"state", !state.is_started ? "not started"
                    : state.is_closed ? "closed"
                                      : "in play"}};
}

Result<int> run_index(const IndexOptions& options) {
  system::Disk disk;
  const std::string path = options.folder + "/index.html";
  MIROCUP_TRY(const auto known, disk.read_if_there(path, {.max_size = system::size_limit::page}));
  if (known && !known->starts_with(mark))
    return fail(Errc::input,
                path + " was not made by this command: move it away, or name another folder");
  MIROCUP_TRY(const auto names, disk.names_in(options.folder));
  Json leagues = Json::array();
  int result = exit_yes;
  for (const std::string& name : names) {
    const Folder folder{options.folder + "/" + name};
    std::error_code why;
    const bool is_league = std::filesystem::is_regular_file(folder.config(), why);
    if (why == std::errc::permission_denied) {
      std::cerr << "mirocup: " << folder.path << " is left out: you may not read it\n";
      result = exit_no;
    }
    if (!is_league) continue;
    MIROCUP_TRY(const auto store, LeagueStore::open(disk, folder));
    leagues.push_back(league_values(options, name, store.state()));
  }
  if (leagues.empty()) return fail(Errc::input, options.folder + " has no folder of a league");
  const std::string content = filled_page("leagues.html", {{"leagues", leagues}});
  const std::string html = filled_page("plain.html", {{"root", ""},
                                                      {"league", options.title},
                                                      {"page_title", options.title},
                                                      {"heading", options.title},
                                                      {"content", content}});
  MIROCUP_TRY_VOID(disk.write(options.folder + "/style.css", site_style()));
  MIROCUP_TRY_VOID(disk.write(options.folder + "/site.js", std::string(page_file("site.js"))));
  MIROCUP_TRY_VOID(disk.write(path, std::string(mark) + html));
  std::cout << path << ": " << leagues.size() << (leagues.size() == 1 ? " league\n" : " leagues\n");
  return result;
}

}  // namespace

void add_index(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_index, "index", to_show, "Write the front page of the leagues of a host",
                   {"mirocup league index /srv/leagues --title \"Robot soccer\""});
  command.option("DIR", o.folder, "Folder with a folder for each league")
      .required()
      .checked("DIR", problem_with_folder);
  command.option("--title TEXT", o.title, "Title of the page").shows_default();
  command.flag("--static", o.is_static,
               "Link to the pages that publish has made (default: to DIR/, where a proxy shows "
               "league serve)");
}

}  // namespace mirocup::league
