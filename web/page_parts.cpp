// SPDX-License-Identifier: MIT
#include "web/page_parts.hpp"

#include "record/json_reader.hpp"
#include "record/statistics/statistics_json.hpp"
#include "system/digest.hpp"
#include "system/locations.hpp"
#include "system/text.hpp"
#include "web/design/template.hpp"
#include "web/markings.hpp"

#include <algorithm>
#include <zlib.h>

namespace mirocup::web {

Result<std::optional<BrowserModule>> browser_module(system::Files& files) {
  const std::string folder = system::browser_folder();
  const auto read = [&files, &folder](const char* name) {
    return files.read_if_there(folder + name, {.max_size = system::size_limit::page});
  };
  MIROCUP_TRY(auto script, read("/mirocup.js"));
  MIROCUP_TRY(auto wasm, read("/mirocup.wasm"));
  if (!script || !wasm) return std::nullopt;
  return BrowserModule{std::move(*script), std::move(*wasm)};
}

std::string page_script(std::span<const std::string_view> modules) {
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

std::string page_style() {
  return std::string(design_file("design.css")) + std::string(asset("page.css"));
}

std::string page_policy(const std::string& script, ModulePlace module) {
  const bool is_beside = script.empty();
  // Not every browser counts files beside a page on a disk as its own.
  std::string policy = is_beside ? "default-src 'none'; style-src 'self' file:; "
                                 : "default-src 'none'; style-src 'unsafe-inline'; ";
  policy += "connect-src 'self'; script-src ";
  policy += is_beside ? "'self' file:" : "'sha256-" + system::sha256_base64(script) + "'";
  if (module == ModulePlace::beside_it && !is_beside) policy += " 'self'";
  return module == ModulePlace::nowhere ? policy : policy + " 'wasm-unsafe-eval'; worker-src blob:";
}

std::string embedded(const record::Json& json) {
  return system::replaced(record::json_text(json), "<", "\\u003c");
}

record::Json module_json(const BrowserModule& module) {
  return {{"script", packed_text(module.script)}, {"wasm", packed_text(module.wasm)}};
}

ScriptFile module_file(const BrowserModule& module) {
  constexpr std::size_t digits = 16;
  std::string text =
      "globalThis.mirocup_module = " + record::json_text(module_json(module)) + ";\n";
  const std::string name = "module/" + system::sha256(text).substr(0, digits) + ".js";
  return {name, std::move(text)};
}

record::Json zones_json(const field::Field& field) {
  const Markings marks = markings(field);
  return {{"left", marks.zones[index_of(End::left)]}, {"right", marks.zones[index_of(End::right)]}};
}

std::string packed_text(std::string_view text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  const bool is_packed = compress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                                  reinterpret_cast<const Bytef*>(text.data()), text.size()) == Z_OK;
  bytes.resize(is_packed ? size : 0);  // 0: for want of memory
  return system::base64(bytes);
}

Json track_json(const ColumnEncoder& frames) {
  return {{"frames", frames.rows()}, {"packed", system::base64(frames.bytes())}};
}

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
