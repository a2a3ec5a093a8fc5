// SPDX-License-Identifier: MIT
#include "training/starts.hpp"

#include "record/drawn_situation.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"

#include <filesystem>
#include <optional>

namespace mirocup::training {

namespace {

using record::JsonReader;
using StartJson = JsonReader::Json;

constexpr std::string_view drill_schema = "mirocup/drill/1";

// The file of a start that is given as text: a path, or the name of a drill.
std::string file_of(const std::string& word, const std::string& folder) {
  system::Disk disk;
  if (word.find('/') == std::string::npos) {
    const std::string drill =
        (std::filesystem::path(system::drill_folder(folder)) / (word + ".json")).string();
    if (disk.exists(drill)) return drill;
  }
  return disk.exists(word) ? word : "";
}

// The league that a document names, and the situation of a drill or the document itself.
StartJson situation_of(const StartJson& document) {
  const bool is_drill = document.is_object() && document.value("schema", "") == drill_schema;
  if (!is_drill) return document;
  StartJson situation = document.value("situation", StartJson::object());
  if (document.contains("league")) situation["league"] = document["league"];
  return situation;
}

StartRanges read_file(const JsonReader& json, const std::string& folder) {
  StartRanges start{.name = json.text(), .situation = StartJson::object()};
  const std::string path = file_of(start.name, folder);
  if (path.empty()) {
    json.complain("a situation, the name of a drill or a file of one of them is expected, not " +
                  json.quoted());
    return start;
  }
  system::Disk disk;
  const auto text = disk.read_named(path, system::size_limit::note);
  if (!text) {
    json.complain(text.error().what);
    return start;
  }
  record::ParsedJson parsed = record::parse_json(*text);
  if (parsed.problem) {
    json.complain(record::error_of(*parsed.problem, path, Errc::input).what);
    return start;
  }
  start.situation = situation_of(parsed.value);
  return start;
}

StartRanges read_start(const JsonReader& json, const std::string& folder) {
  if (json.is_string()) return read_file(json, folder);
  StartRanges start{.name = "start", .situation = StartJson::object()};
  if (json.expect_object()) start.situation = situation_of(json.json());
  return start;
}

void check(const JsonReader& json, const StartRanges& start, League league, bool is_even) {
  Random random(1);
  const auto once = record::draw_situation(start.situation, league, random, start.name);
  if (!once) return json.complain(once.error().what);
  if (once->league != league) json.complain("its situation is of another league than the matches");
  const auto& score = once->start.score;
  if (is_even && score[0] != score[1]) {
    json.complain("with ends_at_goal the score at the start has to be level");
  }
}

}  // namespace

std::vector<StartRanges> read_starts(const JsonReader& json, League league, bool is_even,
                                     const std::string& folder) {
  std::vector<StartRanges> starts;
  const auto add = [&](const JsonReader& one) {
    starts.push_back(read_start(one, folder));
    check(one, starts.back(), league, is_even);
  };
  if (json.json().is_array()) {
    for (const JsonReader& one : json.elements(1)) add(one);
  } else {
    add(json);
  }
  return starts;
}

Result<match::Start> draw_start(const std::vector<StartRanges>& starts, League league,
                                Random& random) {
  const StartRanges& start = starts[random.below(starts.size())];
  MIROCUP_TRY(auto situation, record::draw_situation(start.situation, league, random, start.name));
  return situation.start;
}

}  // namespace mirocup::training
