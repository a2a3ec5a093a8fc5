// SPDX-License-Identifier: MIT
#include "tournaments/play/program.hpp"

#include "record/answer.hpp"
#include "record/json_fields.hpp"
#include "record/kept_module.hpp"
#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "tournaments/league/gaps.hpp"
#include "tournaments/play/scratch_folder.hpp"

#include <map>

namespace mirocup::league {

namespace {

std::string in_words(const std::string& version, const std::string& game) {
  return "mirocup " + version + (game.empty() ? "" : " (game " + game + ")");
}

// Returns the minor version, "0.1" of "0.1.7". Its releases play the same legs: docs/interfaces.md.
std::string series_of(const std::string& version) {
  return version.substr(0, version.rfind('.'));
}

// What is needed of a record before it is verified.
struct RecordedLeg {
  std::string path;  // inside the league
  std::string state_hash;
  double half_s = 0.0;
};

Result<RecordedLeg> read_leg(system::Files& files, const Folder& folder, const std::string& path) {
  const std::string file = folder.path + "/" + path;
  MIROCUP_TRY(const auto text, files.read(file, {.max_size = system::size_limit::record}));
  MIROCUP_TRY_VOID(record::expect_whole(text, file));
  return record::read_json<RecordedLeg>(
      text, file, Errc::damaged, [&path](const record::JsonReader& json) {
        return RecordedLeg{.path = path,
                           .state_hash = json.at("state_hash").text(),
                           .half_s = json.at("rules").at("half_s").number()};
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

}  // namespace

Result<void> expect_program(const LeagueStore& store, const record::Software& program) {
  const LeagueState& state = store.state();
  const record::Software& before = state.program;
  if (!state.is_started) return {};
  const bool is_fix = series_of(before.version) == series_of(program.version);
  if (is_fix && before.behaviour_hash == program.behaviour_hash) return {};
  const std::string played = in_words(before.version, before.behaviour_hash);
  return fail(Errc::input, store.folder().path + " is played with " + played +
                               "; this program is " +
                               in_words(program.version, program.behaviour_hash) +
                               ", which may play other legs from the same seeds. Continue with " +
                               played + (is_fix ? "" : ", or a fix of it"));
}

namespace {

// Returns a sentence of the answer of `mirocup verify` that a record is not reproduced.
std::string problem_in(const Json& answer) {
  if (answer.contains("tick"))
    return "differs from tick " + std::to_string(record::value_in(answer, "tick", 0)) +
           " on: " + record::text_in(answer, "what");
  const std::string error = record::text_in(answer, "error");
  return error.empty() ? "could not be verified" : error;
}

// Verifies the records at `paths` inside the league, and adds those that can be read to `legs`.
Result<VerifiedRecords> verify(system::Files& files, const Folder& folder,
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
  const std::string server = system::sibling_program("mirocup");
  system::ProcessSet processes;
  if (jobs <= 0) jobs = static_cast<int>(system::processors().size());
  const auto output_of = [&output](int tag) { return output.path() + "/" + std::to_string(tag); };
  for (std::size_t next = 0; next < waiting.size() || processes.running() > 0;) {
    if (next < waiting.size() && static_cast<int>(processes.running()) < jobs) {
      const RecordedLeg& leg = *waiting[next];
      const int tag = static_cast<int>(next++);
      MIROCUP_TRY_VOID(processes.start(
          {server, "verify", folder.path + "/" + leg.path, "--answer", output_of(tag)}, tag, -1,
          "/dev/null",
          {.seconds = record::limit_of_repeating(leg.half_s), .bytes = system::size_limit::log}));
      continue;
    }
    const auto exit = processes.wait();
    if (!exit) return fail(Errc::interrupted, "interrupted");
    if (exit->signal == 0 && exit->code == exit_yes) {
      ++done.reproduced;
    } else {
      const Json answer = record::last_answer(files, output_of(exit->tag)).value_or(Json());
      const RecordedLeg& leg = *waiting[static_cast<std::size_t>(exit->tag)];
      done.problems.push_back(
          {leg.path, problem_in(answer), exit->signal != 0 ? exit_code(Errc::host) : exit->code});
    }
    (void)files.remove(output_of(exit->tag));
  }
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
  MIROCUP_TRY(auto done, verify(files, store.folder(), paths, jobs, legs));
  compare_with_journal(store, legs, done);
  MIROCUP_TRY(const auto found, gaps(files, store, is_being_played(store.folder())));
  if (!found.lost.empty()) done.problems.push_back({"journal.jsonl", found.lost, exit_no});
  for (const std::string& path : found.not_booked)
    done.problems.push_back({path, "the journal has no line of it", exit_no});
  return done;
}

Result<VerifiedRecords> verify_records(system::Files& files, const Folder& folder,
                                       const std::vector<std::string>& paths, int jobs) {
  std::map<std::string, RecordedLeg> legs;
  return verify(files, folder, paths, jobs, legs);
}

}  // namespace mirocup::league
