// SPDX-License-Identifier: MIT
#include "labs/bench/report.hpp"

#include <cstdarg>
#include <cstdio>

namespace mirocup::bench {

namespace {

class Text {
 public:
  [[gnu::format(printf, 2, 3)]] void add(const char* format, ...) {
    char line[256];
    va_list values;
    va_start(values, format);
    std::vsnprintf(line, sizeof line, format, values);
    va_end(values);
    text_ += line;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

constexpr int first_column = 30;

void add_name(Text& text, const Row& row) {
  text.add("%-*s", first_column, (row.contender.engine + ", " + row.contender.point).c_str());
}

void add_costs(Text& text, const Report& report) {
  text.add("microseconds a tick (in brackets: over %s, %s)\n%-*s",
           report.base().contender.engine.c_str(), report.base().contender.point.c_str(),
           first_column, "");
  for (const Scene& scene : report.scenes)
    text.add("%17s", std::string(to_string(scene.kind)).c_str());
  text.add("\n");
  for (const Row& row : report.rows) {
    add_name(text, row);
    for (const Scene& scene : report.scenes) {
      text.add("%9.2f (%.3f)", report.cost(row, scene.kind),
               report.ratio(row, scene.kind, report.base(), scene.kind));
    }
    text.add("\n");
  }
}

void add_errors(Text& text, const Report& report) {
  text.add(
      "\nerrors in mm: p90 after 5 ticks alone; in crowds after 1 tick, after 5 ticks of "
      "robots (and p99) and ball; deepest overlaps\n%-*s%10s%10s%10s%10s%10s%10s%10s%10s\n",
      first_column, "", "alone", "1 tick", "robots", "p99", "ball", "jam", "scrum", "pinch");
  for (const Row& row : report.rows) {
    const auto overlap = [&](SceneKind kind) {
      return 1e3 * report.timing(row, kind).play.deepest_overlap;
    };
    add_name(text, row);
    text.add("%10.2g%10.2g%10.2g%10.2g%10.2g%10.2g%10.2g%10.2g\n", 1e3 * row.free.five_ticks.p90,
             1e3 * row.crowd.one_tick.p90, 1e3 * row.crowd.robots.p90, 1e3 * row.crowd.robots.p99,
             1e3 * row.crowd.ball.p90, overlap(SceneKind::jam), overlap(SceneKind::scrum),
             overlap(SceneKind::pinch));
  }
  text.add("the yardstick of crowds against itself: %.2g after 1 tick, %.2g after 5\n",
           1e3 * report.yardstick_one.p90, 1e3 * report.yardstick_five.p90);
}

void add_shots(Text& text, const Report& report) {
  text.add("\nshare of shots that got through, at 3, 6, 10, 30 m/s\n%-*s%28s%28s\n", first_column,
           "", "a robot", "a plate of 5 mm");
  for (const Row& row : report.rows) {
    add_name(text, row);
    for (const auto& shares : {row.shots.through_robot, row.shots.through_plate}) {
      for (const double share : shares) text.add("%7.2f", share);
    }
    text.add("\n");
  }
}

}  // namespace

std::string to_text(const Report& report) {
  Text text;
  text.add("%s; %d rounds\n\n", machine().c_str(), report.rounds);
  add_costs(text, report);
  add_errors(text, report);
  add_shots(text, report);
  text.add("\n");
  for (const Leg& leg : report.legs) {
    text.add("leg, %s: %.0f s played in %.3f s of processor time, %.3f s on the wall\n",
             leg.name.c_str(), leg.played_seconds, leg.cpu_seconds, leg.wall_seconds);
  }
  if (report.league) {
    text.add(
        "league of %d house teams, each twice against each: %.1f s by one job, %.1f s by two\n",
        league_teams, report.league->one_job_seconds, report.league->two_jobs_seconds);
  }
  text.add("\n%-66s%12s%12s\n", "asked", "measured", "limit");
  for (const Bar& bar : bars(report)) {
    text.add("%-66s%12.3g%4s%8.3g  %s\n", bar.name.c_str(), bar.measured,
             bar.at_least ? ">=" : "<=", bar.limit, bar.met() ? "met" : "missed");
  }
  return text.take();
}

}  // namespace mirocup::bench
