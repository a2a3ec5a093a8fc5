// SPDX-License-Identifier: MIT
//
// Reads any lines as the journal of a league and lets the league follow them. The harness gives
// each line its number and its hashes, since a fuzzer cannot compute them; the first byte says
// whether it does.
#include "system/digest.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"
#include "tests/support/memory_files.hpp"
#include "tournaments/league/apply.hpp"

namespace {

using namespace mirocup;

// Four teams that meet in a Swiss league: its rounds grow with the results.
league::LeagueFile league_file() {
  league::LeagueFile file;
  file.format.kind = league::FormatKind::swiss;
  file.format.rounds = 2;
  file.seed = 7;
  for (const char* name : {"a", "b", "c", "d"}) {
    file.teams.push_back({.name = name, .source = "house:idle", .over_dds = false});
  }
  return file;
}

// {"n":N,…,"prev":"…","hash":"…"} for each line, which is the text between the braces.
std::string sealed(std::string_view lines) {
  std::string journal;
  std::string before;
  for (int n = 1; !lines.empty(); ++n) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    std::string line = "{\"n\":" + std::to_string(n) + ",";
    line.append(lines.substr(0, end)).append(",\"prev\":\"").append(before).append("\"");
    line.append(",\"hash\":\"" + system::sha256(line) + "\"}");
    before = system::sha256(line);
    journal += line + "\n";
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return journal;
}

}  // namespace

MIROCUP_FUZZ_TARGET(journal) {
  if (size == 0) return;
  const std::string_view rest = mirocup::fuzz::text_of(data + 1, size - 1);
  test_support::MemoryFiles files;
  (void)files.write("journal.jsonl", (*data & 1) != 0 ? sealed(rest) : std::string(rest));
  auto journal = league::Journal::open(files, "journal.jsonl");
  if (!journal) return;
  const auto state = league::state_from_journal(league_file(), *journal);
  if (!state) return;
  (void)state->table();
}
