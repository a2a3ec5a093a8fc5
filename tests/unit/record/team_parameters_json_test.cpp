// SPDX-License-Identifier: MIT
//
// Catches a parameter of a team that is changed between a command line, a record and the table of
// the mailbox, and one that would not fit there.
#include "record/team_parameters_json.hpp"

#include "plugins/host/team_host.hpp"
#include "record/json_reader.hpp"
#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace mirocup::record {
namespace {

using match::TeamParameters;
using Json = nlohmann::ordered_json;

TeamParameters read(const Json& json, std::optional<JsonProblem>& problem) {
  return read_team_parameters(JsonReader(json, "/parameters", problem));
}

TEST(TeamParameters, ReadBackFromJsonAndFromACommandLine) {
  const TeamParameters parameters{{"wait", 0.1 + 0.2}, {"Kick.speed-2", -1e-300}, {"n", 7.0}};
  std::optional<JsonProblem> problem;
  EXPECT_EQ(read(to_json(parameters), problem), parameters);
  EXPECT_FALSE(problem);
  std::vector<std::string> changes;
  for (const std::string& word : parameter_options(parameters, "--param")) {
    if (word != "--param") changes.push_back(word);
  }
  EXPECT_EQ(parameters_with_changes({}, changes, "--param"), parameters);
}

TEST(TeamParameters, TheLastValueOfANameCounts) {
  EXPECT_EQ(parameters_with_changes({{"a", 1.0}, {"b", 2.0}}, {"a=3", "a=.5"}, "--blue-param"),
            (TeamParameters{{"a", 0.5}, {"b", 2.0}}));
}

TEST(TeamParameters, AreRefusedWithTheOptionAndTheReason) {
  const auto error_of = [](const std::string& change) {
    return test_support::why_not(parameters_with_changes({}, {change}, "--param"));
  };
  EXPECT_EQ(error_of("wait"), "--param wait: KEY=VALUE with a number is expected");
  EXPECT_EQ(error_of("wait=far"), "--param wait=far: KEY=VALUE with a number is expected");
  EXPECT_EQ(error_of("wait=1 "), "--param wait=1 : KEY=VALUE with a number is expected");
  EXPECT_EQ(error_of("wait=nan"), "--param wait=nan: KEY=VALUE with a number is expected");
  EXPECT_EQ(error_of("wait=inf"), "--param wait=inf: KEY=VALUE with a number is expected");
  const std::string name =
      "a name of letters, digits, '_', '-' and '.' is expected, which begins "
      "with a letter and has at most 31 bytes, not ";
  EXPECT_EQ(error_of("=1"), "--param =1: " + name + "\"\"");
  EXPECT_EQ(error_of("2x=1"), "--param 2x=1: " + name + "\"2x\"");
  EXPECT_EQ(error_of(std::string(31, 'x') + "=1"), "");
  EXPECT_NE(error_of(std::string(32, 'x') + "=1"), "");

  Json many = Json::object();
  std::optional<JsonProblem> problem;
  for (int i = 0; i < 32; ++i) many["p" + std::to_string(i)] = i;
  EXPECT_EQ(read(many, problem).size(), 32u);
  EXPECT_FALSE(problem);
  many["one more"] = 1;
  (void)read(many, problem);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->pointer, "/parameters");
  EXPECT_EQ(problem->reason, "at most 32 parameters are expected, not 33");
}

// Catches a row that is found by the beginning of its name, a last row that is left out, and a name
// that counts as asked for although only its neighbour was.
TEST(TeamParameters, AreFoundInTheTableByTheirWholeName) {
  TeamParameters parameters;
  for (int i = 0; i < 31; ++i) parameters["p" + std::to_string(i)] = i;
  parameters[std::string(31, 'z')] = 31.0;
  const plugins::ParameterTable table = plugins::parameter_table(parameters);
  plugins::AskedRows asked{0};
  plugins::TeamHost host{&table, &asked};
  EXPECT_EQ(plugins::parameter_of(&host, "p", 0.5), 0.5);
  EXPECT_EQ(plugins::parameter_of(&host, "p100", 0.5), 0.5);
  EXPECT_EQ(plugins::parameter_of(&host, nullptr, 0.5), 0.5);
  EXPECT_EQ(plugins::parameter_of(nullptr, "p1", 0.5), 0.5);
  EXPECT_EQ(asked, 0u);
  for (const auto& entry : parameters) {
    EXPECT_EQ(plugins::not_asked_for(parameters, asked).count(entry.first), 1u);
    EXPECT_EQ(plugins::parameter_of(&host, entry.first.c_str(), 0.5), entry.second);
    EXPECT_EQ(plugins::not_asked_for(parameters, asked).count(entry.first), 0u);
  }
}

}  // namespace
}  // namespace mirocup::record
