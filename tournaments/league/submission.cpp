// SPDX-License-Identifier: MIT
#include "tournaments/league/submission.hpp"

#include "record/answer.hpp"
#include "record/json_reader.hpp"
#include "record/team_parameters_json.hpp"
#include "system/digest.hpp"
#include "system/file_lock.hpp"
#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "system/text.hpp"
#include "tournaments/league/apply.hpp"

#include <algorithm>
#include <filesystem>
#include <strings.h>
#include <utility>

namespace mirocup::league {

namespace {

// The check writes its leg for everybody, but the folder of entries is read by the host alone.
void close_to_others(const std::string& record) {
  namespace fs = std::filesystem;
  for (const fs::path& path :
       {fs::path(record), fs::path(record).replace_extension(".replay.zst")}) {
    std::error_code none;  // an entry that is refused early has no leg
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write,
                    fs::perm_options::replace | fs::perm_options::nofollow, none);
  }
}

Json verdict_in(const record::JsonReader& json) {
  (void)json.at("accepted").boolean();
  return json.json();
}

// How a program that looks at an entry has ended, and the last line of its answer.
struct Answered {
  system::Exit exit;
  Json answer;

  // True if the program has said yes or no.
  bool is_done() const {
    return exit.signal == 0 && (exit.code == exit_yes || exit.code == exit_no) &&
           answer.is_object();
  }
  std::string text(const char* key) const { return record::text_in(answer, key); }
};

// Runs a command of `mirocup` that answers. What it prints goes into the log, for people.
Result<Answered> ask(system::Files& files, std::vector<std::string> command, const Folder& folder,
                     const std::string& team, int number) {
  const std::string answer = folder.check_answer(team, number);
  command.insert(command.begin(), system::sibling_program("mirocup"));
  command.insert(command.end(), {"--answer", answer});
  MIROCUP_TRY_VOID(files.remove(answer));  // of a check that died
  system::ProcessSet processes;
  MIROCUP_TRY_VOID(processes.start(command, 0, -1, folder.check_log(team, number)));
  const auto exit = processes.wait();
  if (!exit) return fail(Errc::interrupted, "interrupted while an entry was checked");
  return record::last_answer(files, answer).map([&exit](Json last) {
    return Answered{*exit, std::move(last)};
  });
}

// Returns the error of a host on which such a program has failed.
Error failure(system::Files& files, const Answered& done, const std::string& log) {
  constexpr std::size_t enough = 500;  // bytes
  const std::string why = done.text("error");
  const auto said = files.read(log, {.max_size = system::size_limit::log});
  return {Errc::host, "the check of an entry failed: " +
                          (why.empty() ? said.value_or("").substr(0, enough) : why)};
}

// Returns the answer of `mirocup check` about a library of the team. Any exit code but yes and no
// is an error of the host.
Result<Json> check(system::Files& files, const std::string& library, const LeagueFile& rules,
                   const Folder& folder, const std::string& team, int number) {
  const std::string gate_leg = folder.gate_leg(team, number);
  std::vector<std::string> command{"check",       library,
                                   "--record",    gate_leg,
                                   "--league",    std::string(to_string(rules.league)),
                                   "--half",      std::to_string(rules.rules.half_s),
                                   "--processor", std::string(to_string(rules.processor))};
  for (const TeamConfig& known : rules.teams) {
    if (known.name != team) continue;
    const auto parameters = record::parameter_options(known.parameters, "--param");
    command.insert(command.end(), parameters.begin(), parameters.end());
  }
  auto done = ask(files, std::move(command), folder, team, number);
  close_to_others(gate_leg);
  if (!done) return tl::unexpected(done.error());
  if (!done->is_done() || !done->answer.contains("accepted"))
    return tl::unexpected(failure(files, *done, folder.check_log(team, number)));
  return std::move(done->answer);
}

Result<void> remove_check_files(system::Files& files, const Folder& folder, const std::string& team,
                                int number) {
  return files.remove(folder.check_log(team, number)).and_then([&] {
    return files.remove(folder.check_answer(team, number));
  });
}

std::string objection_to(const LeagueState& state, const std::string& team,
                         const std::string& now) {
  const bool takes_more = state.file.format.takes_entries();
  const auto known = state.find_team(team);
  if (state.is_closed) return "the league is closed";
  if (const std::string& frozen = state.frozen_from(team); !frozen.empty() && now >= frozen)
    return "entries are frozen since " + shown_time(state.file, frozen);
  if (state.is_started && !takes_more) return "entries are frozen: the league has started";
  if (known && state.teams[*known].status == TeamStatus::withdrawn) return team + " has withdrawn";
  if (known && state.file.teams[*known].is_firasim())
    return team + " plays with a program for FIRASim, not with a library";
  return "";
}

// Returns the name of a team of the league that differs from this one in capitals only; "" if there
// is none. People, and the disks of some of them, would take the two for one.
std::string twin_of(const LeagueState& state, const std::string& team) {
  for (const TeamConfig& other : state.file.teams) {
    if (other.name != team && strcasecmp(other.name.c_str(), team.c_str()) == 0) return other.name;
  }
  return "";
}

// Returns the entries of a team that the journal lets play, now or before.
std::vector<int> played_entries(const LeagueStore& store, const std::string& team) {
  std::vector<int> numbers;
  for (const Json& line : store.journal().lines()) {
    const auto event = read_event(line);
    const auto* booked = event ? std::get_if<EntryBooked>(&*event) : nullptr;
    if (booked != nullptr && booked->team == team) numbers.push_back(booked->entry);
    const auto* night = event ? std::get_if<NightBegan>(&*event) : nullptr;
    if (night == nullptr) continue;
    for (const EntryBooked& entry : night->entries) {
      if (entry.team == team) numbers.push_back(entry.entry);
    }
  }
  return numbers;
}

// Replaces the path of the host by the team's name of the file, in what the team will read.
void name_file(Json& value, const std::string& path, const std::string& name) {
  if (value.is_structured()) {
    for (Json& part : value) name_file(part, path, name);
  } else if (auto* text = value.get_ptr<std::string*>()) {
    *text = system::replaced(*text, path, name);
  }
}

// Stores the library as that entry, checks it there, and writes the verdict beside it.
Result<Json> store_and_check(system::Files& files, const Folder& folder, const LeagueFile& rules,
                             const HandIn& handed, int number, const std::string& library) {
  const std::string entry = folder.entry(handed.team, number);
  const std::string stored = folder.library(handed.team, number);
  using system::Readers;
  MIROCUP_TRY_VOID(make_entries_folder(files, folder, handed.team)
                       .and_then([&] { return files.make_folder(entry, Readers::owner); })
                       .and_then([&]() -> Result<void> {
                         if (handed.path == stored) return {};
                         return files.write(stored, library, Readers::owner);
                       }));
  auto verdict = check(files, stored, rules, folder, handed.team, number);
  if (!verdict) return verdict;
  const std::string sha256 = system::sha256(library);
  const std::string checked = record::text_in(*verdict, "sha256");
  if (!checked.empty() && checked != sha256)
    return fail(Errc::host, stored + " was changed while it was checked");
  name_file(*verdict, stored, handed.name.empty() ? handed.path : handed.name);
  MIROCUP_TRY_VOID(remove_check_files(files, folder, handed.team, number).and_then([&] {
    return add_entry(files, folder, handed.team, number, library,
                     record::json_text(*verdict, 1) + "\n");
  }));
  return verdict;
}

// Returns the line of the first error in what a compiler has said; "" if there is none.
std::string first_error_in(const std::string& said) {
  constexpr std::size_t enough = 240;  // bytes
  const std::size_t error = said.find("error: ");
  if (error == std::string::npos) return "";
  const std::size_t before = said.rfind('\n', error);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return said.substr(begin, std::min(enough, said.find('\n', error) - begin));
}

// Makes the library of an entry from its source. Returns nothing if that is done, and the verdict,
// which is then written, if it is refused.
Result<std::optional<Json>> compile(system::Files& files, const Folder& folder,
                                    const HandIn& handed, int number) {
  const std::string name = handed.name.empty() ? handed.source : handed.name;
  MIROCUP_TRY(
      const auto done,
      ask(files,
          {"compile", handed.source, "-o", folder.library(handed.team, number), "--language",
           handed.language, "--seconds", std::to_string(handed.compile_seconds)},
          folder, handed.team, number));
  const bool is_available = done.text("code") != to_string(Errc::unavailable);
  if (!done.is_done() && is_available)
    return tl::unexpected(failure(files, done, folder.check_log(handed.team, number)));
  MIROCUP_TRY_VOID(remove_check_files(files, folder, handed.team, number));
  if (done.is_done() && done.exit.code == exit_yes) return std::nullopt;
  // This computer compiles nothing, or not this source: a sentence for the team.
  std::string reason = done.text(is_available ? "reason" : "error");
  const std::string said = done.text("log");
  if (const std::string error = first_error_in(said); !error.empty()) reason = error;
  Json verdict{
      {"file", name},
      {"sha256", Json()},
      {"accepted", false},
      {"reason", "compiles: " + reason},
      {"checks", Json::array({{{"name", "compiles"}, {"passed", false}, {"text", reason}}})},
      {"log", said}};
  name_file(verdict, "/compile/source", name);  // as the compiler has named it
  MIROCUP_TRY_VOID(
      add_entry(files, folder, handed.team, number, "", record::json_text(verdict, 1) + "\n"));
  return std::optional(std::move(verdict));
}

// Returns the verdict of an entry whose check has ended.
Result<Json> read_verdict(system::Files& files, const Folder& folder, const std::string& team,
                          int number) {
  const std::string path = folder.verdict(team, number);
  MIROCUP_TRY(const auto text, files.read(path, {.max_size = system::size_limit::note}));
  return record::read_json<Json>(text, path, Errc::damaged, verdict_in);
}

// Makes an accepted entry the one that plays: a new team joins the league, and after the start the
// entry is booked.
Result<void> let_play(system::Files& files, LeagueStore& store, const HandIn& handed, int number,
                      const std::string& library) {
  const std::string& team = handed.team;
  if (!store.state().find_team(team)) {
    const std::string source = handed.is_house ? handed.name : std::string(TeamConfig::submitted);
    MIROCUP_TRY_VOID(enter_teams(files, store, {team}, source));
  }
  if (!store.state().is_started) return {};
  if (store.state().file.format.kind == FormatKind::nightly) return {};  // the next night takes it
  // A later one may have been quicker, or this one was booked by a process that died.
  if (store.state().teams[*store.state().find_team(team)].entry >= number) return {};
  // A team that has pinned a version plays on with that.
  MIROCUP_TRY(const auto playing, playing_entry(files, store.folder(), team));
  if (playing != number) return {};
  return store.write(EntryBooked{.team = team, .entry = number, .sha256 = system::sha256(library)});
}

// A file as it was found, before any lock is taken.
struct Found {
  std::string why_not = {};  // a sentence; "": it was read
  std::string library = {};
};

// Errors: the file is not there, or the system does not let it be read.
Result<Found> examine(const std::string& path) {
  const auto file = system::open_file(path, {.max_size = system::size_limit::entry});
  if (!file && file.error().code == Errc::input) return Found{.why_not = file.error().what};
  if (!file) return tl::unexpected(file.error());
  MIROCUP_TRY(auto library, system::read_file(*file));
  return Found{.library = std::move(library)};
}

// One hand-in, after its file was read. receive() and conclude() run while no other process does
// the same; between them lies the check, which takes long.
class Desk {
 public:
  Desk(system::Files& files, LeagueStore& store, const HandIn& handed, const Quota& quota)
      : files_(files), store_(store), handed_(handed), quota_(quota), number_(handed.entry) {}

  // Numbers the hand-in and notes the try. Returns the answer if there is nothing to check.
  Result<std::optional<Submission>> receive(const Found& found) {
    MIROCUP_TRY(known_, read_hand_ins(files_, folder(), team()));
    if (has_verdict()) return std::nullopt;
    const std::string why = why_not_now(store_.state(), team(), utc_text(handed_.at));
    if (!why.empty()) return not_taken(why);
    if (!is_noted() && tries_in_last_hour(known_, handed_.at) >= quota_.tries_per_hour) {
      return not_taken("it has had " + std::to_string(quota_.tries_per_hour) +
                       " tries in the last hour; hand it in later");
    }
    if (number_ == 0 && found.why_not.empty()) {
      MIROCUP_TRY(const auto next, next_entry(files_, folder(), team()));
      number_ = next;
    }
    note_try();
    if (!found.why_not.empty()) return refuse(found.why_not);
    // Written before the check, so that a library that stops the check is a try, too.
    MIROCUP_TRY_VOID(write_hand_ins(files_, folder(), team(), known_).and_then([&] {
      return files_.make_folder(folder().entry(team(), number_), system::Readers::owner);
    }));
    return std::nullopt;
  }

  Result<Json> check(const Found& found) {
    const std::string stored = folder().library(team(), number_);
    if (has_verdict()) {
      // A refused version keeps no library.
      MIROCUP_TRY(auto library,
                  files_.read_if_there(stored, {.max_size = system::size_limit::entry}));
      library_ = std::move(library).value_or("");
      return read_verdict(files_, folder(), team(), number_);
    }
    if (handed_.source.empty()) {
      library_ = found.library;
      return check_library();
    }
    MIROCUP_TRY(auto refused, compile(files_, folder(), handed_, number_));
    if (refused) return std::move(*refused);
    MIROCUP_TRY(library_, files_.read(stored, {.max_size = system::size_limit::entry}));
    return check_library();
  }

  // Books the verdict. The store has been opened again since receive().
  Result<Submission> conclude(Json verdict) {
    MIROCUP_TRY(known_, read_hand_ins(files_, folder(), team()));
    MIROCUP_TRY(const auto playing, playing_entry(files_, folder(), team()));
    // It may have been forgotten since.
    if (find_try(known_, number_) == nullptr) note_try();
    Submission result;
    result.entry = number_;
    result.verdict = std::move(verdict);
    result.is_accepted = result.verdict["accepted"] == true;
    result.plays = playing;
    result.message = team() + ": entry " + std::to_string(result.entry) +
                     (result.is_accepted ? " was accepted" : " was not accepted");
    if (!result.is_accepted) {
      result.message += ": " + record::text_in(result.verdict, "reason");
      if (playing > 0) result.message += "; entry " + std::to_string(playing) + " plays on";
    } else if (known_.pinned > 0 && playing == known_.pinned) {
      result.message += "; entry " + std::to_string(known_.pinned) + ", which is pinned, plays on";
    }
    Try& noted = *find_try(known_, number_);
    noted.is_accepted = result.is_accepted;
    noted.message = result.message;
    MIROCUP_TRY_VOID(write_hand_ins(files_, folder(), team(), known_)
                         .and_then([&]() -> Result<void> {
                           if (!result.is_accepted) return {};
                           return let_play(files_, store_, handed_, result.entry, library_);
                         })
                         .and_then([&] {
                           return prune_versions(files_, folder(), team(),
                                                 played_entries(store_, team()), quota_);
                         }));
    return result;
  }

 private:
  Result<Json> check_library() {
    auto verdict =
        store_and_check(files_, folder(), store_.state().file, handed_, number_, library_);
    // The folder of a hand-in that waits keeps its library for the next try.
    if (!verdict && handed_.entry == 0) (void)files_.remove(folder().entry(team(), number_));
    return verdict;
  }

  Result<Submission> refuse(const std::string& why) {
    const Submission result = not_taken(why);
    known_.tries.back().message = result.message;
    // A name under which nobody has handed in a library gets no folder.
    MIROCUP_TRY(const auto entries, entries_of(files_, folder(), team()));
    if (entries.empty() && !store_.state().find_team(team())) return result;
    MIROCUP_TRY_VOID(write_hand_ins(files_, folder(), team(), known_));
    return result;
  }

  void note_try() {
    if (is_noted()) return;
    add_try(known_, {.at = handed_.at,
                     .entry = number_,
                     .is_accepted = false,
                     .message = team() + ": the check has not come to its end"});
  }

  // True if a process that died has noted the try already.
  bool is_noted() { return handed_.entry > 0 && find_try(known_, handed_.entry) != nullptr; }

  // The answer to a file that does not count as a try.
  Submission not_taken(const std::string& why) const {
    Submission result;
    result.message = handed_.team + ": not taken: " + why;
    return result;
  }

  const std::string& team() const { return handed_.team; }
  const Folder& folder() const { return store_.folder(); }
  bool has_verdict() const {
    return number_ > 0 && files_.exists(folder().entry_file(team(), number_));
  }

  system::Files& files_;
  LeagueStore& store_;
  const HandIn& handed_;
  const Quota& quota_;
  int number_;           // of the entry; 0: none yet
  std::string library_;  // once it is there
  HandIns known_;
};

}  // namespace

std::string why_not_now(const LeagueState& state, const std::string& team, const std::string& now) {
  const std::string why = objection_to(state, team, now);
  return !why.empty() || state.find_team(team) ? why : why_not_join(state, team);
}

std::string why_not_join(const LeagueState& state, const std::string& team) {
  if (const std::string twin = twin_of(state, team); !twin.empty())
    return "the league has a team " + twin + ", whose name is too similar; choose another name";
  if (!state.is_started) return "";
  const auto valid = validate(state, TeamJoined{.team = team, .source = "submitted"});
  return valid ? "" : valid.error().what;
}

Result<void> enter_teams(system::Files& files, LeagueStore& store,
                         const std::vector<std::string>& teams, const std::string& source) {
  if (store.state().is_started) {
    for (const std::string& team : teams) {
      MIROCUP_TRY_VOID(store.write(TeamJoined{.team = team, .source = source}));
    }
    return {};
  }
  if (teams.empty()) return {};
  LeagueFile file = store.state().file;
  for (const std::string& team : teams) file.teams.push_back({.name = team, .source = source});
  return files.write(store.folder().config(), print_league_file(file));
}

Result<void> leave_before_start(system::Files& files, LeagueStore& store, const std::string& team) {
  LeagueFile file = store.state().file;
  std::erase_if(file.teams, [&team](const TeamConfig& one) { return one.name == team; });
  return files.write(store.folder().config(), print_league_file(file));
}

Result<std::string> pin_entry(system::Files& files, const Folder& folder, const std::string& team,
                              int number, std::int64_t now,
                              const std::function<Result<void>()>& note) {
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.submitting()));
  MIROCUP_TRY(auto store, LeagueStore::open(files, folder));
  if (const std::string why = why_not_now(store.state(), team, utc_text(now)); !why.empty())
    return why;
  MIROCUP_TRY(const auto is_accepted, is_accepted_entry(files, folder, team, number));
  const bool is_kept = number == 0 || (files.exists(folder.entry_file(team, number)) &&
                                       files.exists(folder.library(team, number)) && is_accepted);
  if (!is_kept) {
    const bool is_there = files.exists(folder.entry_file(team, number));
    return (is_there && !is_accepted
                ? "entry " + std::to_string(number) + " of " + team + " was not accepted"
                : team + " has no entry " + std::to_string(number) + " that could play");
  }
  MIROCUP_TRY(auto known, read_hand_ins(files, folder, team));
  known.pinned = number;
  MIROCUP_TRY(const auto playing,
              number > 0 ? Result<int>(number) : last_accepted_entry(files, folder, team));
  const LeagueState& state = store.state();
  std::string library = {};
  // The next night of a nightly league takes the entry.
  const bool plays_now = state.is_started && playing > 0 &&
                         state.file.format.kind != FormatKind::nightly &&
                         state.teams[*state.find_team(team)].entry != playing;
  if (plays_now) {
    MIROCUP_TRY(library,
                files.read(folder.library(team, playing), {.max_size = system::size_limit::entry}));
  }
  MIROCUP_TRY_VOID(note());
  if (plays_now) {
    MIROCUP_TRY_VOID(store.write(
        EntryBooked{.team = team, .entry = playing, .sha256 = system::sha256(library)}));
  }
  MIROCUP_TRY_VOID(write_hand_ins(files, folder, team, known));
  return "";
}

Result<Submission> submit(system::Files& files, const Folder& folder, const HandIn& handed,
                          const Quota& quota) {
  if (!is_good_name(handed.team)) {
    return fail(Errc::input, "\"" + handed.team +
                                 "\" is no name: letters, digits, '-', '_' and '.', at most 40");
  }
  MIROCUP_TRY(const auto found, examine(handed.source.empty() ? handed.path : handed.source));
  // Hand-ins that waited have a queue of their own, which says how many checks run at once.
  std::optional<system::FileLock> alone;
  if (handed.entry == 0) {
    MIROCUP_TRY(alone, system::FileLock::acquire(folder.checking()));
  }
  auto lock = std::optional(system::FileLock::acquire(folder.submitting()));
  if (!*lock) return tl::unexpected(lock->error());
  MIROCUP_TRY(auto store, LeagueStore::open_unplanned(files, folder));
  Desk desk(files, store, handed, quota);
  MIROCUP_TRY(auto answer, desk.receive(found));
  if (answer) return std::move(*answer);
  lock.reset();

  MIROCUP_TRY(auto verdict, desk.check(found));

  lock = system::FileLock::acquire(folder.submitting());
  if (!*lock) return tl::unexpected(lock->error());
  // Another team may have joined in the meantime.
  MIROCUP_TRY(store, LeagueStore::open_unplanned(files, folder));
  return desk.conclude(std::move(verdict));
}

}  // namespace mirocup::league
