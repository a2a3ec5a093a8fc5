// SPDX-License-Identifier: MIT
#include "labs/bench/report.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace mirocup::bench {

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// The cost of Debian's build of Chipmunk with its assertions, times a release build (measured with
// both, in instructions: 400 and 249 thousand for a tick of the game, 912 and 746 in jams).
double assertions_of_chipmunk(SceneKind kind) {
  return kind == SceneKind::jam || kind == SceneKind::scrum ? 1.2 : 1.6;
}

constexpr double deepest_in_jams = 1e-3;  // mm

int bodies(const Scene& scene) {
  return static_cast<int>(start_of(scene).robots.size()) + 1;
}

double worst_free(const Report&, const Row& row) {
  return row.free.five_ticks.p90;
}
double worst_crowd(const Report&, const Row& row) {
  return row.crowd.five_ticks.p90;
}
double tail_of_crowd(const Report&, const Row& row) {
  return row.crowd.five_ticks.p99;
}
template <SceneKind kind>
double overlap(const Report& report, const Row& row) {
  return report.timing(row, kind).play.deepest_overlap;
}

class Judge {
 public:
  Judge(const Report& report, const Row& own) : report_(report), own_(own) {}

  std::vector<Bar> judge() {
    against_chipmunk();
    against_box2d();
    in_jams();
    bars_.push_back(
        {"crowds: p90 of the error after 5 ticks, mm", 1e3 * own_.crowd.five_ticks.p90, 0.02});
    for (const SceneKind kind : {SceneKind::jam, SceneKind::scrum}) {
      bars_.push_back(overlap_in(kind, own_, std::string(to_string(kind))));
    }
    better_peers();
    growth();
    for (const Leg& leg : report_.legs) {
      bars_.push_back({"leg of ten minutes, " + leg.name + ": times real time", leg.speed(),
                       leg.name == "trusted" ? 4000.0 : 1500.0, true});
    }
    if (report_.league) {
      bars_.push_back(
          {"league of " + std::to_string(league_teams) + " teams: two jobs, times as fast as one",
           report_.league->gain(), 1.8, true});
    }
    return bars_;
  }

 private:
  const Row* peer(const char* engine) const { return report_.find(engine, "1 ms"); }

  // The ratio of the peer's cost to that of one of our contenders.
  double gain(const Row& peer, SceneKind kind, const Row& own, SceneKind own_kind) const {
    const double factor = peer.contender.engine == "Chipmunk" ? assertions_of_chipmunk(kind) : 1.0;
    return report_.ratio(peer, kind, own, own_kind) / factor;
  }

  Bar overlap_in(SceneKind kind, const Row& row, const std::string& name) const {
    const double deepest = report_.timing(row, kind).play.deepest_overlap;
    return {name + ": deepest overlap, mm", 1e3 * deepest, deepest_in_jams};
  }

  // The cheapest of our levels of accuracy that keeps overlaps in this scene below the limit.
  const Row& cheapest_in(SceneKind kind) const {
    const Row* cheapest = &own_;
    for (const Row& row : report_.rows) {
      if (row.contender.engine != own_.contender.engine) continue;
      if (overlap_in(kind, row, "").measured > deepest_in_jams) continue;
      if (report_.cost(row, kind) < report_.cost(*cheapest, kind)) cheapest = &row;
    }
    return *cheapest;
  }

  void against_chipmunk() {
    const Row* chipmunk = peer("Chipmunk");
    if (chipmunk == nullptr) return;
    bars_.push_back({"quiet tick: Chipmunk's game tick (release, 1 ms), times ours",
                     gain(*chipmunk, SceneKind::game, own_, SceneKind::quiet), 16.0, true});
    bars_.push_back({"game tick: Chipmunk's (release, 1 ms), times ours",
                     gain(*chipmunk, SceneKind::game, own_, SceneKind::game), 8.0, true});
  }

  void against_box2d() {
    double least = HUGE_VAL;
    for (const char* name : {"Box2D, all bullets", "Box2D, ball bullet"}) {
      const Row* box2d = peer(name);
      if (box2d != nullptr) {
        least = std::min(least, gain(*box2d, SceneKind::game, own_, SceneKind::game));
      }
    }
    if (least == HUGE_VAL) return;
    bars_.push_back({"game tick: Box2D's (faster one, 1 ms), times ours", least, 15.0, true});
  }

  // First `standard`, which legs play, then the cheapest level whose overlaps are small enough.
  void in_jams() {
    for (const SceneKind kind : {SceneKind::scrum, SceneKind::jam}) {
      against_fastest_peer(kind, own_, 1.0);
      const Row& cheapest = cheapest_in(kind);
      if (&cheapest == &own_) continue;
      bars_.push_back(overlap_in(kind, cheapest, name_in(kind, cheapest)));
      against_fastest_peer(kind, cheapest, kind == SceneKind::scrum ? 12.0 : 8.0);
    }
  }

  void against_fastest_peer(SceneKind kind, const Row& own, double limit) {
    double least = HUGE_VAL;
    for (const char* engine : {"Chipmunk", "Box2D, all bullets", "Box2D, ball bullet"}) {
      if (const Row* row = peer(engine); row != nullptr) {
        least = std::min(least, gain(*row, kind, own, kind));
      }
    }
    if (least == HUGE_VAL) return;
    bars_.push_back(
        {name_in(kind, own) + ": the fastest peer's tick (1 ms), times ours", least, limit, true});
  }

  static std::string name_in(SceneKind kind, const Row& own) {
    return std::string(to_string(kind)) + ", " + own.contender.point;
  }

  void better_peers() {
    int better = 0;
    for (const Plot& plot : plots()) {
      for (const Row& row : report_.rows) {
        const bool is_cheaper = report_.cost(row, plot.scene) < report_.cost(own_, plot.scene);
        const bool is_closer = plot.error(report_, row) < plot.error(report_, own_);
        better += is_cheaper && is_closer && row.contender.engine != own_.contender.engine;
      }
    }
    bars_.push_back({"points of peers that are both cheaper and closer, in any plot",
                     static_cast<double>(better), 0.0});
  }

  void growth() {
    const auto bodies_in = [&](SceneKind kind) {
      for (const Scene& scene : report_.scenes) {
        if (scene.kind == kind) return bodies(scene);
      }
      return 0;
    };
    for (const SceneKind kind : {SceneKind::game_5, SceneKind::game_11}) {
      const double more = static_cast<double>(bodies_in(kind)) / bodies_in(SceneKind::game);
      bars_.push_back({std::string(to_string(kind)) + " tick over game tick, over bodies",
                       report_.ratio(own_, kind, own_, SceneKind::game) / more, 1.1});
    }
  }

  const Report& report_;
  const Row& own_;
  std::vector<Bar> bars_;
};

}  // namespace

const Timing& Report::timing(const Row& row, SceneKind kind) const {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (scenes[i].kind == kind) return row.timings[i];
  }
  return row.timings.front();
}

double Report::cost(const Row& row, SceneKind kind) const {
  return median(timing(row, kind).rounds_us);
}

double Report::ratio(const Row& row, SceneKind kind, const Row& other, SceneKind other_kind) const {
  std::vector<double> ratios;
  const auto& above = timing(row, kind).rounds_us;
  const auto& below = timing(other, other_kind).rounds_us;
  for (std::size_t i = 0; i < above.size(); ++i) ratios.push_back(above[i] / below[i]);
  return median(std::move(ratios));
}

const Row* Report::find(const std::string& engine, const std::string& point) const {
  for (const Row& row : rows) {
    if (row.contender.engine == engine && row.contender.point == point) return &row;
  }
  return nullptr;
}

const Row& Report::base() const {
  for (const char* name : {"Box2D, all bullets", "Chipmunk", "ODE"}) {
    if (const Row* row = find(name, "1 ms"); row != nullptr) return *row;
  }
  const Row* own = find("mirocup", "standard");
  return own != nullptr ? *own : rows.front();
}

const std::vector<Plot>& plots() {
  static const std::vector<Plot> all{
      {"Nothing touches", "error after 5 ticks (p90), mm", 1e-3, SceneKind::quiet, worst_free},
      {"Game, 3 a side", "error after 5 crowded ticks (p90), mm", 1e-3, SceneKind::game,
       worst_crowd},
      {"Game, 3 a side: the tail", "error after 5 crowded ticks (p99), mm", 1e-3, SceneKind::game,
       tail_of_crowd},
      {"Jams", "deepest overlap, mm", 1e-3, SceneKind::jam, overlap<SceneKind::jam>},
      {"Six robots on the ball", "deepest overlap, mm", 1e-3, SceneKind::scrum,
       overlap<SceneKind::scrum>},
      {"Ball pressed to the wall", "deepest overlap, mm", 1e-3, SceneKind::pinch,
       overlap<SceneKind::pinch>},
  };
  return all;
}

std::vector<Bar> bars(const Report& report) {
  const Row* own = report.find("mirocup", "standard");
  if (own == nullptr) return {};
  return Judge(report, *own).judge();
}

std::string machine() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  std::string model = "unknown processor";
  while (std::getline(info, line)) {
    if (line.rfind("model name", 0) == 0) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  }
#ifdef __clang__
  return model + ", clang++ " + __clang_version__;
#else
  return model + ", g++ " + __VERSION__;
#endif
}

}  // namespace mirocup::bench
