// SPDX-License-Identifier: MIT
#include "labs/bench/report.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::bench {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Spread& spread) {
  return {{"p50", spread.p50}, {"p90", spread.p90}, {"p99", spread.p99}};
}

Json json_of(const Report& report, const Row& row) {
  Json costs = Json::object();
  Json overlaps = Json::object();
  for (std::size_t i = 0; i < report.scenes.size(); ++i) {
    const SceneKind kind = report.scenes[i].kind;
    const std::string name{to_string(kind)};
    const Play& play = row.timings[i].play;
    costs[name] = {{"us_per_tick", report.cost(row, kind)},
                   {"ratio", report.ratio(row, kind, report.base(), kind)},
                   {"rounds", row.timings[i].rounds_us}};
    overlaps[name] = {{"deepest", play.deepest_overlap},
                      {"p99", play.overlap_p99},
                      {"ball_is_lost", play.ball_is_lost}};
    if (kind == SceneKind::pinch) overlaps[name]["in_the_hold"] = play.last_overlap;
  }
  Json shots = Json::array();
  for (std::size_t i = 0; i < std::size(shot_speeds); ++i) {
    shots.push_back({{"speed", shot_speeds[i]},
                     {"through_robot", row.shots.through_robot[i]},
                     {"through_plate", row.shots.through_plate[i]}});
  }
  const Contender& c = row.contender;
  return {{"engine", c.engine},
          {"point", c.point},
          {"steps_per_tick", c.steps_per_tick},
          {"settings", c.settings},
          {"cost", std::move(costs)},
          {"error_m",
           {{"free_five_ticks", json_of(row.free.five_ticks)},
            {"crowd_one_tick", json_of(row.crowd.one_tick)},
            {"crowd_five_ticks", json_of(row.crowd.five_ticks)},
            {"crowd_five_ticks_robots", json_of(row.crowd.robots)},
            {"crowd_five_ticks_ball", json_of(row.crowd.ball)}}},
          {"overlap_m", std::move(overlaps)},
          {"shots", std::move(shots)}};
}

}  // namespace

std::string to_json(const Report& report) {
  Json json = {{"schema", "mirocup/bench/1"},
               {"machine", machine()},
               {"quick", report.quick},
               {"rounds", report.rounds},
               {"tick_s", tick},
               {"ratios_to", report.base().contender.engine + ", " + report.base().contender.point},
               {"yardstick_m",
                {{"crowd_one_tick", json_of(report.yardstick_one)},
                 {"crowd_five_ticks", json_of(report.yardstick_five)}}}};
  Json& engines = json["engines"] = Json::array();
  for (const Row& row : report.rows) engines.push_back(json_of(report, row));
  Json& legs = json["legs"] = Json::array();
  for (const Leg& leg : report.legs) {
    legs.push_back({{"name", leg.name},
                    {"played_seconds", leg.played_seconds},
                    {"wall_seconds", leg.wall_seconds},
                    {"cpu_seconds", leg.cpu_seconds},
                    {"times_real_time", leg.speed()}});
  }
  if (report.league) {
    json["league"] = {{"teams", league_teams},
                      {"one_job_seconds", report.league->one_job_seconds},
                      {"two_jobs_seconds", report.league->two_jobs_seconds}};
  }
  Json& judged = json["bars"] = Json::array();
  for (const Bar& bar : bars(report)) {
    judged.push_back({{"name", bar.name},
                      {"measured", bar.measured},
                      {bar.at_least ? "at_least" : "at_most", bar.limit},
                      {"met", bar.met()}});
  }
  return json.dump(2) + "\n";
}

}  // namespace mirocup::bench
