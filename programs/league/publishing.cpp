// SPDX-License-Identifier: MIT
#include "programs/league/publishing.hpp"

#include "record/match_record.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/site.hpp"
#include "tournaments/publish/snapshot.hpp"
#include "web/page.hpp"
#include "web/playground.hpp"

#include <filesystem>
#include <iostream>
#include <set>
#include <vector>

namespace mirocup::league {

std::function<std::string()> playground_maker(system::Files& files) {
  if (!files.exists(system::browser_folder() + "/mirocup.wasm")) return nullptr;
  return [&files] {
    auto page = web::playground_page(files);
    return page && *page ? std::move(**page) : std::string();
  };
}

PageParts page_parts(system::Files& files) {
  PageParts parts;
  for (web::ScriptFile& file : web::page_files())
    parts.page.push_back({std::move(file.name), std::move(file.text)});
  const auto module = web::browser_module(files).value_or(std::nullopt);
  if (!module) return parts;
  web::ScriptFile script = web::module_file(*module);
  parts.module = {std::move(script.name), std::move(script.text)};
  return parts;
}

Result<std::optional<Night>> night_for(const LeagueState& shown, const LeagueStore& store) {
  if (!sees_nights(Viewer::visitor, store.state())) return std::optional<Night>();
  return last_night(shown, store.journal());
}

std::string type_of(const std::string& path) {
  const std::string end = std::filesystem::path(path).extension();
  if (end == ".html") return "text/html; charset=utf-8";
  if (end == ".json") return "application/json";
  if (end == ".csv") return "text/csv; charset=utf-8";
  if (end == ".css") return "text/css; charset=utf-8";
  if (end == ".js") return "text/javascript; charset=utf-8";
  return "application/octet-stream";
}

Result<Gaps> say_gaps(system::Files& files, const LeagueStore& store) {
  MIROCUP_TRY(auto found, gaps(files, store, is_being_played(store.folder())));
  for (const std::string& sentence : found.in_words())
    std::cerr << "mirocup: " << system::printable(sentence) << '\n';
  return found;
}

// Makes the folder of the pages. A league.json may come from a stranger, so a folder elsewhere must
// be there, and be empty or have the pages of a league.
static Result<void> open_site(system::Files& files, const Folder& folder) {
  const std::string site = folder.site();
  if (!folder.has_site_elsewhere()) return files.make_folder(site);
  const std::string named = folder.config() + ": /site: " + site;
  if (!files.exists(site))
    return fail(Errc::unavailable, named + " is not there: make the folder, or mount its disk");
  const std::string script = site + "/site.js";
  MIROCUP_TRY(const auto names, files.names_in(site));
  if (names.empty()) return files.write(script, page_file("site.js"));
  MIROCUP_TRY(const auto text, files.read_if_there(script, {.max_size = system::size_limit::page}));
  constexpr std::string_view ours = "// What the pages of a league can do";
  if (text && text->find(ours) != std::string::npos) return {};
  return fail(Errc::input, named + " has other files than pages of a league: name an empty folder");
}

// Returns the records of the legs that count and of which something is not known.
static std::vector<std::string> uncounted_records(const Overview& o) {
  std::vector<std::string> records;
  for (const LegView& leg : o.legs) {
    const bool is_known = leg.report != nullptr && leg.facts != nullptr;
    if (leg.has_replay() && !leg.is_annulled && !is_known) records.push_back(leg.played->record);
  }
  return records;
}

static Result<int> publish_site(system::Files& files, const Folder& folder, LeagueState shown,
                                const std::optional<Night>& night, int jobs) {
  MIROCUP_TRY_VOID(open_site(files, folder));
  // What was told before may not be released any more.
  for (const std::string part : {"", "digests/"}) {
    if (night) break;
    MIROCUP_TRY_VOID(remove_former_pages(files, folder.site(), part, {playground_name}));
  }
  for (const char* part : {"/teams", "/rounds", "/digests"}) {
    if (part == std::string("/digests") && !night) continue;
    MIROCUP_TRY_VOID(files.make_folder(folder.site() + part));
  }
  for (const std::string& path : {folder.path, folder.site()})
    MIROCUP_TRY_VOID(files.remove_unfinished(path));
  // First what takes long: the pages of league and teams show the statistics of every leg.
  PageParts parts = page_parts(files);
  if (!shown.file.has_proofs) parts.module.reset();
  MIROCUP_TRY(auto legs, publish_legs(files, folder, shown, parts, jobs));
  const bool has_refused = !legs.refused.empty();
  const Site site({.state = std::move(shown),
                   .legs = std::move(legs.known),
                   .night = has_refused ? std::nullopt : night,
                   .playground = playground_maker(files)});
  const std::vector<std::string> names = site.names();
  for (const std::string& name : names)
    MIROCUP_TRY_VOID(files.update(folder.site() + "/" + name, *site.file(name)));
  // Rounds and nights that are not shown any more, teams that joined after those that are, and the
  // playground of another program.
  const std::set<std::string> made(names.begin(), names.end());
  for (const std::string part : {"", "digests/", "rounds/", "teams/"})
    MIROCUP_TRY_VOID(remove_former_pages(files, folder.site(), part, made));
  if (!legs.without_page.empty())
    std::cerr << "mirocup: " << legs.without_page.size()
              << " replay pages could not be made: " << listed(legs.without_page)
              << "; mirocup replay RECORD says why\n";
  const std::vector<std::string> uncounted = uncounted_records(site.overview());
  if (!uncounted.empty())
    std::cerr << "mirocup: statistics and goals lack " << uncounted.size()
              << " legs: " << listed(uncounted) << "; mirocup league verify says why\n";
  for (const std::string& record : legs.refused) {
    std::cerr << "mirocup: " << system::printable(folder.path + "/" + record)
              << " differs from its replay or from the journal, so the pages lack its leg; mirocup "
                 "league verify says more, and mirocup league void has the leg played again\n";
  }
  return legs.without_page.empty() && uncounted.empty() && !has_refused ? exit_yes : exit_no;
}

Result<int> publish_league(system::Files& files, const Folder& folder, int jobs) {
  MIROCUP_TRY(const auto store, LeagueStore::open(files, folder));
  MIROCUP_TRY(const auto found, say_gaps(files, store));
  if (!found.lost.empty()) {
    std::cerr << "mirocup: the pages stay as they are\n";
    return exit_no;
  }
  MIROCUP_TRY(const auto shown, released_state(store.state(), store.journal()));
  MIROCUP_TRY(const auto night, night_for(shown, store));
  MIROCUP_TRY(const int published, publish_site(files, store.folder(), shown, night, jobs));
  return found.is_whole() ? published : exit_no;
}

}  // namespace mirocup::league
