// SPDX-License-Identifier: MIT
#include "programs/league/served_league.hpp"

#include "programs/league/publishing.hpp"
#include "record/answer.hpp"
#include "record/json_fields.hpp"
#include "system/text.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/play/leg_command.hpp"
#include "tournaments/publish/night_pages.hpp"
#include "tournaments/publish/snapshot.hpp"
#include "web/page_parts.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace mirocup::league {

namespace {

using namespace std::chrono_literals;

constexpr auto poll_interval = 500ms;

// While a class joins or a night is played, each new team and each leg changes all pages. To begin
// them anew takes one part in that many of the time, or more where the rest would grow too long.
constexpr int rest_factor = 20;
constexpr std::chrono::nanoseconds longest_rest = 5s;

// Content from this server only, and no code but its script.
constexpr const char* policy =
    "default-src 'none'; style-src 'self'; script-src 'self'; connect-src 'self'";

// Of the workers of the workbench. That which runs a team has no network.
constexpr const char* team_policy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'none'";
constexpr const char* compiler_policy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'";

std::string stem_of(const LegId& leg) {
  return std::filesystem::path(Folder::record_name(leg.fixture, leg.leg, leg.version)).stem();
}

constexpr const char* own_replays_root = "../../";  // of /hand-in/replays/NAME.html

std::string hand_in_link(const std::string& root) {
  return "<a href=\"" + root + "hand-in\">Hand in</a>";
}

// Gives the teams of a record the names that people know.
void name_teams(record::MatchRecord& record, const Json& part) {
  for (std::size_t i = 0; i < part["names"].size(); ++i) {
    if (const auto* name = part["names"][i].get_ptr<const std::string*>())
      record.teams[i].name = *name;
  }
}

std::string with_script(std::string html, bool takes_hand_ins, bool has_workbench,
                        const std::string& root) {
  constexpr std::string_view title_end = "</h1>\n";
  const std::size_t title = html.find(title_end);
  if (takes_hand_ins && title != std::string::npos)
    html.insert(title + title_end.size(),
                "<p>" + hand_in_link(root) +
                    (has_workbench ? " <a href=\"" + root + "workbench\">Workbench</a>" : "") +
                    "</p>\n");
  const std::size_t end = html.rfind("</body>");
  if (end == std::string::npos) return html;
  return html.insert(end, "<script type=\"module\" src=\"" + root + "league.js\"></script>\n");
}

}  // namespace

// Requires mutex_. Until the league starts, league.json may be edited; what people are called may
// change at any time.
void ServedLeague::notice_edits() {
  std::string said =
      files_.read(store_.folder().people(), {.max_size = system::size_limit::league_file})
          .value_or("") +
      read_notice(files_, store_.folder()).value_or("");
  const bool has_new_names = said != said_;
  if (store_.state().is_started && !has_new_names) return;
  const auto config = files_.read_named(store_.folder().config(), system::size_limit::league_file);
  if (!config || (*config == config_ && !has_new_names)) return;
  if (!open_again()) return;
  config_ = *config;
  said_ = std::move(said);
}

// Requires mutex_. What shows fixtures before the start plans them itself.
bool ServedLeague::open_again() {
  auto fresh = LeagueStore::open_unplanned(files_, store_.folder());
  if (!fresh) return false;
  store_ = std::move(*fresh);
  ++teams_version_;
  return true;
}

// Requires mutex_. A file that cannot be read leaves the state as it was.
void ServedLeague::poll() {
  const auto now = std::chrono::steady_clock::now();
  const bool has_written = has_written_.exchange(false);
  if (version_ > 0 && !has_written && now - polled_at_ < poll_interval) return;
  polled_at_ = now;
  const std::size_t decisions = store_.state().decisions.size();
  notice_edits();
  const std::size_t teams = store_.state().teams.size();
  (void)store_.refresh();
  if (store_.state().teams.size() != teams) open_again();  // with what people call the new ones
  if (has_written || store_.state().decisions.size() != decisions) pages_rest_until_ = {};
  std::vector<LiveLeg> playing = find_live_legs();
  lines_ = store_.lines();
  if (version_ == 0 || playing != live_legs_) ++version_;
  live_legs_ = std::move(playing);
}

std::vector<ServedLeague::LiveLeg> ServedLeague::find_live_legs() const {
  const LeagueState& state = store_.state();
  std::vector<LiveLeg> playing;
  if (!state.is_started || !sees_all(Viewer::visitor, state)) return playing;
  for (std::size_t i = state.first_open(); i < state.fixtures.size(); ++i) {
    const FixtureState& f = state.fixtures[i];
    for (const int number : open_legs(state, f)) {
      const LegId leg{f.fixture, number, f.legs[number - 1].version};
      const auto answer = record::last_answer(files_, leg_answer(store_.folder(), leg));
      const int port = answer ? record::value_in(*answer, "port", 0) : 0;
      if (port == 0 || !web::is_watched_at(port)) continue;
      const auto [blue, yellow] = leg.fixture.colours(number);
      playing.push_back({stem_of(leg),
                         {{"name", stem_of(leg)},
                          {"fixture", leg.fixture.id()},
                          {"leg", number},
                          {"blue", state.shown_name(blue)},
                          {"yellow", state.shown_name(yellow)}},
                         port});
    }
  }
  return playing;
}

// Requires mutex_.
bool ServedLeague::are_pages_fresh() const {
  return site_ && lines_of_pages_ == lines_ && version_of_pages_ == teams_version_;
}

// Requires mutex_. The number of the journal's lines would tell how many hidden legs were played.
void ServedLeague::note_what_is_shown() {
  const LeagueState& state = site_->state();
  const std::string shown = system::formatted(
      "%d.%zu.%zu.%zu.%zu.%d.%ju", state.played(), state.decisions.size(), state.nights.size(),
      state.fixtures.size(), state.teams.size(), state.is_started, version_of_pages_);
  if (shown != shown_) ++version_;
  shown_ = shown;
}

// Requires mutex_. Each page is made when it is asked for.
void ServedLeague::begin_pages() {
  const auto begun = std::chrono::steady_clock::now();
  if (are_pages_fresh() || (site_ && begun < pages_rest_until_)) return;
  lines_of_pages_ = lines_;
  version_of_pages_ = teams_version_;
  pages_.clear();
  // What cannot be shown alone, such as a round that does not exist any more, is not shown at all.
  auto released = released_state(store_.state(), store_.journal());
  LeagueState shown = released ? std::move(*released) : unplanned_league(store_.state().file);
  plan(shown);
  auto night = night_for(shown, store_).value_or(std::nullopt);
  read_legs(files_, store_.folder(), shown, legs_);
  site_ = std::make_unique<Site>(SiteSource{.state = std::move(shown),
                                            .legs = legs_,
                                            .night = std::move(night),
                                            .playground = playground_maker(files_),
                                            .closing_page = "final/site/index.html"});
  note_what_is_shown();
  records_.clear();
  for (const FixtureState& f : site_->state().fixtures) {
    for (int leg = 1; leg <= max_legs; ++leg) {
      const LegState& now = f.legs[leg - 1];
      const int versions =
          now.played && !now.played->record.empty() ? now.version : now.version - 1;
      for (int version = 1; version <= versions; ++version)
        records_.insert(stem_of({f.fixture, leg, version}));
    }
  }
  const auto ended = std::chrono::steady_clock::now();
  pages_rest_until_ = ended + std::min(rest_factor * (ended - begun), longest_rest);
}

// Requires mutex_. Returns null if the site has no such page.
const web::Page* ServedLeague::page_of_site(const std::string& path) {
  if (!path.starts_with('/')) return nullptr;
  begin_pages();
  if (const auto found = pages_.find(path); found != pages_.end()) return &found->second;
  const std::string name = path == "/" ? "index.html" : path.substr(1);
  if (name == "league.js" || (takes_hand_ins_ && name == "hand_in.js"))
    return &(pages_[path] = {type_of(name), "", std::string(web::asset(name))});
  auto bytes = site_->file(name);
  if (!bytes) return nullptr;
  const std::string type = type_of(name);
  const bool is_html = type.starts_with("text/html") && name != playground_name;
  return &(pages_[path] = {type, is_html ? policy : "",
                           is_html ? with_script(std::move(*bytes), takes_hand_ins_,
                                                 !workbench().empty(), web::root_of(path))
                                   : *bytes});
}

std::optional<web::Page> ServedLeague::page(const std::string& path) {
  if (path == "/favicon.ico") {  // browsers ask for it; the ball
    return web::Page{"image/svg+xml", "",
                     "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16'>"
                     "<circle cx='8' cy='8' r='7' fill='#f58220'/></svg>"};
  }
  std::string stem;
  {
    const std::lock_guard lock(mutex_);
    poll();
    if (const web::Page* made = page_of_site(path)) return *made;
    if (path.starts_with("/workbench")) return workbench_page(path.substr(1));
    if (path.starts_with("/module/")) return module_page(path.substr(1));
    if (path.starts_with("/final/site/") && !site_->state().closing_round.empty())
      return page_of_closing_round(path.substr(std::string_view("/final/site/").size()));
    // Only files that the journal names are read from disk.
    const std::filesystem::path file(path);
    stem = file.filename();
    stem = stem.substr(0, stem.find('.'));
    if (!records_.contains(stem)) return std::nullopt;
  }
  if (path == "/replays/" + stem + ".html") return replay(stem);
  if (path == "/" + commands_file_of(stem)) return commands_page(stem);
  if (path != "/records/" + stem + ".json" && path != "/records/" + stem + ".replay.zst")
    return std::nullopt;
  return file(store_.folder().path + path);
}

// Returns a file of the league as it is; nothing if it cannot be read.
std::optional<web::Page> ServedLeague::file(const std::string& path) const {
  auto bytes = files_.read(path, {.max_size = system::size_limit::page});
  if (!bytes) return std::nullopt;
  return web::Page{type_of(path), "", std::move(*bytes)};
}

const PageParts& ServedLeague::parts() {
  std::call_once(parts_made_, [this] { parts_ = page_parts(files_); });
  return parts_;
}

// Returns how pages that are made now can be proved, by addresses below `root`; nothing if the host
// wants no proofs.
std::optional<web::Proof> ServedLeague::proof(const std::string& root,
                                              const std::string& commands_file) {
  {
    const std::lock_guard lock(mutex_);
    if (!store_.state().file.has_proofs) return std::nullopt;
  }
  if (!parts().module) return std::nullopt;
  return web::Proof{.module_file = root + parts().module->name, .commands_file = commands_file};
}

// Returns a file beside pages as publish has written it, also that of a program of before, or this
// one's.
std::optional<web::Page> ServedLeague::module_page(const std::string& name) {
  if (std::filesystem::path(name).lexically_normal() != name || std::ranges::count(name, '/') != 1)
    return std::nullopt;
  if (auto kept = file(store_.folder().site() + "/" + name)) return kept;
  for (const SiteFile& made : parts().all()) {
    if (made.name == name) return web::Page{type_of(name), "", made.bytes};
  }
  return std::nullopt;
}

// Returns a page of the closing round as it was published; links lead out of no folder.
std::optional<web::Page> ServedLeague::page_of_closing_round(const std::string& name) {
  const bool is_plain = std::filesystem::path(name).lexically_normal() == name;
  if (!is_plain || name.starts_with('.') || name.starts_with('/')) return std::nullopt;
  auto page = file(store_.folder().closing_round().site() + "/" + name);
  const bool has_own_script = name.starts_with("replays/") || name == playground_name;
  if (page && name.ends_with(".html") && !has_own_script) page->policy = policy;
  return page;
}

// Requires mutex_. Returns the files of the workbench; none if it was not built.
const std::vector<web::WorkbenchFile>& ServedLeague::workbench() {
  if (workbench_.empty())
    workbench_ = web::workbench_files(files_, "workbench/", takes_hand_ins_)
                     .value_or(std::vector<web::WorkbenchFile>{});
  return workbench_;
}

// Requires mutex_. The page has its policy inside, but for frames. Its workers run what is
// compiled, and get nothing from elsewhere.
std::optional<web::Page> ServedLeague::workbench_page(const std::string& name) {
  const auto& files = workbench();
  const auto found = std::ranges::find(files, name, &web::WorkbenchFile::name);
  if (found == files.end()) return std::nullopt;
  auto bytes = web::bytes_of(files_, *found);
  if (!bytes) return std::nullopt;
  const bool is_page = found == files.begin();
  return web::Page{.type = type_of(is_page ? "workbench.html" : name),
                   .policy = is_page                         ? "frame-ancestors 'none'"
                             : name.ends_with("/compile.js") ? compiler_policy
                                                             : team_policy,
                   .bytes = std::move(*bytes),
                   .is_for_ever = !is_page};
}

// Returns the commands of a leg for its page.
std::optional<web::Page> ServedLeague::commands_page(const std::string& stem) {
  const std::string record = "records/" + stem + ".json";
  const std::string name = commands_file_of(record);
  if (auto kept = file(store_.folder().site() + "/" + name)) return kept;
  if (!proof("")) return std::nullopt;
  const auto loaded = record::load(files_, store_.folder().path + "/" + record);
  if (!loaded) return std::nullopt;
  return web::Page{type_of(name), "", web::commands_script(*loaded)};
}

// Returns the page as publish has made it or would make it.
std::optional<web::Page> ServedLeague::replay(const std::string& stem) {
  const std::string record = "records/" + stem + ".json";
  const std::string html = replay_page_of(record);
  const Json part = part_of(record);
  if (has_page_with(files_, store_.folder(), record, part)) {
    if (auto kept = file(store_.folder().site() + "/" + html)) return kept;
  }
  const std::string commands = std::filesystem::path(commands_file_of(record)).filename();
  auto made =
      made_page(store_.folder().path + "/" + record, record::of_nobody, part, "../", commands);
  if (!made) return std::nullopt;
  return web::Page{type_of(html), "", std::move(*made)};
}

Json ServedLeague::part_of(const std::string& record) {
  const std::lock_guard lock(mutex_);
  begin_pages();
  return league_part(site_->overview(), record);
}

HandInTerms ServedLeague::hand_in_terms(const std::string& team, const std::string& now) {
  const std::lock_guard lock(mutex_);
  poll();
  return league::hand_in_terms(store_.state(), team, now);
}

// Requires mutex_, and is valid as long as the caller holds it.
SeenState ServedLeague::seen_by(Viewer viewer) {
  poll();
  begin_pages();
  return league::seen_by(viewer, store_.state(), site_->state());
}

std::vector<OwnLeg> ServedLeague::legs_of(Viewer viewer, const std::string& team) {
  const std::lock_guard lock(mutex_);
  return own_legs(seen_by(viewer), team);
}

std::string ServedLeague::digest_of(const std::string& team) {
  const std::lock_guard lock(mutex_);
  const SeenState seen = seen_by(Viewer::team);
  if (!sees_nights(Viewer::team, store_.state())) return "";
  const auto night = last_night(*seen, store_.journal());
  if (!night || !*night) return "";
  read_legs(files_, store_.folder(), *seen, legs_);
  const Overview o = overview(*seen, legs_);
  for (const TeamDigest& digest : digests(**night, o)) {
    if (seen->name(digest.team) == team) return digest_html(o, **night, digest, "hand-in/");
  }
  return "";
}

std::optional<std::string> ServedLeague::own_replay(const std::string& name,
                                                    const record::Whose& whose,
                                                    const std::string& links) {
  const std::string record = "records/" + name + ".json";
  Json part = part_of(record);
  // The page is shown at another address than that from which its links lead to the league.
  part["links"] =
      system::replaced(record::text_in(part, "links"), "href=\"", "href=\"../../replays/") + links;
  return made_page(store_.folder().path + "/" + record, whose, part, own_replays_root);
}

std::map<std::string, int> ServedLeague::booked_entries() {
  const std::lock_guard lock(mutex_);
  poll();
  std::map<std::string, int> entries;
  const LeagueState& state = store_.state();
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    const TeamConfig& team = state.file.teams[i];
    if (state.teams[i].status != TeamStatus::withdrawn && !team.is_on_network())
      entries[team.name] = state.teams[i].entry;
  }
  return entries;
}

std::vector<std::string> ServedLeague::neighbours_of(const std::string& team) {
  constexpr std::ptrdiff_t reach = 2;  // ranks
  const std::lock_guard lock(mutex_);
  const SeenState seen = seen_by(Viewer::visitor);
  const auto index = seen->find_team(team);
  if (!seen->is_started || !index) return {};
  const std::vector<TableRow> table = seen->table();
  const auto own = std::ranges::find(table, *index, &TableRow::team);
  if (own == table.end()) return {};
  std::vector<std::string> names;
  for (auto row = table.begin(); row != table.end(); ++row) {
    if (row != own && std::abs(row - own) <= reach) names.push_back(seen->name(row->team));
  }
  return names;
}

std::string ServedLeague::shown_name_of(const std::string& team) {
  const std::lock_guard lock(mutex_);
  poll();
  return store_.state().shown_name_of(team);
}

std::string ServedLeague::time_in_words(const std::string& utc) {
  const std::lock_guard lock(mutex_);
  return shown_time(store_.state().file, utc);
}

Json ServedLeague::sheets_of(const std::string& team) {
  const std::lock_guard lock(mutex_);
  poll();
  return sheets_of_team(files_, store_.folder(), store_.state().file, team).value_or(Json());
}

std::optional<std::string> ServedLeague::replay_of(const std::string& record,
                                                   const record::Whose& whose,
                                                   const std::string& root) {
  const std::string links =
      "<nav class=\"path\" aria-label=\"Back\">" + hand_in_link(root) + "</nav>";
  return made_page(record, whose, {{"links", links}, {"names", Json::array()}}, root);
}

// Makes the page of a record, with what the teams in `whose` may see, and with what the league puts
// on it (league_part()). `commands`: the file beside the page with the leg's commands; "": the page
// has them.
std::optional<std::string> ServedLeague::made_page(const std::string& record,
                                                   const record::Whose& whose, const Json& part,
                                                   const std::string& root,
                                                   const std::string& commands) {
  const std::lock_guard one_at_a_time(replaying_);
  auto loaded = record::load(files_, record);
  if (!loaded) return std::nullopt;
  name_teams(*loaded, part);
  const bool has_own = record::has_thoughts(files_, record, whose);
  const auto own = record::read_own_texts(files_, record, has_own ? whose : record::of_nobody);
  const auto proven = proof(root, commands);
  const bool has_wheels = proven && commands.empty();
  auto page = web::replay_page(*loaded, web::Times::left_out, own.value_or(record::OwnTexts{}),
                               proven, has_wheels ? web::Wheels::shown : web::Wheels::left_out,
                               record::text_in(part, "links"), root);
  if (!page) return std::nullopt;
  return std::move(page->html);
}

std::string ServedLeague::news(std::uint64_t& seen) {
  const std::lock_guard lock(mutex_);
  poll();
  begin_pages();
  // A viewer that is told asks for the page at once, and would get the former one.
  if (seen == version_ || !are_pages_fresh()) return "";
  seen = version_;
  Json playing = Json::array();
  for (const LiveLeg& leg : live_legs_) playing.push_back(leg.about);
  return web::event_text("league", {{"version", shown_}, {"playing", playing}});
}

std::optional<int> ServedLeague::match(const std::string& name) {
  const std::lock_guard lock(mutex_);
  poll();
  for (const LiveLeg& leg : live_legs_) {
    if (leg.name == name) return leg.port;
  }
  return std::nullopt;
}

}  // namespace mirocup::league
