// SPDX-License-Identifier: MIT
//
// `mirocup league COMMAND FOLDER ...` as a list of words, and small leagues for tests.
#pragma once

#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
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

// Returns the library of a house team.
inline std::string house(const std::string& name) {
  return program("house/" + name + ".so");
}

// Returns NAME=ENTRY for each team.
inline void init_league(const std::string& folder, const std::vector<std::string>& teams,
                        const std::string& half = "1", const std::string& format = "") {
  std::vector<std::string> more{"--half", half, "--seed", "3"};
  for (const std::string& team : teams) more.insert(more.end(), {"--team", team});
  if (!format.empty()) more.insert(more.end(), {"--format", format});
  expect_exit(0, run(league("init", folder, more)));
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

// Waits until a match server of the league has written its first file.
inline bool wait_until_it_plays(const std::string& folder) {
  return wait_until([&] { return !std::filesystem::is_empty(folder + "/records"); });
}

// Every file below site/ with its bytes.
inline std::map<std::string, std::string> site_of(const std::string& folder) {
  const std::filesystem::path site = folder + "/site";
  std::map<std::string, std::string> files;
  for (const auto& file : std::filesystem::recursive_directory_iterator(site)) {
    if (!file.is_regular_file()) continue;
    files[file.path().lexically_relative(site)] = read_file(file.path());
  }
  return files;
}

// Expects two leagues to have the same pages, replays included, whatever process played their legs
// and in whatever order.
inline void expect_same_site(const std::string& folder, const std::string& other) {
  const auto expected = site_of(other);
  auto found = site_of(folder);
  EXPECT_TRUE(expected.lower_bound("replays/") != expected.lower_bound("replays0"))
      << other << " has no replays to compare";
  for (const auto& [name, bytes] : expected) {
    EXPECT_TRUE(found[name] == bytes) << folder << "/site/" << name << " is another";
    found.erase(name);
  }
  for (const auto& [name, bytes] : found) ADD_FAILURE() << folder << "/site/" << name;
}

// Expects that every link of every page below site/ leads to a file there.
inline void expect_no_dead_links(const std::string& folder) {
  int links = 0;
  for (const auto& [page, bytes] : site_of(folder)) {
    if (!page.ends_with(".html")) continue;
    for (const std::string begin : {" href=\"", " src=\""}) {
      for (std::size_t at = bytes.find(begin); at != std::string::npos;
           at = bytes.find(begin, at + 1)) {
        const std::size_t from = at + begin.size();
        const std::string link = bytes.substr(from, bytes.find_first_of("\"#?", from) - from);
        if (link.empty() || link.find(':') != std::string::npos) continue;  // here, or elsewhere
        const auto target = std::filesystem::path(folder) / "site" / page;
        EXPECT_TRUE(std::filesystem::exists(target.parent_path() / link)) << page << ": " << link;
        ++links;
      }
    }
  }
  EXPECT_GT(links, 0);
}

}  // namespace mirocup::test_support
