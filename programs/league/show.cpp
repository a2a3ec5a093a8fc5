// SPDX-License-Identifier: MIT
//
// The subcommand show.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "record/match_record.hpp"
#include "system/digest.hpp"
#include "system/process_set.hpp"
#include "system/secret.hpp"
#include "tournaments/publish/front_page.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/rounds.hpp"
#include "tournaments/publish/site_file.hpp"
#include "tournaments/publish/snapshot.hpp"
#include "web/design/template.hpp"
#include "web/page.hpp"
#include "web/page_parts.hpp"
#include "web/site_server.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <set>

namespace mirocup::league {

namespace {

constexpr const char* show_policy =
    "default-src 'none'; style-src 'self' 'unsafe-inline'; script-src 'self'; connect-src 'self'";
constexpr std::array<std::string_view, 7> known_commands{"toggle", "skip", "slower", "faster",
                                                         "one",    "two",  "four"};

// A round of a knockout changes the bracket, every other one the table.
std::string standing_html(const Overview& o, const std::string& heading, bool is_of_knockout) {
  const bool by_strength = o.state.file.format.is_open_ended();
  Json rows = Json::array();
  for (const TableRow& row : o.table) {
    if (is_of_knockout) break;
    rows.push_back(
        {{"rank", rank_in_words(row)},
         {"name", o.state.shown_name(row.team)},
         {"points", !by_strength ? std::to_string(row.points)
                    : row.rank > 0
                        ? std::to_string(std::lround(o.ratings.strengths[row.team].value))
                        : "–"},
         {"played", row.played},
         {"goals", std::to_string(row.goals_for) + ":" + std::to_string(row.goals_against)},
         {"difference", with_sign(row.difference())}});
  }
  return web::filled(show_file, "standing.html",
                     {{"heading", heading},
                      {"has_table", !is_of_knockout},
                      {"points", by_strength ? "Strength" : "Pts"},
                      {"rows", rows},
                      {"bracket", is_of_knockout ? bracket_svg(o) : ""}});
}

// Returns the fixtures in the order in which they are shown: the final comes last.
std::vector<FixtureView> in_order(std::vector<FixtureView> fixtures) {
  std::stable_partition(fixtures.begin(), fixtures.end(),
                        [](const FixtureView& f) { return f.state->fixture.is_for_third_place(); });
  return fixtures;
}

const RoundView* round_named(const std::vector<RoundView>& rounds, const std::string& key) {
  for (auto round = rounds.rbegin(); round != rounds.rend(); ++round) {
    if (key.empty() ? round->decided > 0 : round->key == key) return &*round;
  }
  return nullptr;
}

// A round that is shown on a projector: the page, the recorded legs, the table after each leg, and
// the commands of a remote. The league is read once, so the page does not show legs that are played
// later.
//
// Threads: all public functions may be called by any thread at any time.
class ShownRound {
 public:
  // `round` is the key of a round ("r3", "k1"); "": the last round with a played leg. `key` is the
  // secret of the remote. `at_once`: number of legs side by side, until the remote changes the
  // number. Errors: Errc::input if the league lacks the round, or no leg of the round has a record.
  static Result<std::unique_ptr<ShownRound>> of(system::Files& files, const LeagueStore& store,
                                                const std::string& round, std::string key,
                                                int at_once) {
    std::unique_ptr<ShownRound> shown(new ShownRound(files, std::move(key)));
    MIROCUP_TRY_VOID(shown->read(store, round, at_once));
    return shown;
  }

  // The functions of web::Site.
  std::optional<web::Page> page(const std::string& path) const {
    if (const auto page = pages_.find(path); page != pages_.end()) return page->second;
    const auto leg = legs_.find(path);
    return leg != legs_.end() ? data_page(leg->second) : std::nullopt;
  }

  // A viewer that has just come gets no commands of before.
  std::string news(std::uint64_t& seen) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t now = given_.size() + 1;
    if (seen == now) return "";
    Json fresh = Json::array();
    if (seen > 0) {
      for (std::size_t i = seen - 1; i < given_.size(); ++i) fresh.push_back(given_[i]);
    }
    seen = now;
    return web::event_text("command", fresh);
  }

  bool control(const std::string& body) {
    const std::size_t space = body.find(' ');
    if (space == std::string::npos || !system::is_same_secret(key_, body.substr(0, space)))
      return false;
    const std::string command = body.substr(space + 1);
    if (std::ranges::find(known_commands, command) == known_commands.end()) return false;
    const std::lock_guard lock(mutex_);
    given_.push_back(command);
    return true;
  }

 private:
  struct Leg {
    std::string blue, yellow;
    std::string record;  // path of the record
    std::string page;    // path of the leg's replay page, if the league was published
  };

  ShownRound(system::Files& files, std::string key) : files_(&files), key_(std::move(key)) {}

  Result<void> read(const LeagueStore& store, const std::string& key, int at_once) {
    const LeagueState& state = store.state();
    KnownLegs known;
    read_legs(*files_, store.folder(), state, known);
    const Overview o = overview(state, known);
    const std::vector<RoundView> rounds = rounds_of(o);
    const RoundView* round = round_named(rounds, key);
    if (round == nullptr)
      return fail(Errc::input, key.empty() ? store.folder().path + ": no leg has been played yet"
                                           : "there is no round " + key);
    const bool is_of_knockout =
        !round->fixtures.empty() && round->fixtures.front().state->fixture.part == Part::knockout;
    std::set<LegName> shown;
    const auto add_standing = [&]() -> Result<void> {
      MIROCUP_TRY(const auto then, state_through(state, store.journal(), round->key, &shown));
      const std::string count = std::to_string(shown.size());
      add("/after/" + count + ".html",
          standing_html(overview(then, known),
                        shown.empty() ? "Before " + round->title : "After leg " + count,
                        is_of_knockout));
      return {};
    };
    MIROCUP_TRY_VOID(add_standing());
    Json programme = Json::array();
    for (const FixtureView& f : in_order(round->fixtures)) {
      for (const LegView* leg : f.legs) {
        if (!leg->has_replay()) continue;
        const auto [blue, yellow] = f.state->fixture.colours(leg->leg);
        const std::string path = "/legs/" + std::to_string(legs_.size()) + ".json";
        const Leg& added =
            legs_[path] = {state.shown_name(blue), state.shown_name(yellow),
                           store.folder().path + "/" + leg->played->record,
                           store.folder().site() + "/" + replay_page_of(leg->played->record)};
        programme.push_back({{"blue", added.blue},
                             {"yellow", added.yellow},
                             {"where", leg->round + ", leg " + std::to_string(leg->leg)},
                             {"data", path},
                             {"has_standing", !is_of_knockout}});
        shown.insert({leg->fixture, leg->leg});
        MIROCUP_TRY_VOID(add_standing());
      }
      if (!programme.empty()) programme.back()["has_standing"] = true;  // its tie is over
    }
    if (legs_.empty())
      return fail(Errc::input, "no leg of round " + round->key + " has a record that can be shown");
    add("/programme.json",
        record::json_text({{"round", round->title}, {"at_once", at_once}, {"legs", programme}}));
    const bool is_last = round == &rounds.back();
    Json next = Json::array();
    if (!is_last) {
      for (const FixtureView& f : std::next(round)->fixtures)
        next.push_back(state.shown_name(f.state->fixture.home) + " – " +
                       state.shown_name(f.state->fixture.away));
    }
    // Asked for at the end only: the pairs of a knockout tell who has won.
    add("/next.json", record::json_text(next));
    const Json champion = is_last ? champion_values(o) : Json(false);
    add("/champion.html",
        champion != false ? web::filled(show_file, "champion.html", champion) : "");
    add_files({{"league", state.file.title},
               {"round", round->title},
               {"about", std::to_string(legs_.size()) + " legs"}});
    return {};
  }

  void add_files(const Json& values) {
    add("/", web::filled(show_file, "show.html", values));
    add("/remote", web::filled(show_file, "remote.html", values));
    add("/show.css", std::string(web::design_file("design.css")) +
                         std::string(page_file("site.css")) + std::string(show_file("show.css")));
    for (const std::string script : {"show.js", "remote.js"})
      add("/" + script, std::string(show_file(script)));
    for (const std::string module : {"field.js", "text.js", "track.js"})
      add("/page/" + module, std::string(web::asset(module)));
  }

  // A path without an ending is that of a page.
  void add(const std::string& path, std::string bytes) {
    const bool is_page = path.find('.') == std::string::npos;
    pages_[path] = {type_of(is_page ? "page.html" : path), show_policy, std::move(bytes)};
  }

  std::optional<web::Page> data_page(const Leg& leg) const {
    const auto loaded = record::load(*files_, leg.record);
    if (!loaded) {
      std::cerr << "mirocup: " << loaded.error().what << '\n';
      return std::nullopt;
    }
    auto data = data_of(leg, *loaded);
    if (!data) {
      std::cerr << "mirocup: " << leg.record
                << " cannot be shown: this program does not reproduce it, and the site lacks its "
                   "page\n";
      return std::nullopt;
    }
    (*data)["teams"]["blue"]["name"] = leg.blue;
    (*data)["teams"]["yellow"]["name"] = leg.yellow;
    (*data)["picture"] = web::first_picture(*loaded);
    return web::Page{type_of(leg.record), show_policy, record::json_text(*data)};
  }

  // A leg of another version may go another way here. Then its replay page shows it, which the
  // program has made that played it.
  std::optional<Json> data_of(const Leg& leg, const record::MatchRecord& record) const {
    if (auto data = web::replay_data(record, web::Times::left_out)) return std::move(*data);
    const auto page = files_->read(leg.page, {.max_size = system::size_limit::page});
    return page ? web::data_of_page(*page) : std::nullopt;
  }

  system::Files* files_;
  std::string key_;
  std::map<std::string, web::Page> pages_;  // by path: everything except the legs
  std::map<std::string, Leg> legs_;         // by path of their data
  std::mutex mutex_;                        // guards `given_`
  std::vector<std::string> given_;          // commands of the remote
};

struct ShowOptions : LeagueOptions {
  std::string round;     // its key, as in "r3"; "": the last one of which a leg was played
  std::string at = "0";  // [HOST:]PORT
  int at_once = 1;       // legs side by side
};

constexpr double poll_s = 3600.0;      // s
constexpr std::size_t key_bytes = 16;  // of the secret of the remote

Result<int> run_show(const ShowOptions& options) {
  MIROCUP_TRY(const auto address, web::parse_address(options.at, "--at"));
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  system::ProcessSet interrupts;  // must exist before the first thread starts
  const std::string key = system::base32(system::random_bytes(key_bytes));
  MIROCUP_TRY(const auto round, ShownRound::of(disk, store, options.round, key, options.at_once));
  MIROCUP_TRY(const auto server,
              web::SiteServer::open(
                  address, "--at",
                  {.page = [&](const std::string& path) { return round->page(path); },
                   .news = [&](std::uint64_t& seen) { return round->news(seen); },
                   .match = [](const std::string&) { return std::nullopt; },
                   .control = [&](const std::string& body) { return round->control(body); }}));
  const std::string url = server->url();
  std::cout << url << '\n' << url << "remote#" << key << std::endl;
  while (!interrupts.is_asked_to_stop_within(poll_s)) {
  }
  return exit_yes;
}

}  // namespace

void add_show(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, run_show, "show", to_show,
                  "Play the recorded legs of a round on a projector, one after the other",
                  {"mirocup league show spring --round r3 --at-once 2"});
  command.option("--round ROUND", o.round,
                 "Round: r3, or k1 of a knockout (default: the last round that was played)");
  command.option("--at [HOST:]PORT", o.at,
                 "Where to listen (default: this host only, any free port)");
  command.option("--at-once", o.at_once, "Number of legs side by side: 1, 2 or 4")
      .one_of({"1", "2", "4"});
}

}  // namespace mirocup::league
