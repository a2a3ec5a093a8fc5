// SPDX-License-Identifier: MIT
#include "record/traces/trace_verdict.hpp"

#include "core/referee/placement_check.hpp"
#include "record/traces/trace_sampler.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace mirocup::traces {

namespace {

using Json = nlohmann::ordered_json;
using referee::Decision;
using referee::Placement;
using referee::Restart;
using referee::Verdict;

// The sizes that the simulator and the rules use by default, m.
constexpr double ball_radius = 0.02135;
constexpr double robot_side = 0.075;

std::string letter(End end) {
  return end == End::left ? "L" : "R";
}

// Turns -0.0 into 0.0, so that both ends print alike.
Json number(double value) {
  return value + 0.0;
}
Json point(const Vec2& p) {
  return {number(p.x()), number(p.y())};
}
Json pose(const Pose& p) {
  return {number(p.position.x()), number(p.position.y()), number(p.heading.angle())};
}

Json poses(const std::array<Pose, max_robots_per_team>& team, int robots) {
  Json list = Json::array();
  for (int i = 0; i < robots; ++i) list.push_back(pose(team[i]));
  return list;
}

Json indices(const referee::RobotSet& set) {
  Json list = Json::array();
  for (int i = 0; i < max_robots_per_team; ++i) {
    if (set[i]) list.push_back(i);
  }
  return list;
}

Json without_law(const std::string& id, const char* decision, const std::string& reason) {
  return {
      {"id", id}, {"decision", decision}, {"law", nullptr}, {"reason", reason}, {"at", nullptr}};
}

// Shows a trace to a referee, sample by sample, until it decides.
class TraceJudge {
 public:
  explicit TraceJudge(const Trace& trace)
      : trace_(trace),
        field_(field::make_field(trace.league)),
        pitch_{field_, trace_.rules, ball_radius, robot_side},
        sampler_(trace_, pitch_),
        referee_(pitch_, trace.progress) {
    referee_.resume(trace.restart, trace.attempt ? trace.attempt->t : 0.0);
  }

  Json judge() {
    if (trace_.state == TraceState::PLACE) return place();
    return trace_.state == TraceState::HALF_TIME ? wait_for_second_half() : play();
  }

 private:
  Json none() const {
    const bool is_ready = trace_.state == TraceState::READY;
    return without_law(trace_.id, "NONE", is_ready ? "play has not begun" : "no law was broken");
  }

  Json play() {
    bool stood = false;
    for (int k = 0; k <= sampler_.last_sample(); ++k) {
      const double t = k * sample_period;
      if (auto answer = answer_requests(t)) return *answer;
      if (trace_.state == TraceState::READY) continue;
      const bool stands =
          std::any_of(trace_.clock_stops.begin(), trace_.clock_stops.end(),
                      [&](const auto& stop) { return t > stop.first && t <= stop.second; });
      if (stands && !stood) referee_.resume(Decision{});
      stood = stands;
      if (stands) continue;
      const referee::Judgement judgement = referee_.judge(sampler_.sample(k));
      if (judgement.decision) {
        return verdict(*judgement.decision, trace_.attempt ? trace_.attempt->t : t);
      }
    }
    return none();
  }

  std::optional<Decision> ask(const TeamRequest& request) {
    if (!request.to_replace) return referee_.ask_for_time_out(request.team);
    if (trace_.state == TraceState::HALF_TIME)
      return referee_.substitute_in_break(*request.to_replace);
    return referee_.ask_for_substitution(*request.to_replace);
  }

  // Answers the requests up to time t. Each is rejected at once, or granted at once unless play is
  // on.
  std::optional<Json> answer_requests(double t) {
    for (; requests_answered_ < trace_.requests.size(); ++requests_answered_) {
      const TeamRequest& request = trace_.requests[requests_answered_];
      if (request.t > t + 1e-9) break;
      if (const auto rejected = ask(request)) {
        ++requests_answered_;
        return verdict(*rejected, request.t);
      }
      if (trace_.state == TraceState::PLAY) continue;
      Decision stoppage = trace_.restart;
      if (stoppage.restart == Restart::none) stoppage.restart = Restart::KICK_OFF;
      stoppage.verdict = Verdict::RESTART;
      if (const auto granted = referee_.follow_up(stoppage)) {
        ++requests_answered_;
        return verdict(*granted, request.t);
      }
    }
    return std::nullopt;
  }

  // The second half begins after the break. A missing team has some more time, then it forfeits.
  Json wait_for_second_half() {
    const auto& missing = trace_.missing;
    const bool waits = missing[0] || missing[1];
    const double wait_limit = trace_.rules.half_break_s + (waits ? trace_.rules.half_late_s : 0.0);
    for (int k = 0; k <= sampler_.last_sample(); ++k) {
      const double t = k * sample_period;
      if (auto answer = answer_requests(t)) return *answer;
      if (t + sample_period / 2.0 < wait_limit) continue;
      if (waits) return verdict(forfeit(), t);
      Decision d = trace_.restart;
      d.verdict = Verdict::RESTART;
      d.law = referee::Law::half_time;
      d.restart = Restart::KICK_OFF;
      d.reason = "the break of " + referee::fixed(trace_.rules.half_break_s, 0) + " s is over";
      return verdict(d, t);
    }
    return none();
  }

  Decision forfeit() const {
    const auto& missing = trace_.missing;
    Decision d;
    d.verdict = Verdict::FORFEIT;
    d.law = referee::Law::forfeit;
    if (!(missing[0] && missing[1])) d.team = missing[0] ? End::right : End::left;
    d.reason = (d.team ? "a team is not back " : "neither team is back ") +
               referee::fixed(trace_.rules.half_late_s, 0) + " s after the end of the break";
    return d;
  }

  Json place() {
    if (auto answer = answer_requests(trace_.hold.value_or(0.0))) return *answer;
    const auto roles = trace_.progress.phase == referee::Phase::SHOOT_OUT ? referee::Roles::fixed
                                                                          : referee::Roles::any;
    const referee::CheckedPlacement checked =
        check_placement(pitch_, trace_.restart, roles, *trace_.requested_placement);
    Decision d = trace_.restart;
    d.verdict = checked.any_moved() ? Verdict::PLACEMENT_FIXED : Verdict::RESTART;
    d.law = referee::Law::placement;
    d.clock = trace_.progress.clock;
    d.reason = reason_of(pitch_, *trace_.requested_placement, checked);
    Json json = verdict(d, 0.0);
    for (const End end : both_ends) {
      const int e = index_of(end);
      json[letter(end) + "_moved"] = indices(checked.moved[e]);
      json[letter(end) + "_legal"] = indices(requested_robots_of(end) & ~checked.moved[e]);
      json[letter(end)] = poses(checked.placement.robots[e], field_.robots_per_team);
    }
    json["ball"] = point(checked.placement.ball);
    return json;
  }

  // Returns the robots for which the team of that end requested poses.
  referee::RobotSet requested_robots_of(End end) const {
    referee::RobotSet set;
    for (int i = 0; i < trace_.requested_robots[index_of(end)]; ++i) set.set(i);
    return set;
  }

  Json verdict(const Decision& d, double at) {
    Json json{{"id", trace_.id},
              {"decision", to_string(d.verdict)},
              {"law", to_string(d.law)},
              {"reason", d.reason},
              {"at", at}};
    if (d.verdict != Verdict::NONE) json["clock"] = d.clock;
    add_parties(d, json);
    add_restart(d, json);
    if (d.verdict == Verdict::TIME_OUT || d.verdict == Verdict::REJECTED) return json;
    if (const auto next = referee_.follow_up(d)) json["then"] = follow_up(*next);
    return json;
  }

  void add_parties(const Decision& d, Json& json) const {
    Json robots = Json::array();
    for (const End end : both_ends) {
      for (int i = 0; i < max_robots_per_team; ++i) {
        if (d.robots[index_of(end)][i]) robots.push_back(letter(end) + std::to_string(i));
      }
    }
    if (!robots.empty()) json["robots"] = robots;
    switch (d.verdict) {
      case Verdict::GOAL:
        json["for"] = letter(*d.team);
        json["own_goal"] = d.law == referee::Law::own_goal;
        break;
      case Verdict::MATCH_END:
      case Verdict::FORFEIT:
        json["winner"] = d.team ? Json(letter(*d.team)) : Json();
        break;
      case Verdict::TIME_OUT:
        json["team"] = letter(*d.team);
        json["duration"] = trace_.rules.time_out_s;
        json["remaining"] = referee_.time_outs_left(*d.team);
        if (d.law == referee::Law::substitution) {
          json["substitutions_left"] = referee_.substitutions_left(*d.team);
        }
        break;
      case Verdict::ATTEMPT_END:
        json["team"] = letter(*d.team);
        json["scored"] = d.scored;
        json["next_taker"] = letter(d.taker);
        break;
      case Verdict::HALF_END:
      case Verdict::PHASE:
        json["phase"] = to_string(d.phase);
        break;
      default:
        if (d.team) json["team"] = letter(*d.team);
    }
    if (d.goal_cancelled) json["goal_cancelled"] = true;
  }

  void add_restart(const Decision& d, Json& json) const {
    if (d.restart == Restart::none || d.verdict == Verdict::TIME_OUT) return;
    const Placement placed = default_placement(pitch_, d.restart, d.taker, d.spot);
    json["restart"] = to_string(d.restart);
    json["ball"] = point(placed.ball);
    if (d.restart == Restart::FREE_BALL) {
      const referee::Quarter quarter = referee::quarter_of(d.spot);
      json["quarter"] = std::string(quarter.x > 0.0 ? "+" : "-") + (quarter.y > 0.0 ? "+" : "-");
      json["places_first"] = letter(d.taker);
      for (const End end : both_ends) {
        json["contenders"][letter(end)] =
            point(placed.robots[index_of(end)][referee::kicker].position);
      }
      return;
    }
    json["taker"] = letter(d.taker);
    const auto& defenders = placed.robots[index_of(opposite(d.taker))];
    if (d.restart == Restart::PENALTY_KICK) {
      json["keeper_touch_x"] = number(defenders[referee::keeper].position.x());
    }
    if (d.restart == Restart::FREE_KICK) {
      for (int i = 1; i < std::min(field_.robots_per_team, 5); ++i) {
        json["wall_robots"].push_back(point(defenders[i].position));
      }
    }
  }

  Json follow_up(const Decision& d) const {
    Json json{{"decision", to_string(d.verdict)}, {"law", to_string(d.law)}, {"reason", d.reason}};
    add_parties(d, json);
    return json;
  }

  const Trace& trace_;
  field::Field field_;
  referee::JudgedField pitch_;
  TraceSampler sampler_;
  referee::Referee referee_;
  std::size_t requests_answered_ = 0;
};

}  // namespace

Json judge_trace(const Trace& trace) {
  return TraceJudge(trace).judge();
}

Json reject_trace(const std::string& id, const std::string& reason) {
  return without_law(id, "REJECTED", reason);
}

}  // namespace mirocup::traces
