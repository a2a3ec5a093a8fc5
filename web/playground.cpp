// SPDX-License-Identifier: MIT
#include "web/playground.hpp"

#include "core/match/leg.hpp"
#include "record/json_reader.hpp"
#include "system/locations.hpp"
#include "web/design/template.hpp"
#include "web/picture.hpp"

#include <array>
#include <string_view>

namespace mirocup::web {

using record::Json;

namespace {

// The drills by their names.
Result<Json> drills_json(system::Files& files) {
  const std::string folder = system::drill_folder();
  MIROCUP_TRY(const auto names, files.names_in(folder));
  Json drills = Json::object();
  for (const std::string& name : names) {
    if (!name.ends_with(".json")) continue;
    MIROCUP_TRY(const auto text, files.read_named(folder + "/" + name, system::size_limit::note));
    auto parsed = record::parse_json(text);
    if (!parsed.problem) drills[name.substr(0, name.size() - 5)] = std::move(parsed.value);
  }
  return drills;
}

}  // namespace

Result<std::optional<std::string>> playground_page(system::Files& files) {
  MIROCUP_TRY(const auto module, browser_module(files));
  if (!module) return std::nullopt;
  MIROCUP_TRY(auto drills, drills_json(files));
  constexpr std::array<std::string_view, 11> modules{
      "text.js", "track.js",    "field.js", "actions.js", "layers.js",    "situation.js",
      "log.js",  "thoughts.js", "proof.js", "play.js",    "playground.js"};
  Json data{
      {"module", module_json(*module)}, {"leagues", Json::object()}, {"drills", std::move(drills)}};
  Json pictures = Json::array();
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle, RobotLeague::large}) {
    const std::string name(to_string(league));
    match::Setup setup;
    setup.league = league;
    setup.rules = referee::make_rules(referee::Preset::mirosot, setup.league);
    const match::Leg leg(setup);
    data["leagues"][name] = {{"robots", leg.field().robots_per_team},
                             {"zones", zones_json(leg.field())}};
    pictures.push_back({{"league", name}, {"picture", picture(leg)}});
  }
  const std::string code = page_script(modules);
  return filled(asset, "playground.html",
                {{"policy", page_policy(code, ModulePlace::in_the_page)},
                 {"style", page_style()},
                 {"pictures", pictures},
                 {"own_layers", true},
                 {"data", embedded(data)},
                 {"script", code}});
}

}  // namespace mirocup::web
