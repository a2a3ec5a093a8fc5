// SPDX-License-Identifier: MIT
#include "web/page_json.hpp"

#include "record/json_reader.hpp"
#include "record/statistics/statistics_json.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::web {

Json moment_json(const match::Snapshot& scene) {
  return {{"state", to_string(scene.state)},
          {"phase", to_string(scene.phase)},
          {"left", to_string(scene.left)},
          {"score", {{"blue", scene.score[0]}, {"yellow", scene.score[1]}}}};
}

Json keepers_json(const match::Snapshot& scene) {
  return {scene.counts[0].keeper, scene.counts[1].keeper};
}

Json statistics_json(const statistics::LegStatistics& leg) {
  Json json = statistics::to_json(leg);
  for (const char* list : {"goals", "fouls"}) json.erase(list);
  return json;
}

std::string event_text(const char* name, const Json& data) {
  // The data is one line, so a name of a team cannot start another event.
  return std::string("event: ") + name + "\ndata: " + record::json_text(data) + "\n\n";
}

}  // namespace mirocup::web
