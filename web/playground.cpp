// SPDX-License-Identifier: MIT
#include "web/playground.hpp"

#include "core/match/leg.hpp"
#include "record/json_reader.hpp"
#include "system/digest.hpp"
#include "system/locations.hpp"
#include "system/text.hpp"
#include "web/design/template.hpp"
#include "web/picture.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

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

// What both pages show: fields and drills.
struct Parts {
  Json data;
  Json pictures = Json::array();
};

Result<Parts> common_parts(system::Files& files) {
  MIROCUP_TRY(auto drills, drills_json(files));
  Parts parts{.data = {{"leagues", Json::object()}, {"drills", std::move(drills)}}};
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle, RobotLeague::large}) {
    const std::string name(to_string(league));
    match::Setup setup;
    setup.league = league;
    setup.rules = referee::make_rules(referee::Preset::mirosot, setup.league);
    const match::Leg leg(setup);
    parts.data["leagues"][name] = {{"robots", leg.field().robots_per_team},
                                   {"zones", zones_json(leg.field())}};
    parts.pictures.push_back({{"league", name}, {"picture", picture(leg)}});
  }
  return parts;
}

std::string page_of(const Parts& parts, Json values) {
  values["style"] = page_style();
  values["pictures"] = parts.pictures;
  values["own_layers"] = true;
  values["data"] = embedded(parts.data);
  return filled(asset, "playground.html", values);
}

// The last ones are those of the workbench alone.
constexpr std::array<std::string_view, 14> page_modules{
    "text.js",       "track.js",     "field.js",    "actions.js",  "layers.js",
    "situation.js",  "log.js",       "thoughts.js", "proof.js",    "play.js",
    "playground.js", "inspector.js", "momentum.js", "workbench.js"};
constexpr std::size_t modules_of_workbench = 3;

// Returns the files of a folder of the build, without their bytes; none if there is no such folder.
Result<std::vector<WorkbenchFile>> files_of(system::Files& files, const std::string& folder) {
  MIROCUP_TRY(const auto names, files.names_if_there(folder));
  std::vector<WorkbenchFile> all;
  for (const std::string& name : names)
    all.push_back({.name = name, .text = "", .source = folder + "/" + name});
  return all;
}

// Puts the files into a folder that is named by their content, and returns its name and their size.
Result<std::pair<std::string, std::size_t>> move_to_hashed_folder(system::Files& files,
                                                                  std::string name,
                                                                  std::vector<WorkbenchFile> from,
                                                                  std::vector<WorkbenchFile>& to) {
  constexpr std::size_t digits = 16;
  std::ranges::sort(from,
                    [](const WorkbenchFile& a, const WorkbenchFile& b) { return a.name < b.name; });
  system::Sha256 digest;
  std::size_t size = 0;
  for (const WorkbenchFile& file : from) {
    MIROCUP_TRY(const auto bytes, bytes_of(files, file));
    digest.add(file.name + "\n" + system::sha256(bytes));
    size += bytes.size();
  }
  name += "-" + digest.digits().substr(0, digits);
  for (WorkbenchFile& file : from) {
    file.name = name + "/" + file.name;
    to.push_back(std::move(file));
  }
  return std::pair(std::move(name), size);
}

}  // namespace

Result<std::optional<std::string>> playground_page(system::Files& files) {
  MIROCUP_TRY(const auto module, browser_module(files));
  if (!module) return std::nullopt;
  MIROCUP_TRY(auto parts, common_parts(files));
  parts.data["module"] = module_json(*module);
  const std::string code =
      page_script(std::span(page_modules).first(page_modules.size() - modules_of_workbench));
  return page_of(parts, {{"title", "Playground"},
                         {"policy", page_policy(code, ModulePlace::in_the_page)},
                         {"script", code}});
}

Result<std::string> bytes_of(system::Files& files, const WorkbenchFile& file) {
  if (file.source.empty()) return file.text;
  return files.read_named(file.source, system::size_limit::page);
}

Result<std::vector<WorkbenchFile>> workbench_files(system::Files& files, const std::string& folder,
                                                   bool takes_hand_ins) {
  const std::string built = system::browser_folder() + "/workbench/";
  MIROCUP_TRY(auto parts, files_of(files, built + "parts"));
  MIROCUP_TRY(auto compiler, files_of(files, built + "clang"));
  MIROCUP_TRY(auto module, browser_module(files));
  if (parts.empty() || compiler.empty() || !module) return std::vector<WorkbenchFile>{};
  parts.push_back({"mirocup.js", std::move(module->script)});
  parts.push_back({"mirocup.wasm", std::move(module->wasm)});
  parts.push_back({"page.js", "(() => {\n'use strict';\n" + page_script(page_modules) + "})();\n"});

  std::vector<WorkbenchFile> all(1);
  MIROCUP_TRY(const auto clang,
              move_to_hashed_folder(files, folder + "clang", std::move(compiler), all));
  MIROCUP_TRY(const auto own,
              move_to_hashed_folder(files, folder + "parts", std::move(parts), all));
  MIROCUP_TRY(auto team, files.read_named(system::team_kit().templates + "/c++/team.cpp",
                                          system::size_limit::note));
  MIROCUP_TRY(auto page, common_parts(files));
  page.data["workbench"] = {{"parts", own.first},
                            {"clang", clang.first},
                            {"bytes", clang.second},
                            {"team", system::replaced(std::move(team), "@NAME@", "mine")}};
  Json scripts = Json::array();
  for (const char* name : {"ace", "mode-c_cpp", "theme-chrome", "theme-one_dark",
                           "ext-language_tools", "ext-searchbox", "page"})
    scripts.push_back(own.first + "/" + name + ".js");
  all.front() = {
      folder.empty() ? "index.html" : folder.substr(0, folder.size() - 1),
      page_of(page, {{"title", "Workbench"},
                     {"code", true},
                     {"hand_in", takes_hand_ins},
                     {"policy",
                      "default-src 'none'; style-src 'self' 'unsafe-inline'; img-src "
                      "'self' data:; script-src 'self'; worker-src 'self'; connect-src 'self'"},
                     {"scripts", std::move(scripts)}})};
  return all;
}

}  // namespace mirocup::web
