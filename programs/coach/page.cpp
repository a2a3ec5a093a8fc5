// SPDX-License-Identifier: MIT
#include "programs/coach/page.hpp"

#include "core/replay/playback.hpp"
#include "programs/coach/process_copy.hpp"
#include "system/printable.hpp"
#include "web/design/template.hpp"
#include "web/page_parts.hpp"
#include "web/picture.hpp"

#include <array>

namespace mirocup::coach {

namespace {

using record::Json;

// What the page shows of a goal. Films and marks begin at the first tick of the study.
Result<Json> films_of(const record::MatchRecord& record, const Cast& cast, const GoalStudy& goal) {
  replay::Playback playback(record.recording);
  const match::Leg& leg = playback.leg();
  const int robots = leg.field().robots_per_team;
  const double period = leg.setup().control_period;
  const std::uint32_t end = goal.tick + ticks_of(after_goal_s, leg);
  while (leg.tick() < goal.first) playback.advance();
  Json json{{"period", period},
            {"robots", robots},
            {"left", to_string(leg.snapshot().left)},
            {"marks", {{"goal", goal.tick - goal.first}}}};
  web::ColumnEncoder played;
  do played.add(web::frame_of(leg.snapshot(), robots, played.last()));
  while (leg.tick() < end && playback.advance());
  json["played"] = web::track_json(played);
  if (!goal.prevention) return json;

  MIROCUP_TRY(const auto rehearsal, Rehearsal::begin(record, cast));
  web::ColumnEncoder other;
  rehearsal->follow(goal.first);
  rehearsal->show_in(other);
  rehearsal->follow(goal.prevention->tick);
  const auto is_without_goal = [&](int number) {
    return rehearsal->is_without_goal(goal.tick, goal.prevention->robot, number);
  };
  int number = first_counted;  // most of the counted futures are without the goal
  while (!Copy([&] { return is_without_goal(number); }).wait().value_or(true)) ++number;
  is_without_goal(number);
  json["other"] = web::track_json(other);
  json["substituted"] = index_of(cast.team) * robots + goal.prevention->robot;
  json["marks"]["decides"] = goal.prevention->tick - goal.first;
  return json;
}

}  // namespace

Result<std::string> page_of(const record::MatchRecord& record, const Cast& cast,
                            const std::vector<GoalStudy>& goals,
                            const std::vector<std::string>& texts, const std::string& about) {
  constexpr std::array<std::string_view, 5> modules{"text.js", "track.js", "field.js", "player.js",
                                                    "coach.js"};
  Json data = Json::array();
  Json shown = Json::array();
  for (std::size_t i = 0; i < goals.size(); ++i) {
    MIROCUP_TRY(data.emplace_back(), films_of(record, cast, goals[i]));
    shown.push_back({{"text", texts[i]}, {"other", nullptr}});
    if (const auto& found = goals[i].prevention)
      shown.back()["other"] = "A substitute for robot " + std::to_string(found->robot) + " of " +
                              system::printable(record.teams[index_of(cast.team)].name);
  }
  const std::string script = web::page_script(modules);
  return web::filled(web::asset, "coach.html",
                     {{"policy", web::page_policy(script, web::ModulePlace::nowhere)},
                      {"style", web::page_style()},
                      {"picture", web::picture(match::Leg(record.recording.setup))},
                      {"goals", shown},
                      {"about", about},
                      {"data", web::embedded(data)},
                      {"script", script}});
}

}  // namespace mirocup::coach
