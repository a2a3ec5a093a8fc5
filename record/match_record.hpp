// SPDX-License-Identifier: MIT
//
// The record of one leg: a JSON file, and beside it the replay file that proves the record.
//
// Only this code knows the JSON of matches, which schema.md specifies. A record is written as a
// Json tree and read with JsonReader.
#pragma once

#include "core/match/team_parameters.hpp"
#include "core/replay/recording.hpp"
#include "record/durations.hpp"
#include "record/traffic.hpp"
#include "system/files.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mirocup::record {

using Json = nlohmann::ordered_json;

struct Replay;  // record/replay_file.hpp

// The kind of program that steered a team.
enum class TeamKind { plugin, house, dds, firasim };

struct TeamInfo {
  std::string name;
  TeamKind kind = TeamKind::plugin;
  std::optional<std::string> sha256;  // of the library; empty for a team on the network
  match::TeamParameters parameters = {};
};

// The time that a team used. `bad_commands` counts commands, not the bad values in a command.
struct BudgetReport {
  double cpu_seconds = 0.0;
  double slowest_tick_ms = 0.0;
  double bank_seconds = 0.0;  // allowed processor time; 0: not counted
  int late_ticks = 0;
  int bad_commands = 0;
};

// True if the team is a separate program that plays over the network.
inline bool is_on_network(TeamKind kind) {
  return kind == TeamKind::dds || kind == TeamKind::firasim;
}

// The traffic between the server and a team on the network.
struct NetworkReport : CommandCounts {
  int processes = 0;  // processes that played for the team in turn
  std::vector<Absence> absences;
  Durations answers;  // wall time from sending a tick's state to the answer in step
  std::optional<DatagramCounts> datagrams = std::nullopt;  // only of a team of TeamKind::firasim
};

// The lateness of a match at real time or at a multiple of real time.
struct PaceReport {
  double period = 0.0;  // wall seconds between two ticks
  Durations lateness;   // of each tick: the time of its start minus the time at which it was due
};

// The program that plays or played a match. `behaviour_hash` stands for its physics, laws and
// conditions: the first 16 digits of the SHA-256 of core/golden_hash.txt. A program with another
// hash may play another leg from the same commands.
struct Software {
  std::string version;
  std::string build;
  std::string behaviour_hash;  // JSON key "game"

  bool operator==(const Software&) const = default;
};

// The record that a leg continues. The leg has the commands of that record up to `tick`; its own
// teams played only from `tick` on.
struct PlayedOnFrom {
  std::uint32_t tick = 0;            // the first tick that the teams of this leg answered
  std::uint64_t state_hash = 0;      // hash of the whole leg of the continued record
  match::ByTeam<std::string> teams;  // the teams of the continued record

  bool operator==(const PlayedOnFrom&) const = default;
};

struct MatchRecord {
  Software software;  // the program that played the leg
  match::ByTeam<TeamInfo> teams;
  match::ByTeam<BudgetReport> budget;
  match::ByTeam<std::optional<NetworkReport>> network;  // written, but not read
  // Written, but not read; empty at full speed.
  std::optional<PaceReport> pace;
  std::string isolation;             // "T2", "T1", "none", "network"
  std::optional<PlayedOnFrom> from;  // empty: the leg was played from its start
  replay::Recording recording;
};

// Returns the version and the description of this program.
std::string software_version();
Software this_software();

// True if the record was played by a program with other physics or laws. In this case a leg that
// differs when it is played again says nothing against the record or its teams.
bool has_other_behaviour(const MatchRecord& record);

// Returns the error for a record with other behaviour whose leg, played again, differs from `tick`
// on: Errc::damaged, as for data of another version.
Error behaviour_mismatch(const std::string& path, const MatchRecord& record, std::uint32_t tick);

Json to_json(const match::Outcome& result);
Json to_json(const match::LoggedDecision& decision);

// Returns the whole record except the keys that save() adds: the replay's name and digest, and the
// record's own digest.
Json to_json(const MatchRecord& record);

// Writes the replay, then the record, so that a record never lacks its replay.
Result<void> save(system::Files& files, const std::string& path, const MatchRecord& record);

// A record without the replay that it names.
struct RecordFile {
  MatchRecord record;
  std::string replay_name;
  std::string replay_sha256;
  std::size_t ticks = 0;
};

// Reads the text of a record. Errc::damaged names `path`, the JSON pointer and the reason.
Result<RecordFile> parse_record(const std::string& text, const std::string& path);

// Returns the text of a record whose replay file has the given name and bytes.
std::string record_text(const MatchRecord& record, const std::string& replay_name,
                        std::string_view replay);

// Adds the content of a replay file to its record.
void add_replay(MatchRecord& record, Replay replay);

// Whether load() checks the digest of the record's own text, which is its last key. The digest
// finds every byte that was changed or lost. The digest does not find forgery, since a forger can
// compute digests as well; replay::verify() finds forgery. The digest of the replay is always
// checked.
enum class ChecksumPolicy { checked, ignored };

// Returns Errc::damaged, with the path, if the text of a record has changed since it was written.
Result<void> expect_whole(const std::string& text, const std::string& path);

// Reads the record and its replay, which must be in the same folder. Errors: Errc::unavailable if a
// file cannot be read, Errc::damaged for everything else.
Result<MatchRecord> load(system::Files& files, const std::string& path,
                         ChecksumPolicy policy = ChecksumPolicy::checked);

// Converts a path: "leg.json" to "leg.replay.zst".
std::string replay_path_of(const std::string& record_path);

}  // namespace mirocup::record

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 4> enum_names<record::TeamKind>{"plugin", "house",
                                                                              "dds", "firasim"};

}  // namespace mirocup
