// SPDX-License-Identifier: MIT
#include "record/own_texts.hpp"

#include "record/thoughts_file.hpp"

#include <algorithm>

namespace mirocup::record {

bool has_thoughts(system::Files& files, const std::string& record_path, const Whose& whose) {
  return std::any_of(both_teams.begin(), both_teams.end(), [&](Team team) {
    return whose[index_of(team)] && files.exists(thoughts_path(record_path, team));
  });
}

Result<OwnTexts> read_own_texts(system::Files& files, const std::string& record_path,
                                const Whose& whose, system::Links links) {
  OwnTexts own;
  for (const Team team : both_teams) {
    if (!whose[index_of(team)]) continue;
    if (const std::string path = thoughts_path(record_path, team); files.exists(path)) {
      MIROCUP_TRY(const auto bytes,
                  files.read(path, {.max_size = system::size_limit::replay, .links = links}));
      MIROCUP_TRY(own.thoughts[index_of(team)], unpacked_thoughts(bytes, path));
    }
    const std::string path = record_path + "." + std::string(to_string(team)) + ".log";
    if (!files.exists(path)) continue;
    MIROCUP_TRY(own.logs[index_of(team)],
                files.read(path, {.max_size = system::size_limit::log, .links = links}));
  }
  return own;
}

}  // namespace mirocup::record
