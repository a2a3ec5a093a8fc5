// SPDX-License-Identifier: MIT
//
// `mirocup league COMMAND FOLDER ...` as a list of words, and small leagues to try it on.
#pragma once

#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace mirocup::test_support {

inline std::vector<std::string> league(const std::string& command, const std::string& folder,
                                       const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{program("mirocup"), "league", command, folder};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// NAME=ENTRY for each team.
inline void init_league(const std::string& folder, const std::vector<std::string>& teams,
                        const std::string& half = "1", const std::string& format = "") {
  std::vector<std::string> more{"--half", half, "--seed", "3"};
  for (const std::string& team : teams) more.insert(more.end(), {"--team", team});
  if (!format.empty()) more.insert(more.end(), {"--format", format});
  const Outcome made = run(league("init", folder, more));
  ASSERT_EQ(made.exit_code, 0) << made.err;
}

inline std::vector<nlohmann::json> journal_of(const std::string& folder) {
  std::vector<nlohmann::json> lines;
  std::istringstream text(read_file(folder + "/journal.jsonl"));
  for (std::string line; std::getline(text, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

inline int count_kind(const std::string& folder, const std::string& kind) {
  int count = 0;
  for (const auto& line : journal_of(folder)) count += line["kind"] == kind ? 1 : 0;
  return count;
}

}  // namespace mirocup::test_support
