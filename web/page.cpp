// SPDX-License-Identifier: MIT
#include "web/page.hpp"

#include "core/replay/verification.hpp"
#include "record/json_fields.hpp"
#include "record/replay_file.hpp"
#include "record/statistics/counter.hpp"
#include "system/digest.hpp"
#include "system/text.hpp"
#include "web/design/template.hpp"
#include "web/picture.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <vector>

namespace mirocup::web {

namespace {

// The modules of the page, each behind those that it imports.
constexpr std::array<std::string_view, 19> modules{
    "text.js",       "track.js",    "field.js", "actions.js",  "layers.js",
    "player.js",     "viewer.js",   "reel.js",  "calls.js",    "situation.js",
    "statistics.js", "momentum.js", "log.js",   "thoughts.js", "inspector.js",
    "clip.js",       "proof.js",    "play.js",  "main.js"};

// "KICK_OFF" -> "Kick off", as page/text.js has it.
std::string words(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const bool is_first = text.empty();
    text += c == '_' ? ' ' : static_cast<char>(is_first ? std::toupper(c) : std::tolower(c));
  }
  return text;
}

std::string minutes(double seconds) {
  const auto whole = static_cast<int>(seconds + 1e-6);
  return system::formatted("%d:%02d", whole / 60, whole % 60);
}

std::string score_text(const Json& score) {
  return system::formatted("%d : %d", record::value_in(score, "blue", 0),
                           record::value_in(score, "yellow", 0));
}

// The calls as text, for readers without scripts.
Json calls_as_text(const Json& decisions, const match::ByTeam<std::string>& names) {
  Json calls = Json::array();
  for (const Json& call : decisions) {
    const bool is_goal = call["decision"] == "GOAL";
    const std::string gainer = record::text_in(call, "gainer");
    const std::string name = gainer.empty() ? "" : names[gainer == "blue" ? 0 : 1];
    std::string what = words(record::text_in(call, "decision"));
    if (is_goal && record::value_in(call, "own_goal", false)) what += " (own goal)";
    if (is_goal) what += " · " + name + " " + score_text(call["score"]);
    if (!is_goal && !name.empty()) what += " for " + name;
    const bool shows_scorer = is_goal && call["own_goal"] == false && !call["scorer"].is_null();
    calls.push_back(
        {{"is_goal", is_goal},
         {"colour", gainer.empty() ? "nobody" : gainer},
         {"when", minutes(record::value_in(call, "clock", 0.0))},
         {"what", what},
         {"who", shows_scorer ? "robot " + call["scorer"]["robot"].dump() : std::string()},
         {"why", record::text_in(call, "reason")}});
  }
  return calls;
}

std::string code_of_page(bool has_play) {
  std::vector<std::string_view> parts(modules.begin(), modules.end());
  if (!has_play) std::erase(parts, "play.js");
  return page_script(parts);
}

// `files`: as in replay_page().
std::string page(const match::Leg& first_moment, const match::ByTeam<std::string>& names,
                 const Json& data, const std::string& proof = "",
                 ModulePlace module = ModulePlace::nowhere, const std::string& links = "",
                 const std::optional<std::string>& files = {}) {
  const std::string code = files ? "" : code_of_page(!proof.empty());
  Json values{{"title", names[0] + " – " + names[1]},
              {"blue", names[0]},
              {"yellow", names[1]},
              {"policy", page_policy(code, module)},
              {"links", links},
              {"has_proof", !proof.empty()},
              {"proof", proof},
              {"files", false},
              {"style", page_style()},
              {"picture", picture(first_moment)},
              {"data", embedded(data)},
              {"script", code},
              {"score", "0 : 0"},
              {"phase", "First half"}};
  if (files) {
    const std::string script = page_files().front().name;
    values["files"] = *files + script.substr(0, script.rfind('.'));
    values["picture"] = system::replaced(picture(first_moment), picture_style(), "");
  }
  if (data.contains("result")) {
    values["score"] = score_text(data["result"]["score"]);
    values["phase"] = words(record::text_in(data["result"], "end"));
    values["calls"] = calls_as_text(data["decisions"], names);
  }
  return filled(asset, "page.html", values);
}

// The score with which a leg starts.
Json start_score_json(const match::Setup& setup) {
  const match::ByTeam<int> score = setup.start ? setup.start->score : match::ByTeam<int>{};
  return {{"blue", score[0]}, {"yellow", score[1]}};
}

// The speeds that wheels have which roll along with a robot.
simulator::WheelSpeeds rolling_wheels(const simulator::Twist& twist, const match::Leg& match) {
  const simulator::Parameters& p = match.setup().parameters;
  const double outer = 0.5 * p.wheel_distance * twist.omega;
  return {.left = (twist.forward - outer) / p.wheel_radius,
          .right = (twist.forward + outer) / p.wheel_radius};
}

// Collects the data of a replay page: the track, the changes of score, state and phase, and the
// statistics.
class LegTimeline {
 public:
  explicit LegTimeline(const match::Leg& match) : counter_(match) { show(match); }

  // To be called after every tick.
  void add(const match::Leg& match) {
    counter_.add(match);
    show(match);
  }

  Json track() const { return track_json(track_); }
  const Json& moments() const { return moments_; }
  const Json& keepers() const { return keepers_; }
  statistics::LegStatistics counted() const { return counter_.statistics(); }

  // For each frame and robot: wheels asked in the tick before and driven now, left and right, in
  // units of 0.1 rad/s, and the age of the picture, ticks.
  std::string wheels() const { return packed_text(wheels_.bytes()); }

 private:
  void add_wheels(const match::Leg& match) {
    constexpr double unit = 0.1;  // rad/s; page/inspector.js has it, too
    const match::Snapshot seen = match.view();
    Frame row;
    for (const Team team : both_teams) {
      for (int i = 0; i < match.field().robots_per_team; ++i) {
        const auto asked = match.log().empty()
                               ? simulator::WheelSpeeds{}
                               : match.log().back().commands[index_of(team)].speeds(i);
        const simulator::WheelSpeeds driven = rolling_wheels(match.robot(team, i).twist, match);
        for (const double speed : {asked.left, asked.right, driven.left, driven.right})
          row.push_back(static_cast<std::int32_t>(std::lround(speed / unit)));
        row.push_back(seen.robots[index_of(team)][static_cast<std::size_t>(i)].age);
      }
    }
    wheels_.add(row);
  }

  void show(const match::Leg& match) {
    const match::Snapshot scene = match.snapshot();
    track_.add(frame_of(scene, match.field().robots_per_team, track_.last()));
    add_wheels(match);
    const Json keepers = keepers_json(scene);
    if (keepers_.empty() || keepers != last_keepers_) {
      last_keepers_ = keepers;
      keepers_.push_back({scene.tick, keepers[0], keepers[1]});
    }
    Json moment = moment_json(scene);
    if (moment == last_moment_) return;
    last_moment_ = moment;
    moment["tick"] = scene.tick;
    moments_.push_back(std::move(moment));
  }

  ColumnEncoder track_;
  ColumnEncoder wheels_;
  statistics::LegCounter counter_;
  Json moments_ = Json::array();
  Json last_moment_;
  Json keepers_ = Json::array();  // [tick, blue's, yellow's], from that tick on
  Json last_keepers_;
};

std::string about(const record::MatchRecord& record) {
  const match::Setup& setup = record.recording.setup;
  return std::string(to_string(setup.league)) + " league, rules " +
         std::string(to_string(setup.rules.preset)) + ", seed " + std::to_string(setup.seed) +
         ", " + std::to_string(record.recording.ticks.size()) + " ticks, mirocup " +
         record.software.version + ", state hash " + to_hex(record.recording.state_hash);
}

// Adds {thoughts, log} of the teams that have any.
void add_own(Json& data, const record::OwnTexts& own) {
  for (const Team team : both_teams) {
    const std::string name(to_string(team));
    const std::string& thoughts = own.thoughts[index_of(team)];
    const std::string& log = own.logs[index_of(team)];
    if (!thoughts.empty()) data["own"][name]["thoughts"] = packed_text(thoughts);
    if (!log.empty()) data["own"][name]["log"] = log;
  }
}

// The record without what a simulation does not need, and its commands and hashes.
Json commands_json(record::MatchRecord record) {
  for (const Team team : both_teams) {
    record.budget[index_of(team)] = {};
    record.network[index_of(team)].reset();
  }
  record.pace.reset();
  record.recording.trace = {};
  const int robots = field::make_field(record.recording.setup.league).robots_per_team;
  const std::string text = record::record_text(record, "leg.replay.zst", "");
  return {{"record", packed_text(text)},
          {"replay", packed_text(record::plain_replay(record.recording, robots))}};
}

// Returns "" if nobody can prove the page.
std::string proof_text(const record::MatchRecord& record, const Proof& proof) {
  if (!proof.module && proof.module_file.empty()) return "";
  Json json = proof.commands_file.empty() ? commands_json(record)
                                          : Json{{"commands_file", proof.commands_file}};
  proof.module_file.empty() ? json["module"] = module_json(*proof.module)
                            : json["module_file"] = proof.module_file;
  return embedded(json);
}

struct ReplayData {
  Json json;
  statistics::LegStatistics statistics;
  std::string wheels;
};

tl::expected<ReplayData, replay::Divergence> play_again(const record::MatchRecord& record,
                                                        Times times) {
  replay::Playback playback(record.recording);
  const match::Leg begin(record.recording.setup);
  LegTimeline timeline(playback.leg());
  while (playback.advance()) timeline.add(playback.leg());
  if (playback.divergence()) return tl::unexpected(*playback.divergence());
  if (auto other = replay::compare_results(record.recording, playback.leg()))
    return tl::unexpected(*std::move(other));

  const Json whole = record::to_json(record);
  const statistics::LegStatistics counted = timeline.counted();
  Json statistics = statistics_json(counted);
  for (const char* team : {"blue", "yellow"}) {
    Json budget = whole["budget"][team];
    if (times == Times::left_out) {
      for (const char* measured : {"cpu_seconds", "slowest_tick_ms"}) budget.erase(measured);
    }
    statistics["teams"][team]["budget"] = budget;
  }
  Json json{{"schema", "mirocup/page/1"},
            {"teams", whole["teams"]},
            {"league", whole["league"]},
            {"score", start_score_json(record.recording.setup)},
            {"period", record.recording.setup.control_period},
            {"robots", begin.field().robots_per_team},
            {"half_length", begin.field().half_length},
            {"zones", zones_json(begin.field())},
            {"about", about(record)},
            {"result", whole["result"]},
            {"decisions", whole["decisions"]},
            {"moments", timeline.moments()},
            {"keepers", timeline.keepers()},
            {"statistics", statistics},
            {"track", timeline.track()}};
  return ReplayData{std::move(json), counted, timeline.wheels()};
}

}  // namespace

tl::expected<Json, replay::Divergence> replay_data(const record::MatchRecord& record, Times times) {
  MIROCUP_TRY(auto data, play_again(record, times));
  return std::move(data.json);
}

std::optional<Json> data_of_page(std::string_view html) {
  constexpr std::string_view before = "<script type=\"application/json\" id=\"leg\">";
  const std::size_t tag = html.find(before);
  if (tag == std::string_view::npos) return std::nullopt;
  const std::size_t begin = tag + before.size();
  const std::string_view text = html.substr(begin, html.find("</script>", begin) - begin);
  record::ParsedJson parsed = record::parse_json(text, {.text = text.size()});  // the track is one
  const bool is_data = record::text_in(parsed.value, "schema") == "mirocup/page/1";
  return is_data ? std::optional(std::move(parsed.value)) : std::nullopt;
}

std::vector<ScriptFile> page_files() {
  constexpr std::size_t digits = 16;
  std::string script = "(() => {\n'use strict';\n" + code_of_page(true) + "})();\n";
  std::string style = page_style() + std::string(asset("picture.css"));
  const std::string name = "module/" + system::sha256(script + style).substr(0, digits);
  return {{name + ".js", std::move(script)}, {name + ".css", std::move(style)}};
}

std::string first_picture(const record::MatchRecord& record) {
  return picture(match::Leg(record.recording.setup));
}

tl::expected<ReplayPage, replay::Divergence> replay_page(const record::MatchRecord& record,
                                                         Times times, const record::OwnTexts& own,
                                                         const std::optional<Proof>& proof,
                                                         Wheels wheels, const std::string& links,
                                                         const std::optional<std::string>& files) {
  MIROCUP_TRY(auto data, play_again(record, times));
  add_own(data.json, own);
  if (wheels == Wheels::shown) data.json["wheels"] = std::move(data.wheels);
  const std::string text = proof ? proof_text(record, *proof) : "";
  const ModulePlace module = text.empty()                 ? ModulePlace::nowhere
                             : proof->module_file.empty() ? ModulePlace::in_the_page
                                                          : ModulePlace::beside_it;
  return ReplayPage{
      page(match::Leg(record.recording.setup), {record.teams[0].name, record.teams[1].name},
           data.json, text, module, links, files),
      data.statistics, text.size()};
}

std::string commands_script(const record::MatchRecord& record) {
  return "globalThis.mirocup_commands = " + record::json_text(commands_json(record)) + ";\n";
}

std::string live_page(const match::Leg& match, const match::ByTeam<std::string>& names,
                      const std::string& about) {
  const Json data{{"schema", "mirocup/page/1"},
                  {"teams", {{"blue", {{"name", names[0]}}}, {"yellow", {{"name", names[1]}}}}},
                  {"score", start_score_json(match.setup())},
                  {"period", match.setup().control_period},
                  {"robots", match.field().robots_per_team},
                  {"half_length", match.field().half_length},
                  {"zones", zones_json(match.field())},
                  {"about", about},
                  {"live", "events"}};
  return page(match, names, data);
}

}  // namespace mirocup::web
