// SPDX-License-Identifier: MIT
#include "server/web/page.hpp"

#include "server/record/json_reader.hpp"
#include "server/web/assets.hpp"
#include "server/web/design/template.hpp"
#include "server/web/page_json.hpp"
#include "server/web/picture.hpp"
#include "system/digest.hpp"
#include "system/markup.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <utility>
#include <vector>

namespace mirocup::web {

namespace {

// The modules of the page, each behind those that it imports.
constexpr std::array<std::string_view, 8> modules{"text.js",   "track.js", "field.js",
                                                  "player.js", "calls.js", "statistics.js",
                                                  "live.js",   "main.js"};

// All modules as one script, without import and export: a page that is opened from disk cannot
// import. No two modules use the same global name.
std::string script() {
  std::string all;
  for (const std::string_view name : modules) {
    std::string_view rest = asset(name);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
      std::string_view line = rest.substr(0, end);
      rest.remove_prefix(end);
      if (line.starts_with("import ")) continue;
      if (line.starts_with("export ")) line.remove_prefix(7);
      all += line;
    }
  }
  return all;
}

// Returns JSON text for a <script> element; no part of the text can close the element.
std::string embedded(const Json& json) {
  std::string text;
  for (const char c : record::json_text(json)) {
    c == '<' ? text += "\\u003c" : text += c;
  }
  return text;
}

using Values = std::vector<std::pair<std::string_view, std::string>>;

// The template with every {{key}} replaced by its value. Braces in values are not replaced.
std::string filled(std::string_view page, const Values& values) {
  std::string out;
  while (true) {
    const std::size_t open = page.find("{{");
    if (open == std::string_view::npos) return out.append(page);
    const std::size_t close = page.find("}}", open);
    const std::string_view key = page.substr(open + 2, close - open - 2);
    out += page.substr(0, open);
    for (const auto& [name, value] : values) {
      if (name == key) out += value;
    }
    page.remove_prefix(close + 2);
  }
}

std::string page(const match::Leg& first_moment, const match::ByTeam<std::string>& names,
                 const Json& data) {
  const std::string code = script();
  // Nothing is loaded from elsewhere, and no code runs but this script.
  const std::string policy =
      "default-src 'none'; style-src 'unsafe-inline'; connect-src 'self'; script-src 'sha256-" +
      system::sha256_base64(code) + "'";
  return filled(asset("page.html"),
                {{"title", system::html_escaped(names[0] + " – " + names[1])},
                 {"blue", system::html_escaped(names[0])},
                 {"yellow", system::html_escaped(names[1])},
                 {"policy", policy},
                 {"style", std::string(design_file("design.css")) + std::string(asset("page.css"))},
                 {"picture", picture(first_moment.field(), first_moment.setup().parameters,
                                     {first_moment.snapshot(), {}})},
                 {"data", embedded(data)},
                 {"script", code}});
}

Json teams_json(const match::ByTeam<std::string>& names) {
  return {{"blue", {{"name", names[0]}}}, {"yellow", {{"name", names[1]}}}};
}

// Collects the data of a replay page: the track, the changes of score, state and phase, and the
// statistics.
class LegTimeline {
 public:
  explicit LegTimeline(const match::Leg& match)
      : track_(match.field().robots_per_team), statistics_(match.field()) {
    add(match);
  }

  void add(const match::Leg& match) {
    const match::Snapshot scene = match.snapshot();
    track_.add(scene);
    statistics_.add(match);
    Json moment = moment_json(scene);
    if (moment == last_moment_) return;
    last_moment_ = moment;
    moment["tick"] = scene.tick;
    moments_.push_back(std::move(moment));
  }

  Json track_json() const { return {{"frames", track_.frames()}, {"packed", track_.packed()}}; }
  const Json& moments() const { return moments_; }
  const Statistics& statistics() const { return statistics_; }

 private:
  TrackEncoder track_;
  Statistics statistics_;
  Json moments_ = Json::array();
  Json last_moment_;
};

std::string about(const record::MatchRecord& record) {
  const match::Setup& setup = record.recording.setup;
  return std::string(to_string(setup.league)) + " league, rules " +
         std::string(to_string(setup.rules.preset)) + ", seed " + std::to_string(setup.seed) +
         ", " + std::to_string(record.recording.ticks.size()) + " ticks, mirocup " +
         record.software.version + ", state hash " + to_hex(record.recording.state_hash);
}

}  // namespace

tl::expected<std::string, replay::Divergence> replay_page(const record::MatchRecord& record,
                                                          Times times) {
  replay::Playback playback(record.recording);
  const match::Leg begin(record.recording.setup);
  LegTimeline timeline(playback.leg());
  while (playback.advance()) timeline.add(playback.leg());
  if (playback.divergence()) return tl::unexpected(*playback.divergence());

  const Json whole = record::to_json(record);
  Json statistics = statistics_json(timeline.statistics(), record.recording.decisions);
  for (const char* team : {"blue", "yellow"}) {
    Json budget = whole["budget"][team];
    if (times == Times::left_out) {
      for (const char* measured : {"cpu_seconds", "slowest_tick_ms"}) budget.erase(measured);
    }
    statistics["teams"][team]["budget"] = budget;
  }
  const Json data{{"schema", "mirocup/page/1"},
                  {"teams", whole["teams"]},
                  {"period", record.recording.setup.control_period},
                  {"robots", begin.field().robots_per_team},
                  {"about", about(record)},
                  {"result", whole["result"]},
                  {"decisions", whole["decisions"]},
                  {"moments", timeline.moments()},
                  {"statistics", statistics},
                  {"track", timeline.track_json()}};
  return page(begin, {record.teams[0].name, record.teams[1].name}, data);
}

std::string live_page(const match::Leg& match, const LiveMatch& live) {
  const Json data{{"schema", "mirocup/page/1"},
                  {"teams", teams_json(live.names)},
                  {"period", match.setup().control_period},
                  {"robots", match.field().robots_per_team},
                  {"about", live.about},
                  {"live", live.events}};
  return page(match, live.names, data);
}

}  // namespace mirocup::web
