// SPDX-License-Identifier: MIT
//
// The subcommand nightly: what is accepted now plays, every team hears what has changed.
#include "programs/league/commands.hpp"
#include "programs/league/playing.hpp"
#include "programs/league/publishing.hpp"
#include "system/child_process.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/play/leg_command.hpp"
#include "tournaments/play/program.hpp"
#include "tournaments/publish/night_pages.hpp"
#include "tournaments/publish/site.hpp"
#include "tournaments/publish/snapshot.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

namespace mirocup::league {

namespace {

struct NightlyOptions : LeagueOptions {
  bool another = false;         // one more on the same day
  std::string on_night;         // a program that hears of the night; "": none
  int on_night_within_s = 600;  // it is stopped if it takes longer
  std::string address;          // what links of the digests' texts begin with
  PlayTerms play;
};

// Returns for each team its last accepted entry, or the one that it has pinned, unless it plays
// with that already.
Result<std::vector<EntryBooked>> new_entries(system::Files& files, const LeagueStore& store) {
  std::vector<EntryBooked> entries;
  const LeagueState& state = store.state();
  if (state.file.format.kind != FormatKind::nightly) return entries;
  MIROCUP_TRY(const auto book, Book::open(files, store.folder()));
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    const std::string& team = state.file.teams[i].name;
    if (state.teams[i].status == TeamStatus::withdrawn) continue;
    const HandedIn* playing = book.hand_ins().find(team, book.hand_ins().playing(team));
    if (playing == nullptr || playing->entry == state.teams[i].entry) continue;
    entries.push_back({.team = team, .entry = playing->entry, .sha256 = playing->library});
  }
  return entries;
}

// An interrupted night is gone on with for so long, whatever the date says. Later a new one
// begins, which plays what is open of those before, so that no day is left out.
constexpr std::int64_t longest_night_s = 12 * 3600;

// True if the last night has legs to play: those of paused teams stay open for longer.
bool has_legs_to_play(const LeagueState& state) {
  if (state.played() == state.legs() || state.file.format.kind != FormatKind::nightly) return false;
  return std::ranges::any_of(state.fixtures, [&state](const FixtureState& f) {
    return f.fixture.round == static_cast<int>(state.nights.size()) && !open_legs(state, f).empty();
  });
}

// True if the command goes on with the last night: it began on the day that it is in the league's
// zone, or was interrupted not long ago.
bool goes_on(const LeagueState& state, std::int64_t now) {
  if (state.nights.empty()) return false;
  const auto began = system::parse_time(state.nights.back().at);
  if (!began) return false;
  if (state.file.time_zone.date(began->at) == state.file.time_zone.date(now)) return true;
  return now - began->at < longest_night_s && has_legs_to_play(state);
}

// Says so if the clock of this computer cannot be right: a night has its date.
void doubt_clock(const LeagueStore& store, std::int64_t now) {
  constexpr std::int64_t ahead_s = 90 * 24 * 3600;
  const auto& lines = store.journal().lines();
  const auto last =
      lines.empty() ? std::nullopt : system::parse_time(record::text_in(lines.back(), "at"));
  if (!last || (now >= last->at && now - last->at < ahead_s)) return;
  std::cerr << "mirocup: the clock of this computer says " << utc_text(now)
            << (now < last->at ? ", which is before the last line of the journal, "
                               : ", which is long after the last line of the journal, ")
            << utc_text(last->at) << ": check the clock, since nights and entries get its time\n";
}

// Begins a night, or goes on with the one that was interrupted.
Result<void> begin_night(system::Files& files, LeagueStore& store, const NightlyOptions& options,
                         std::int64_t now) {
  if (store.state().is_closed) return fail(Errc::input, "the league is closed: no night follows");
  doubt_clock(store, now);
  MIROCUP_TRY_VOID(start_league(files, store));
  if (!options.another && goes_on(store.state(), now)) {
    std::cerr << "mirocup: night " << store.state().nights.size()
              << " continues; --another begins a further night on the same day\n";
    return {};
  }
  // Hand-ins that are being checked count from the next night on.
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(store.folder().submitting()));
  MIROCUP_TRY(const auto entries, new_entries(files, store));
  return store.write(NightBegan{.number = static_cast<int>(store.state().nights.size()) + 1,
                                .entries = entries,
                                .at = utc_text(now)});
}

// Writes what each team is told to nights/N, which only the host can read.
Result<void> write_digests(system::Files& files, const Folder& folder,
                           const std::vector<RosterRow>& rows, const Overview& o,
                           const Night& night, const std::string& address) {
  std::map<std::string, std::vector<std::string>> told;
  for (const RosterRow& row : rows) told[row.team] = row.told();
  const std::string home = folder.nights() + "/" + std::to_string(night.number);
  MIROCUP_TRY_VOID(files.make_folder(folder.nights(), system::Readers::owner).and_then([&] {
    return files.make_folder(home, system::Readers::owner);
  }));
  for (TeamDigest digest : digests(night, o)) {
    digest.hand_ins = told[o.state.name(digest.team)];
    const std::string path = home + "/" + o.state.name(digest.team);
    MIROCUP_TRY_VOID(
        files.write(path + ".txt", digest_text(o, night, digest, address), system::Readers::owner)
            .and_then([&] {
              return files.write(path + ".json",
                                 record::json_text(digest_json(o, digest), 1) + "\n",
                                 system::Readers::owner);
            }));
  }
  return {};
}

// Returns what the host reads in the morning.
std::string report(const LeagueState& state, const std::vector<RosterRow>& rows,
                   const Night& night) {
  std::ostringstream text;
  text << system::printable(state.file.title) << ", night " << night.number << ", "
       << shown_time(state.file, night.at) << '\n';
  text << night.records.size() << " legs were played in this night; "
       << state.legs() - state.played() << " legs of the league are not decided\n\n"
       << table_text(state) << '\n';
  for (const RosterRow& row : rows) {
    if (row.status == TeamStatus::withdrawn) continue;
    const int before = [&] {
      const auto team = night.before.find_team(row.team);
      return team ? night.before.teams[*team].entry : 0;
    }();
    if (row.playing_entry != before)
      text << row.team << " plays with entry " << row.playing_entry << " from this night on\n";
    if (row.status == TeamStatus::paused)
      text << row.team << " is paused: " << system::printable(row.why) << '\n';
    for (const std::string& told : row.told())
      text << row.team << ": " << system::printable(told) << '\n';
    // The first of the teams names the others.
    const auto& same = row.same_as;
    if (same.empty() || *std::ranges::min_element(same) < row.team) continue;
    text << row.team << " and ";
    for (const std::string& other : same) text << (other == same.front() ? "" : ", ") << other;
    text << " handed in the same file\n";
  }
  for (const FixtureState& f : state.fixtures) {
    for (const LegState& leg : f.legs) {
      if (leg.played && leg.played->fault && night.records.contains(leg.played->record))
        text << f.fixture.id() << ": " << system::printable(leg.played->fault->summary()) << '\n';
    }
  }
  return text.str();
}

// The exit code of Debian's command timeout, which ends what its program has started, too.
constexpr int timed_out = 124;

// Starts the host's program with the folder of the digests, once for each night: a file says that
// it has ended well. While nothing is told to teams, the program is told nothing either.
Result<void> tell_program(system::Files& files, const NightlyOptions& options,
                          const std::string& home, const LeagueState& state) {
  const std::string& program = options.on_night;
  if (program.empty()) return {};
  if (!sees_all(Viewer::team, state)) {
    std::cerr << "mirocup: " << program << " is not started: this night is hidden from teams\n";
    return {};
  }
  const std::string told = home + "/told";
  MIROCUP_TRY(const auto mark, files.read_if_there(told, {.max_size = system::size_limit::note}));
  if (mark) return {};
  const std::string folder = std::filesystem::absolute(home);
  const std::string limit = std::to_string(options.on_night_within_s);
  MIROCUP_TRY(
      const auto code,
      system::run_child(
          {.arguments = {"timeout", "--kill-after=10", limit, program, folder}, .log = ""}));
  if (code == system::not_found)
    return fail(Errc::unavailable, program + " cannot be started; the night itself was played");
  const std::string why = code == timed_out ? "has not ended after " + limit + " s and was stopped"
                                            : "exit code " + std::to_string(code);
  if (code != 0)
    return fail(Errc::unavailable, program + " " + folder + ": " + why +
                                       "; the night itself was played, and the same command on the "
                                       "same day starts that program again");
  return files.write(told, utc_text(system::now_s()) + "\n", system::Readers::owner);
}

Result<int> run_nightly(const NightlyOptions& options) {
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(auto held, hold_league(disk, folder, ": this night is left out"));
  MIROCUP_TRY_VOID(expect_program(held.store, record::this_software()));
  MIROCUP_TRY_VOID(begin_night(disk, held.store, options, system::now_s()));

  MIROCUP_TRY(const auto end, play_and_publish(disk, std::move(held.store), options.play));
  MIROCUP_TRY(const auto after, LeagueStore::open(disk, folder));
  MIROCUP_TRY(const auto night, last_night(after.state(), after.journal()));
  KnownLegs legs;
  read_legs(disk, after.folder(), after.state(), legs);
  const Overview o = overview(after.state(), legs);
  MIROCUP_TRY(const auto book, Book::open(disk, folder));
  MIROCUP_TRY(const auto rows, roster(disk, after, book.hand_ins()));
  MIROCUP_TRY_VOID(write_digests(disk, folder, rows, o, *night, options.address));
  const std::string text = report(after.state(), rows, *night);
  const std::string home = folder.nights() + "/" + std::to_string(night->number);
  MIROCUP_TRY_VOID(disk.write(home + "/report.txt", text, system::Readers::owner));
  std::cout << text << std::flush;
  MIROCUP_TRY_VOID(tell_program(disk, options, home, after.state()));
  return exit_code_of(end, after.state());
}

}  // namespace

void add_nightly(system::Commands& commands) {
  const auto [command, o] = add_command(
      commands, run_nightly, "nightly", to_play,
      "Play a night with the accepted entries, publish it, and write a digest for each team",
      {"mirocup league nightly spring",
       "mirocup league nightly spring --on-night ./mail --address https://league.example/"});
  command.jobs(o.play.jobs, "legs played");
  add_nat(command, o.play);
  command.flag("--another", o.another, "Play a further night on the same day");
  command.option("--on-night PROGRAM", o.on_night,
                 "Program to start once after the night; its argument is the folder of the night's "
                 "digests");
  command
      .option("--on-night-within", o.on_night_within_s,
              "Seconds after which the program of --on-night is stopped and counts as failed")
      .between(1, 86'400);
  command.option("--address URL", o.address,
                 "Address of the league's pages, with which the links in digests begin, as "
                 "https://league.example/");
}

}  // namespace mirocup::league
