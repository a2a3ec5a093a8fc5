// SPDX-License-Identifier: MIT
#include "tournaments/league/health.hpp"

#include "system/clock.hpp"
#include "system/memory.hpp"
#include "tournaments/league/gaps.hpp"

#include <algorithm>
#include <filesystem>

namespace mirocup::league {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t day_s = 24 * 3600;
constexpr std::int64_t late_s = day_s / 2;          // a night may begin so much later than expected
constexpr std::int64_t longest_check_s = 15 * 60;   // the server gives up a check before
constexpr std::uintmax_t least_left = 1024u << 20;  // bytes: some nights of a class

std::int64_t seconds_of(const std::string& utc) {
  const auto time = system::parse_time(utc);
  return time ? time->at : 0;
}

// A night is expected as long after the last one as that one was after the night before.
void look_at_nights(system::Files& files, const LeagueStore& store, std::int64_t now, Health& h) {
  const LeagueState& state = store.state();
  if (state.nights.empty()) return;
  h.night = state.nights.back().number;
  h.night_at = state.nights.back().at;
  if (h.is_playing) return;
  const std::string name = "night " + std::to_string(h.night);
  if (!files.exists(store.folder().nights() + "/" + std::to_string(h.night) + "/report.txt"))
    h.problems.push_back(name + " did not come to its end: " + std::to_string(h.open_legs) +
                         " legs are open; mirocup league nightly continues it");
  if (state.is_closed || state.file.format.kind != FormatKind::nightly) return;
  const std::int64_t last = seconds_of(h.night_at);
  const std::int64_t gap =
      state.nights.size() < 2 ? day_s : last - seconds_of(state.nights[state.nights.size() - 2].at);
  if (now - last > std::max(gap, day_s) + late_s)
    h.problems.push_back("no night has begun since " + name + " at " +
                         shown_time(state.file, h.night_at) +
                         ": check the timer that starts mirocup league nightly");
}

// A person who has paused a team knows of it.
void look_at_teams(const LeagueState& state, Health& h) {
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    if (state.teams[i].status != TeamStatus::paused) continue;
    const std::string& team = state.file.teams[i].name;
    const auto by_person = [&team](const Decision& d) {
      const auto* paused = std::get_if<Paused>(&d.event);
      return paused != nullptr && paused->team == team && !d.undone_by;
    };
    if (std::ranges::any_of(state.decisions, by_person)) continue;
    h.problems.push_back(
        team + " is paused: " + state.teams[i].why +
        "; league resume lets it play again, league withdraw takes it out of the league");
  }
}

void look_at_legs(const LeagueState& state, Health& h) {
  h.open_legs = state.legs() - state.played();
  for (const FixtureState& f : state.fixtures) {
    for (int leg = 0; leg < f.needed() && !h.is_playing; ++leg) {
      if (f.legs[leg].played || f.legs[leg].host_faults < max_attempts) continue;
      h.problems.push_back(
          f.fixture.id() + " leg " + std::to_string(leg + 1) + ": failed " +
          std::to_string(f.legs[leg].host_faults) +
          " times by this computer's fault; the journal has the reasons: mend them and play again");
    }
  }
}

void look_at_hand_ins(const HandIns& hand_ins, std::int64_t now, Health& h) {
  const auto waiting = hand_ins.waiting();
  h.waiting = static_cast<int>(waiting.size());
  for (const HandedIn* handed : waiting) h.waits_s = std::max(h.waits_s, now - handed->at);
  if (h.waits_s > longest_check_s)
    h.problems.push_back(
        "hand-ins wait for their checks (" + std::to_string(h.waiting) + "), the oldest for " +
        std::to_string(h.waits_s / 60) +
        " min: check that mirocup league serve --hand-in runs, and read what it prints");
}

void add_size(std::uintmax_t& sum, const fs::directory_entry& file) {
  std::error_code gone;
  if (!file.is_regular_file(gone) || file.is_symlink(gone)) return;
  if (const std::uintmax_t size = file.file_size(gone); !gone) sum += size;
}

std::uintmax_t left_on_disk(const Folder& folder) {
  std::error_code unknown;
  const fs::space_info space = fs::space(folder.path, unknown);
  return unknown ? 0 : space.available;
}

}  // namespace

DiskUse disk_use(const Folder& folder) {
  DiskUse use{.left = left_on_disk(folder)};
  std::error_code gone;
  for (const auto& part : fs::directory_iterator(folder.path, gone)) {
    if (part.is_symlink(gone)) continue;
    std::uintmax_t sum = 0;
    add_size(sum, part);
    fs::recursive_directory_iterator file(part.path(),
                                          fs::directory_options::skip_permission_denied, gone);
    for (; !gone && file != fs::recursive_directory_iterator(); file.increment(gone))
      add_size(sum, *file);
    use.all += sum;
    const std::string name = part.path().filename();
    if (name == "records") use.records = sum;
    if (name == "site") use.pages = sum;
    if (name == "entries") use.entries = sum;
  }
  if (folder.has_site_elsewhere()) use.all += use.pages = disk_use(Folder(folder.site())).all;
  return use;
}

std::string in_words(const DiskUse& disk) {
  return system::mebibytes(disk.all) + " used (records " + std::to_string(disk.records >> 20) +
         ", pages " + std::to_string(disk.pages >> 20) + ", entries " +
         std::to_string(disk.entries >> 20) + "), " + system::mebibytes(disk.left) + " left";
}

Json disk_json(const DiskUse& disk) {
  return {{"used", disk.all},
          {"records", disk.records},
          {"pages", disk.pages},
          {"entries", disk.entries},
          {"left", disk.left}};
}

Result<Health> health(system::Files& files, const LeagueStore& store, const HandIns& hand_ins,
                      std::int64_t now) {
  Health h;
  h.is_playing = is_being_played(store.folder());
  MIROCUP_TRY(const auto found, gaps(files, store, h.is_playing));
  h.problems = found.in_words();
  look_at_legs(store.state(), h);
  look_at_nights(files, store, now, h);
  look_at_teams(store.state(), h);
  look_at_hand_ins(hand_ins, now, h);
  if (const std::uintmax_t left = left_on_disk(store.folder()); left < least_left)
    h.problems.push_back(system::mebibytes(left) +
                         " are left on the disk: make room, for example by mirocup league prune");
  return h;
}

}  // namespace mirocup::league
