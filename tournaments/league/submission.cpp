// SPDX-License-Identifier: MIT
#include "tournaments/league/submission.hpp"

#include "record/answer.hpp"
#include "record/json_reader.hpp"
#include "record/team_parameters_json.hpp"
#include "system/digest.hpp"
#include "system/file_lock.hpp"
#include "system/locations.hpp"
#include "system/number_of.hpp"
#include "system/process_set.hpp"
#include "system/text.hpp"
#include "tournaments/league/apply.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
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
struct Told {
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
Result<Told> ask(system::Files& files, std::vector<std::string> command, const Folder& folder,
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
    return Told{*exit, std::move(last)};
  });
}

// Returns the error of a host on which such a program has failed.
Error failure(system::Files& files, const Told& done, const std::string& log) {
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

// Returns why the league takes no entry of this team, whenever it comes; "" if it takes one.
std::string objection_to(const LeagueState& state, const std::string& team) {
  const auto known = state.find_team(team);
  if (state.is_closed) return "the league is closed";
  if (state.is_started && !state.file.format.is_open_ended())
    return "entries are frozen: the league has started";
  if (!known) return why_not_join(state, team);
  if (state.teams[*known].status == TeamStatus::withdrawn) return team + " has withdrawn";
  if (state.file.teams[*known].is_firasim())
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
std::set<int> played_entries(const LeagueStore& store, const std::string& team) {
  std::set<int> numbers;
  const auto add = [&](const EntryBooked& booked) {
    if (booked.team == team) numbers.insert(booked.entry);
  };
  for (const Json& line : store.journal().lines()) {
    const std::string kind = record::text_in(line, "kind");
    if (kind != EntryBooked::kind && kind != NightBegan::kind) continue;
    const auto event = read_event(line);
    if (!event) continue;
    if (const auto* booked = std::get_if<EntryBooked>(&*event)) add(*booked);
    if (const auto* night = std::get_if<NightBegan>(&*event))
      for (const EntryBooked& booked : night->entries) add(booked);
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

// Returns the line of the first error in what a compiler has said; "" if there is none.
std::string first_error_in(const std::string& said) {
  constexpr std::size_t enough = 240;  // bytes
  const std::size_t error = said.find("error: ");
  if (error == std::string::npos) return "";
  const std::size_t before = said.rfind('\n', error);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return said.substr(begin, std::min(enough, said.find('\n', error) - begin));
}

// Makes the library of an entry from its source. Returns nothing if that is done, and the verdict
// if the source is refused.
Result<std::optional<Json>> compile(system::Files& files, const Folder& folder,
                                    const HandedIn& handed, int seconds) {
  const std::string& team = handed.team;
  const int number = handed.entry;
  MIROCUP_TRY(
      const auto done,
      ask(files,
          {"compile", folder.source(team, number), "-o", folder.library(team, number), "--language",
           language_of(source_kind_of(handed.file)), "--seconds", std::to_string(seconds)},
          folder, team, number));
  const bool is_available = done.text("code") != to_string(Errc::unavailable);
  if (!done.is_done() && is_available)
    return tl::unexpected(failure(files, done, folder.check_log(team, number)));
  if (done.is_done() && done.exit.code == exit_yes) return std::nullopt;
  MIROCUP_TRY_VOID(files.write(folder.library(team, number), "", system::Readers::owner));
  // This computer compiles nothing, or not this source: a sentence for the team.
  std::string reason = done.text(is_available ? "reason" : "error");
  const std::string said = done.text("log");
  if (const std::string error = first_error_in(said); !error.empty()) reason = error;
  Json verdict{
      {"file", handed.file},
      {"sha256", Json()},
      {"accepted", false},
      {"reason", "compiles: " + reason},
      {"checks", Json::array({{{"name", "compiles"}, {"passed", false}, {"text", reason}}})},
      {"log", said}};
  name_file(verdict, "/compile/source", handed.file);  // as the compiler has named it
  return std::optional(std::move(verdict));
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

// Does what follows from the answer to an entry.
Result<void> follow_answer(system::Files& files, LeagueStore& store, const HandedIn& handed) {
  const Folder& folder = store.folder();
  const std::string& team = handed.team;
  if (!handed.is_kept()) return files.remove(folder.entry(team, handed.entry));
  if (handed.is_late || files.exists(folder.entry_file(team, handed.entry))) return {};
  const bool may_join = handed.may_play() && !handed.file.empty() &&
                        !store.state().find_team(team) && objection_to(store.state(), team).empty();
  if (may_join) {
    const bool is_house = !handed.is_network && handed.file.starts_with(TeamConfig::house_prefix);
    MIROCUP_TRY_VOID(enter_teams(files, store, {team},
                                 is_house ? handed.file : std::string(TeamConfig::submitted)));
  }
  return write_entry_file(files, folder, team, handed.entry, handed.library);
}

// Returns the answer to a checked hand-in.
Submission answer_to(const HandedIn& handed, const HandIns& hand_ins, Json verdict) {
  const std::string& team = handed.team;
  const int playing = hand_ins.playing(team);
  Submission done{.is_accepted = verdict["accepted"] == true,
                  .entry = handed.entry,
                  .plays = playing,
                  .message = team + ": entry " + std::to_string(handed.entry)};
  if (!done.is_accepted) {
    done.message += " was not accepted: " + record::text_in(verdict, "reason");
    if (playing > 0) done.message += "; entry " + std::to_string(playing) + " plays on";
  } else {
    done.message += " was accepted";
    if (handed.is_late) done.message += ", but came after the deadline: the host decides about it";
    if (playing > 0 && playing == hand_ins.pinned(team))
      done.message += "; entry " + std::to_string(playing) + ", which is pinned, plays on";
  }
  done.verdict = std::move(verdict);
  return done;
}

// Returns the answer to a file that does not count as a try, or not as an entry.
Submission not_taken(const std::string& team, const std::string& why) {
  return {.message = team + ": not taken: " + why};
}

// Stores a file of the host, numbers it, and writes that it was handed in. Returns the answer if
// the file is not taken.
Result<std::optional<Submission>> receive(system::Files& files, const Folder& folder, Book& book,
                                          const Found& found, const Quota& quota,
                                          HandedIn& handed) {
  const std::string& team = handed.team;
  MIROCUP_TRY(const auto booking, Booking::begin(files, folder));
  const std::string why = why_not_now(booking.state(), team, utc_text(handed.at));
  if (!why.empty()) return not_taken(team, why);
  if (book.hand_ins().tries_in_last_hour(team, handed.at) >= quota.tries_per_hour) {
    return not_taken(team, "it has had " + std::to_string(quota.tries_per_hour) +
                               " tries in the last hour; hand it in later");
  }
  if (found.why_not.empty()) {
    MIROCUP_TRY(handed.entry, book.take(handed, [&](const std::string& path) {
      return files.write(path, found.library, system::Readers::owner);
    }));
    return std::nullopt;
  }
  const Submission refused = not_taken(team, found.why_not);
  // Of a name under which nobody has handed in a library nothing is kept.
  if (book.hand_ins().last_kept(team) > 0 || booking.state().find_team(team)) {
    MIROCUP_TRY_VOID(
        book.write(Rejected{.team = team, .message = refused.message, .at = handed.at}));
  }
  return refused;
}

}  // namespace

HandInTerms hand_in_terms(const LeagueState& state, const std::string& team,
                          const std::string& now) {
  HandInTerms terms{.why_not = objection_to(state, team), .deadline = state.frozen_from(team)};
  terms.is_late = terms.why_not.empty() && !terms.deadline.empty() && now >= terms.deadline;
  return terms;
}

std::string why_not_now(const LeagueState& state, const std::string& team, const std::string& now) {
  const HandInTerms terms = hand_in_terms(state, team, now);
  return terms.is_late ? "entries are frozen since " + shown_time(state.file, terms.deadline)
                       : terms.why_not;
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

Result<void> follow_book(system::Files& files, LeagueStore& store, const HandIns& hand_ins,
                         const std::string& team) {
  const Folder& folder = store.folder();
  MIROCUP_TRY(const auto names, files.names_if_there(folder.entries() + "/" + team));
  for (const std::string& name : names) {
    const HandedIn* handed = hand_ins.find(team, system::number_of<int>(name).value_or(0));
    if (handed != nullptr && is_final(handed->state))
      MIROCUP_TRY_VOID(follow_answer(files, store, *handed));
  }
  const LeagueState& state = store.state();
  const auto index = state.find_team(team);
  // The next night of a nightly league takes the entry.
  const bool is_ladder = state.is_started && state.file.format.kind == FormatKind::ladder;
  if (!is_ladder || !index || state.is_closed ||
      state.teams[*index].status == TeamStatus::withdrawn)
    return {};
  const HandedIn* playing = hand_ins.find(team, hand_ins.playing(team));
  if (playing == nullptr || playing->entry == state.teams[*index].entry) return {};
  return store.write(
      EntryBooked{.team = team, .entry = playing->entry, .sha256 = playing->library});
}

Result<Booking> Booking::begin(system::Files& files, const Folder& folder) {
  MIROCUP_TRY(auto alone, system::FileLock::acquire(folder.submitting()));
  MIROCUP_TRY(auto store, LeagueStore::open_unplanned(files, folder));
  return Booking(files, std::move(alone), std::move(store));
}

Result<void> Booking::follow(const HandIns& hand_ins, const std::string& team) {
  return follow_book(files_, store_, hand_ins, team);
}

Result<std::string> Booking::pin(Book& book, const std::string& team, int number,
                                 std::int64_t now) {
  if (const std::string why = why_not_now(state(), team, utc_text(now)); !why.empty()) return why;
  const HandedIn* entry = book.hand_ins().find(team, number);
  const bool is_there = entry != nullptr && entry->is_kept();
  if (number > 0 && is_there && !entry->may_play())
    return "entry " + std::to_string(number) + " of " + team + " was not accepted";
  if (number > 0 && (!is_there || !files_.exists(store_.folder().library(team, number))))
    return team + " has no entry " + std::to_string(number) + " that could play";
  MIROCUP_TRY_VOID(book.write(Pinned{.team = team, .entry = number, .at = now}));
  MIROCUP_TRY_VOID(follow(book.hand_ins(), team));
  return "";
}

Result<std::string> Booking::take_late(Book& book, const std::string& team, int number,
                                       std::int64_t now) {
  const HandedIn* entry = book.hand_ins().find(team, number);
  const std::string name = "entry " + std::to_string(number) + " of " + team;
  if (entry == nullptr || !entry->is_late) return name + " did not come after the deadline";
  if (!entry->is_accepted()) return name + " was not accepted, or is not kept";
  if (const std::string why = objection_to(state(), team); !why.empty()) return team + ": " + why;
  MIROCUP_TRY_VOID(book.write(TakenLate{.team = team, .entry = number, .at = now}));
  MIROCUP_TRY_VOID(follow(book.hand_ins(), team));
  return "";
}

Result<Json> check_entry(system::Files& files, const Folder& folder, const HandedIn& handed,
                         int compile_seconds) {
  MIROCUP_TRY(const auto config,
              files.read_named(folder.config(), system::size_limit::league_file));
  MIROCUP_TRY(const auto rules, parse_league_file(config, folder.config()));
  const std::string& team = handed.team;
  const int number = handed.entry;
  const std::string library = folder.library(team, number);
  std::optional<Json> verdict;
  if (handed.is_network && source_kind_of(handed.file) != SourceKind::none) {
    MIROCUP_TRY(verdict, compile(files, folder, handed, compile_seconds));
  }
  if (!verdict) {
    MIROCUP_TRY(verdict, check(files, library, rules, folder, team, number));
    name_file(*verdict, library, handed.file);
  }
  MIROCUP_TRY_VOID(remove_check_files(files, folder, team, number).and_then([&] {
    return files.write(folder.verdict(team, number), record::json_text(*verdict, 1) + "\n",
                       system::Readers::owner);
  }));
  return std::move(*verdict);
}

Result<Json> read_verdict(system::Files& files, const Folder& folder, const std::string& team,
                          int number) {
  const std::string path = folder.verdict(team, number);
  MIROCUP_TRY(const auto text, files.read_if_there(path, {.max_size = system::size_limit::note}));
  if (!text) return Json();
  return record::read_json<Json>(*text, path, Errc::damaged, verdict_in);
}

Result<Submission> Booking::conclude(Book& book, const std::string& team, int entry, Json verdict,
                                     std::int64_t now, const Quota& quota) {
  const Folder& folder = store_.folder();
  const HandIns& hand_ins = book.hand_ins();
  const HandedIn& handed = *hand_ins.find(team, entry);
  Submission done = answer_to(handed, hand_ins, std::move(verdict));
  Answered answer{.team = team, .entry = entry, .plays = done.plays, .at = now};
  const std::string why = handed.is_late ? objection_to(state(), team)
                                         : why_not_now(state(), team, utc_text(handed.at));
  if (!why.empty()) {
    done = not_taken(team, why);
  } else {
    const std::string path = folder.library(team, entry);
    MIROCUP_TRY(const auto library,
                files_.read_if_there(path, {.max_size = system::size_limit::entry}));
    answer.library = system::sha256(library.value_or(""));
    const std::string checked = record::text_in(done.verdict, "sha256");
    if (!checked.empty() && checked != answer.library)
      return fail(Errc::host, path + " was changed while it was checked");
  }
  answer.state = done.is_accepted ? HandInState::accepted : HandInState::refused;
  answer.message = done.message;
  MIROCUP_TRY_VOID(book.write(answer));
  const auto dropped = hand_ins.to_drop(team, played_entries(store_, team), quota.versions);
  if (!dropped.empty()) MIROCUP_TRY_VOID(book.write(Dropped{.team = team, .entries = dropped}));
  MIROCUP_TRY_VOID(follow(hand_ins, team));
  // Of the refused entries only the newest keeps its library.
  for (const auto& [number, one] : hand_ins.of_team(team)) {
    if (one.is_kept() && !one.is_accepted() && number != hand_ins.last_kept(team))
      MIROCUP_TRY_VOID(files_.remove(folder.library(team, number)));
  }
  return done;
}

Result<Submission> submit(system::Files& files, const Folder& folder, const HandIn& handed,
                          const Quota& quota) {
  const std::string& team = handed.team;
  if (!is_good_name(team)) {
    return fail(Errc::input,
                "\"" + team + "\" is no name: letters, digits, '-', '_' and '.', at most 40");
  }
  MIROCUP_TRY(const auto found, examine(handed.path));
  MIROCUP_TRY(const auto alone, system::FileLock::acquire(folder.checking()));
  MIROCUP_TRY(auto book, Book::open(files, folder));
  HandedIn taken{.team = team,
                 .file = handed.house.empty() ? handed.path : handed.house,
                 .sha256 = system::sha256(found.library),
                 .bytes = found.library.size(),
                 .at = handed.at};
  MIROCUP_TRY(const auto refused, receive(files, folder, book, found, quota, taken));
  if (refused) return *refused;
  auto verdict = check_entry(files, folder, taken);
  if (!verdict) {
    (void)files.remove(folder.entry(team, taken.entry));
    return tl::unexpected(verdict.error());
  }
  MIROCUP_TRY(auto booking, Booking::begin(files, folder));
  MIROCUP_TRY_VOID(book.refresh());
  return booking.conclude(book, team, taken.entry, std::move(*verdict), handed.at, quota);
}

}  // namespace mirocup::league
