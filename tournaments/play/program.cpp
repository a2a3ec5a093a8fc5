// SPDX-License-Identifier: MIT
#include "tournaments/play/program.hpp"

#include "record/json_reader.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/process_set.hpp"
#include "system/text.hpp"
#include "system/trusted_program.hpp"
#include "tournaments/league/gaps.hpp"
#include "tournaments/league/kept_program.hpp"
#include "tournaments/play/scratch_folder.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>

namespace mirocup::league {

namespace {

std::string in_words(const std::string& version, const std::string& game) {
  return "mirocup " + version + (game.empty() ? "" : " (game " + game + ")");
}

// What is needed of a record before it is verified.
struct RecordedLeg {
  std::string path;  // inside the league
  std::string version;
  std::string game;
  std::string state_hash;
};

Result<RecordedLeg> read_leg(system::Files& files, const Folder& folder, const std::string& path) {
  const std::string file = folder.path + "/" + path;
  MIROCUP_TRY(const auto text, files.read(file, {.max_size = system::size_limit::record}));
  MIROCUP_TRY_VOID(record::expect_whole(text, file));
  return record::read_json<RecordedLeg>(
      text, file, Errc::damaged, [&path](const record::JsonReader& json) {
        const record::JsonReader software = json.at("software");
        RecordedLeg leg{.path = path,
                        .version = software.at("version").text(),
                        .game = "",
                        .state_hash = json.at("state_hash").text()};
        software.read_if_present("game", leg.game);
        return leg;
      });
}

// Notes what the journal says of records: those that it names must be there, as it means them.
void compare_with_journal(const LeagueStore& store, const std::map<std::string, RecordedLeg>& legs,
                          VerifiedRecords& done) {
  for (const Json& line : store.journal().lines()) {
    const auto event = read_event(line);
    const auto* played = event ? std::get_if<LegPlayed>(&*event) : nullptr;
    if (played == nullptr) continue;
    const auto found = legs.find(played->record);
    if (found == legs.end()) {
      done.problems.push_back(
          {played->record, "is missing or cannot be read, although the journal names it", 4});
    } else if (found->second.state_hash != played->state_hash) {
      done.problems.push_back(
          {played->record, "is the record of another leg than the journal says", 4});
    }
  }
}

// Returns the behaviour of the program that played the last leg; "" if no record says so.
Result<std::string> game_of_last_leg(system::Files& files, const LeagueStore& store) {
  const std::vector<Json>& lines = store.journal().lines();
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    const auto event = read_event(*line);
    const auto* played = event ? std::get_if<LegPlayed>(&*event) : nullptr;
    if (played != nullptr) return game_of_record(files, store.folder(), played->record);
  }
  return "";
}

Result<std::string> bytes_of_sibling(system::Files& files, const std::string& name) {
  return files.read_named(system::sibling_program(name), max_program);
}

Result<void> write_program(system::Files& files, const std::string& path,
                           const std::string& bytes) {
  namespace fs = std::filesystem;
  if (auto written = files.write(path, bytes); !written) return written;
  std::error_code failed;
  fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                  fs::perm_options::add, failed);
  if (failed) return fail(Errc::unavailable, path + ": " + failed.message());
  return {};
}

// Keeps the module for browsers, if this program has one. Pages of its legs are proved with it,
// also after an upgrade. Without it, they are made without a proof.
Result<void> keep_module(system::Files& files, const Folder& folder, const std::string& game) {
  for (const char* file : kept_module_files) {
    const auto bytes = files.read_named(system::browser_folder() + "/" + file, max_program);
    if (!bytes || !trust_program(*bytes)) continue;
    const std::string kept = kept_module(folder, game, file);
    const auto there = files.read(kept, {.max_size = max_program});
    if (there && is_trusted_program(*there).value_or(true)) continue;
    MIROCUP_TRY_VOID(files.write(kept, *bytes));
  }
  return {};
}

}  // namespace

Result<void> expect_program(system::Files& files, LeagueStore& store,
                            const record::Software& program, bool accepts_other) {
  const LeagueState& state = store.state();
  ProgramChosen before = state.program;
  if (!state.is_started) return {};
  // Journals of earlier versions name the version only.
  if (before.game.empty()) {
    MIROCUP_TRY(const auto game, game_of_last_leg(files, store));
    before.game = game;
  }
  const bool is_same = before.version == program.version &&
                       (before.game.empty() || before.game == program.behaviour_hash);
  if (is_same) return {};
  if (!accepts_other) {
    return fail(Errc::input,
                store.folder().path + " is played with " + in_words(before.version, before.game) +
                    "; this program is " + in_words(program.version, program.behaviour_hash) +
                    ", which may play other legs from the same seeds. Continue with the program "
                    "that played before, or give --other-program to continue with this one");
  }
  return store.write(ProgramChosen{
      .version = program.version, .build = program.build, .game = program.behaviour_hash});
}

Result<void> keep_program(system::Files& files, const Folder& folder,
                          const record::Software& program) {
  MIROCUP_TRY(const auto server, bytes_of_sibling(files, "mirocup"));
  // Without the list, records are verified by other programs all the same.
  if (const auto listed = trust_program(server); !listed)
    std::cerr << "mirocup: the copy of this program in " << system::printable(folder.path)
              << " will not be run after an upgrade: " << system::printable(listed.error().what)
              << '\n';
  const std::string kept = kept_program(folder, program.behaviour_hash);
  // In a folder from elsewhere there may be another program in its place.
  if (const auto there = files.read(kept, {.max_size = max_program});
      there && is_trusted_program(*there).value_or(true))
    return keep_module(files, folder, program.behaviour_hash);
  MIROCUP_TRY(const auto host, bytes_of_sibling(files, "mirocup-plugin-host"));
  const Json about{{"version", program.version},
                   {"build", program.build},
                   {"game", program.behaviour_hash},
                   {"sha256", system::sha256(server)}};
  const std::string home = std::filesystem::path(kept).parent_path();
  return files.make_folder(home)
      .and_then([&] { return write_program(files, home + "/mirocup-plugin-host", host); })
      .and_then(
          [&] { return files.write(home + "/program.json", record::json_text(about, 1) + "\n"); })
      .and_then([&] { return write_program(files, kept, server); })
      .and_then([&] { return keep_module(files, folder, program.behaviour_hash); });
}

namespace {

// Verifies the records at `paths` inside the league, and adds those that can be read to `legs`.
// `half_s`: of a half of the league, s, from which the limit of a verification follows.
Result<VerifiedRecords> verify(system::Files& files, const Folder& folder, double half_s,
                               const std::vector<std::string>& paths, int jobs,
                               std::map<std::string, RecordedLeg>& legs) {
  VerifiedRecords done;
  std::vector<const RecordedLeg*> waiting;
  for (const std::string& path : paths) {
    ++done.records;
    auto leg = read_leg(files, folder, path);
    if (leg) {
      waiting.push_back(&legs.emplace(path, std::move(*leg)).first->second);
    } else {
      done.problems.push_back({path, leg.error().what, exit_code(leg.error().code)});
    }
  }

  const ScratchFolder output("mirocup-verify");  // of the children
  if (output.path().empty()) return fail(Errc::unavailable, "no temporary folder can be made");
  MatchServers servers(files, folder);
  system::ProcessSet processes;
  if (jobs <= 0) jobs = static_cast<int>(system::processors().size());
  std::map<std::string, int> by_program;
  const auto output_of = [&output](int tag) { return output.path() + "/" + std::to_string(tag); };
  for (std::size_t next = 0; next < waiting.size() || processes.running() > 0;) {
    if (next < waiting.size() && static_cast<int>(processes.running()) < jobs) {
      const RecordedLeg& leg = *waiting[next];
      const MatchServer& server = servers.of_game(leg.game);
      ++by_program[in_words(leg.version, leg.game) + ", verified by " + server.path];
      const int tag = static_cast<int>(next++);
      std::vector<std::string> words = server.words;
      words.insert(words.end(), {"verify", folder.path + "/" + leg.path});
      MIROCUP_TRY_VOID(processes.start(
          words, tag, -1, output_of(tag),
          {.seconds = system::limit_of_repeating(half_s), .bytes = system::size_limit::log}));
      continue;
    }
    const auto exit = processes.wait();
    if (!exit) return fail(Errc::interrupted, "interrupted");
    if (exit->signal == 0 && exit->code == exit_yes) {
      ++done.reproduced;
    } else {
      const std::string said =
          files.read(output_of(exit->tag), {.max_size = system::size_limit::log}).value_or("");
      const RecordedLeg& leg = *waiting[static_cast<std::size_t>(exit->tag)];
      const std::string& why = servers.of_game(leg.game).why_not_kept;
      done.problems.push_back({leg.path, system::last_line(said) + (why.empty() ? "" : "; ") + why,
                               exit->signal != 0 ? exit_code(Errc::host) : exit->code});
    }
    (void)files.remove(output_of(exit->tag));
  }
  for (const auto& [program, count] : by_program)
    done.programs.push_back(std::to_string(count) + " records of " + program);
  return done;
}

}  // namespace

Result<VerifiedRecords> verify_records(system::Files& files, const LeagueStore& store, int jobs) {
  MIROCUP_TRY(const auto names, files.names_in(store.folder().path + "/records"));
  std::vector<std::string> paths;
  for (const std::string& name : names) {
    if (name.ends_with(".json") && !name.starts_with('.')) paths.push_back("records/" + name);
  }
  std::map<std::string, RecordedLeg> legs;
  auto done = verify(files, store.folder(), store.state().file.rules.half_s, paths, jobs, legs);
  if (!done) return done;
  compare_with_journal(store, legs, *done);
  MIROCUP_TRY(const auto found, gaps(files, store, is_being_played(store.folder())));
  if (!found.lost.empty()) done->problems.push_back({"journal.jsonl", found.lost, exit_no});
  for (const auto& unknown : {found.unknown, found.not_booked}) {
    for (const std::string& path : unknown)
      done->problems.push_back({path, "the journal has no line of it", exit_no});
  }
  return done;
}

Result<VerifiedRecords> verify_records(system::Files& files, const LeagueStore& store,
                                       const std::vector<std::string>& paths, int jobs) {
  std::map<std::string, RecordedLeg> legs;
  return verify(files, store.folder(), store.state().file.rules.half_s, paths, jobs, legs);
}

}  // namespace mirocup::league
