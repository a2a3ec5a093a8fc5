// SPDX-License-Identifier: MIT
//
// Judges situations with expected verdicts, one line of JSON each (tests/programs/referee/*.jsonl),
// with mirocup referee: as they are, and turned by 180 degrees with the teams exchanged. The
// verdict must turn with them. Catches a law that is missing, one that is called a sample too early
// or too late, a threshold on the wrong side, a wrong order of two laws, and a judgement that
// depends on the end.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace mirocup {
namespace {

using nlohmann::json;
using namespace test_support;

constexpr double default_tolerance = 0.04;  // s, of "at"
constexpr double half_turn = 3.14159265358979323846;

std::string other(const std::string& name) {
  if (name.empty() || (name[0] != 'L' && name[0] != 'R')) return name;
  return (name[0] == 'L' ? "R" : "L") + name.substr(1);
}

json turned_point(const json& p) {
  json turned{-p[0].get<double>(), -p[1].get<double>()};
  if (p.size() > 2) turned.push_back(p[2].get<double>() + half_turn);
  return turned;
}

bool is_point(const json& value) {
  return value.is_array() && value.size() >= 2 && value.size() <= 3 && value[0].is_number();
}

// Returns the value of a key, turned; the key may stand anywhere in a situation or a verdict.
json turned(const json& value, const std::string& key);

json turned_object(const json& object) {
  json result = json::object();
  for (const auto& [key, value] : object.items()) {
    result[other(key)] = turned(value, key);
  }
  return result;
}

json turned(const json& value, const std::string& key) {
  const bool is_other_list =
      key == "clock_stops" || key.ends_with("_moved") || key.ends_with("_legal");
  if (is_other_list) return value;
  if (key == "score") return {value[1], value[0]};
  if (key == "amp" || key == "keeper_touch_x") return -value.get<double>();
  if (key == "quarter") {
    std::string signs = value.get<std::string>();
    for (char& sign : signs) sign = sign == '+' ? '-' : '+';
    return signs;
  }
  if (value.is_string()) {
    const bool is_robot_or_team = key == "taker" || key == "for" || key == "winner" ||
                                  key == "team" || key == "places_first" || key == "next_taker" ||
                                  key == "last_touch" || key == "call" || key == "robots" ||
                                  key == "contacts" || key == "hand" || key == "fallen" ||
                                  key == "substitute" || key == "missing";
    return is_robot_or_team ? json(other(value.get<std::string>())) : value;
  }
  if (value.is_object()) return turned_object(value);
  if (is_point(value)) return turned_point(value);
  if (value.is_array()) {
    json list = json::array();
    for (const json& item : value) list.push_back(turned(item, key));
    return list;
  }
  return value;
}

// Returns the first difference between the expected and the given verdict; "" if there is none.
std::string difference(const json& expected, const json& verdict);

std::string difference_at(const std::string& key, const json& expected, const json& verdict) {
  if (key.rfind("at_", 0) == 0) return difference({{"decision", expected}}, verdict);
  if (!verdict.contains(key)) return key + " is missing";
  const json& found = verdict[key];
  if (expected.is_object()) return difference(expected, found);
  bool same = expected == found;
  if (is_point(expected)) {
    same = is_point(found) && std::abs(expected[0].get<double>() - found[0].get<double>()) < 1e-6 &&
           std::abs(expected[1].get<double>() - found[1].get<double>()) < 1e-6;
  } else if (key == "wall_robots") {
    same = found.size() == expected.size();  // the order of the robots is not specified
  } else if (key == "robots") {
    same = json(std::set<json>(expected.begin(), expected.end())) ==
           json(std::set<json>(found.begin(), found.end()));
  }
  return same ? "" : key + " is " + found.dump() + ", expected " + expected.dump();
}

std::string difference(const json& expected, const json& verdict) {
  for (const auto& [key, value] : expected.items()) {
    if (key == "note" || key == "tol") continue;
    if (key == "at") {
      const double tolerance = expected.value("tol", default_tolerance);
      if (verdict["at"].is_number() &&
          std::abs(verdict["at"].get<double>() - value.get<double>()) <= tolerance) {
        continue;
      }
      return "at is " + verdict["at"].dump() + ", expected " + value.dump();
    }
    const std::string text = difference_at(key, value, verdict);
    if (!text.empty()) return text;
  }
  return "";
}

std::vector<json> read_lines(const std::string& text) {
  std::vector<json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(json::parse(line));
  }
  return lines;
}

void judge(const std::vector<json>& cases, const std::string& how) {
  const TemporaryFolder folder;
  std::string traces;
  for (const json& one : cases) traces += one.dump() + "\n";
  write_file(folder / "trace.jsonl", traces);
  const Outcome outcome = expect_exit(0, run_mirocup({"referee", folder / "trace.jsonl"}));
  const std::vector<json> verdicts = read_lines(outcome.out);
  ASSERT_EQ(verdicts.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(verdicts[i]["id"], cases[i]["id"]);
    EXPECT_EQ(difference(cases[i]["expect"], verdicts[i]), "")
        << how << ": " << cases[i]["id"] << " " << cases[i].value("note", "") << "\n"
        << verdicts[i].dump();
  }
}

class Situations : public testing::TestWithParam<std::string> {};

std::vector<std::string> files() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(MIROCUP_SOURCE_FOLDER "/tests/programs/referee")) {
    if (entry.path().extension() == ".jsonl") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}
INSTANTIATE_TEST_SUITE_P(Files, Situations, testing::ValuesIn(files()),
                         [](const auto& file) { return file.param; });

TEST_P(Situations, GetTheExpectedVerdictAtBothEnds) {
  const std::string path = MIROCUP_SOURCE_FOLDER "/tests/programs/referee/" + GetParam() + ".jsonl";
  const std::vector<json> cases = read_lines(read_file(path));
  ASSERT_FALSE(cases.empty());
  judge(cases, "as it is");
  std::vector<json> other_way;
  for (const json& one : cases) other_way.push_back(turned_object(one));
  judge(other_way, "turned");
}

TEST(RefereeCommand, RejectsLinesThatAreNotSituations) {
  const TemporaryFolder folder;
  write_file(folder / "t.jsonl",
             "{\"id\": \"a\", \"league\": \"huge\"}\nnothing\n{\"id\": \"c\"}\n");
  const Outcome outcome = expect_exit(1, run_mirocup({"referee", folder / "t.jsonl"}));
  const std::vector<json> verdicts = read_lines(outcome.out);
  ASSERT_EQ(verdicts.size(), 3u) << "one verdict a line, whatever the line says";
  EXPECT_EQ(verdicts[0]["decision"], "REJECTED");
  EXPECT_EQ(verdicts[1]["decision"], "REJECTED");
  EXPECT_EQ(verdicts[2]["decision"], "NONE");
  EXPECT_TRUE(contains(outcome.err, "t.jsonl:1: /league"));
  EXPECT_EQ(run_mirocup({"referee", folder / "no.jsonl"}).exit_code, 3);
}

}  // namespace
}  // namespace mirocup
