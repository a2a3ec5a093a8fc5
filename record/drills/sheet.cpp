// SPDX-License-Identifier: MIT
#include "record/drills/sheet.hpp"

#include "record/json_reader.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace mirocup::drills {

namespace {

constexpr std::size_t max_sheet_drills = 100;

std::string stem_of(const std::string& path) {
  return std::filesystem::path(path).stem().string();
}

SheetDrill read_sheet_drill(const record::JsonReader& json) {
  SheetDrill drill;
  if (!json.expect_object({"drill", "name", "weight", "change"})) return drill;
  drill.drill = json.at("drill").text();
  drill.name = stem_of(drill.drill);
  json.read_if_present("name", drill.name);
  if (json.has("weight")) drill.weight = json.at("weight").positive_number();
  drill.change = nlohmann::ordered_json::object();
  if (json.has("change") && json.at("change").expect_object())
    drill.change = json.at("change").json();
  return drill;
}

Sheet read_sheet(const record::JsonReader& json) {
  Sheet sheet;
  if (!json.expect_object({"schema", "title", "start", "reference", "drills", "not_allowed"}))
    return sheet;
  json.expect_schema("mirocup/sheet/1");
  sheet.title = json.at("title").text();
  sheet.start = json.at("start").text();
  sheet.reference = json.at("reference").text();
  if (json.has("not_allowed")) {
    for (const record::JsonReader& word : json.at("not_allowed").elements(1, max_sheet_drills)) {
      sheet.not_allowed.push_back(word.text());
      if (sheet.not_allowed.back().empty()) word.complain("a word is expected");
    }
  }
  for (const record::JsonReader& one : json.at("drills").elements(1, max_sheet_drills)) {
    sheet.drills.push_back(read_sheet_drill(one));
    const std::string& name = sheet.drills.back().name;
    const auto same = [&](const SheetDrill& drill) { return drill.name == name; };
    if (std::count_if(sheet.drills.begin(), sheet.drills.end(), same) > 1)
      one.complain("another drill of the sheet is called \"" + name + "\": give it a \"name\"");
  }
  return sheet;
}

}  // namespace

std::string found_word(std::string_view source, const std::vector<std::string>& words) {
  const auto is_in_word = [&](std::size_t at) {
    return at < source.size() && std::isalnum(static_cast<unsigned char>(source[at])) != 0;
  };
  for (const std::string& word : words) {  // none is empty
    const bool is_name = std::isalnum(static_cast<unsigned char>(word.back())) != 0;
    for (std::size_t at = source.find(word); at != std::string_view::npos;
         at = source.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      if (is_in_word(at - 1) || (is_name && (is_in_word(end) || source.substr(end, 1) == "_")))
        continue;
      const auto line = 1 + std::count(source.begin(), source.begin() + at, '\n');
      return "line " + std::to_string(line) + " has " + word;
    }
  }
  return "";
}

Result<Sheet> parse_sheet(std::string_view text, const std::string& path) {
  auto sheet = record::read_json<Sheet>(text, path, Errc::input, read_sheet);
  if (sheet) sheet->name = stem_of(path);
  return sheet;
}

Result<Drill> parse_changed_drill(std::string_view text, const std::string& path,
                                  const SheetDrill& of_sheet) {
  auto parsed = record::parse_json(text);
  if (parsed.problem) return tl::unexpected(record::error_of(*parsed.problem, path, Errc::input));
  parsed.value.merge_patch(of_sheet.change);
  auto drill = parse_drill(record::json_text(parsed.value), path);
  if (drill) drill->name = of_sheet.name;
  return drill;
}

}  // namespace mirocup::drills
