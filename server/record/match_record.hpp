// SPDX-License-Identifier: MIT
//
// The record of one leg: a JSON file for people and leagues, and beside it the replay that proves
// it.
//
// This is the only code that knows the JSON of matches; schema.md is its specification. Exceptions
// of the JSON library end here.
#pragma once

#include "core/replay/recording.hpp"
#include "server/pace/absence.hpp"
#include "server/pace/durations.hpp"
#include "server/system/files.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mirocup::record {

using Json = nlohmann::ordered_json;

// What steered a team.
enum class TeamKind { plugin, house, dds };

struct TeamInfo {
  std::string name;
  TeamKind kind = TeamKind::plugin;
  std::optional<std::string> sha256;  // of the library; a DDS team has none
};

// What a team used of its time. A count of bad commands counts commands, not values.
struct BudgetReport {
  double cpu_seconds = 0.0;
  double slowest_tick_ms = 0.0;
  double bank_seconds = 0.0;  // what it had; 0: nobody counted
  int late_ticks = 0;
  int bad_commands = 0;
};

// What happened between the server and a team on the network. Commands are counted by what became
// of them: only those in step were driven.
struct NetworkReport {
  std::uint64_t in_step = 0;
  std::uint64_t late = 0;       // to a tick that was over
  std::uint64_t duplicate = 0;  // to the last answered tick once more
  std::uint64_t ahead = 0;      // to a tick that there had not been
  std::uint64_t foreign = 0;    // from another process than the team's
  int processes = 0;            // that played for the team, one after the other
  std::vector<pace::Absence> absences;
  pace::Durations answers;  // from a tick's state to the answer in step, wall time
};

// How simulated time kept up with wall time.
struct PaceReport {
  double period = 0.0;       // wall seconds between two ticks
  pace::Durations lateness;  // by which ticks began after they were due
};

// What plays or played a match. `game` stands for the physics and the laws: the hash of the golden
// leg (tests/build/compilers). Programs of another game may get another leg from the same commands.
struct Software {
  std::string version;
  std::string build;
  std::string behaviour_hash;  // JSON key "game"; "": a record from before it was written down

  bool operator==(const Software&) const = default;
};

struct MatchRecord {
  Software software;  // that played it
  match::ByTeam<TeamInfo> teams;
  match::ByTeam<BudgetReport> budget;
  match::ByTeam<std::optional<NetworkReport>> network;  // written, not read
  std::optional<PaceReport> pace;                       // the same; of a match in real time
  std::string isolation;                                // "T2", "T1", "none" (--trusted), "network"
  replay::Recording recording;
};

// Of this program.
std::string software_version();
Software this_software();

// A record that this program should not reproduce, for it was played by another game: what differs
// then says nothing about the record or its teams.
bool has_other_behaviour(const MatchRecord& record);

// What to say if it indeed differs from that tick on. Errc::damaged: "of another version".
Error behaviour_mismatch(const std::string& path, const MatchRecord& record, std::uint32_t tick);

Json to_json(const match::Outcome& result);
Json to_json(const match::LoggedDecision& decision);

// Everything but the replay's name and digest and the record's own, which save() adds.
Json to_json(const MatchRecord& record);

// Writes the replay, then the record: if the record is there, both are.
Result<void> save(system::Files& files, const std::string& path, const MatchRecord& record);

// A record ends with the digest of its own text, and holds the digest of its replay: a byte that was
// changed or lost is found. Somebody who wants to forge a record can compute digests, too; verifying
// it finds that.
enum class ChecksumPolicy { checked, ignored };

// Reads both. Errors: Errc::unavailable if a file is not there, Errc::damaged for everything else.
Result<MatchRecord> load(system::Files& files, const std::string& path,
                         ChecksumPolicy policy = ChecksumPolicy::checked);

// "leg.json" -> "leg.replay.zst"
std::string replay_path_of(const std::string& record_path);

}  // namespace mirocup::record

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<record::TeamKind>{"plugin", "house",
                                                                              "dds"};

}  // namespace mirocup
