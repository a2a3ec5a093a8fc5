// SPDX-License-Identifier: MIT
#include "tournaments/run/runner.hpp"

#include "server/record/digest.hpp"
#include "server/record/locations.hpp"
#include "server/record/match_record.hpp"
#include "server/record/rules_json.hpp"

#include <algorithm>
#include <cstring>

namespace mirocup::league {

namespace {

// Joiners' exits are of no interest: the match server says what became of their team.
constexpr int joiner_tag = -1;
constexpr int entry_number = 1;

// The rules that differ from their preset, as options of mirocup match.
std::vector<std::string> rule_options(const referee::Rules& rules, League league) {
  std::vector<std::string> options{"--rules", std::string(to_string(rules.preset))};
  const Json preset = record::to_json(referee::make_rules(rules.preset, league));
  const Json own = record::to_json(rules);
  for (const auto& [key, value] : own.items()) {
    if (value == preset.at(key)) continue;
    options.push_back("--rule");
    options.push_back(key + "=" + value.dump());
  }
  return options;
}

std::string last_line_of(record::Files& files, const std::string& path) {
  const auto text = files.read(path);
  if (!text || text->empty()) return "";
  const std::size_t end = text->find_last_not_of('\n');
  if (end == std::string::npos) return "";
  const std::size_t begin = text->rfind('\n', end);
  return text->substr(begin == std::string::npos ? 0 : begin + 1,
                      end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

}  // namespace

Runner::Runner(record::Files& files, Folder folder, OpenLeague league, Progress progress)
    : files_(files),
      folder_(std::move(folder)),
      league_(std::move(league)),
      progress_(std::move(progress)) {}

Result<int> Runner::run(const RunOptions& options) {
  if (auto started = start_league(); !started) return tl::unexpected(started.error());
  if (auto checked = check_entries(); !checked) return tl::unexpected(checked.error());
  const std::vector<int> cpus = processors();
  const int jobs = options.jobs > 0 ? options.jobs : static_cast<int>(cpus.size());
  slots_.resize(jobs);
  for (int i = 0; i < jobs; ++i) slots_[i].cpu = cpus[i % cpus.size()];

  while (true) {
    bool playing = false;
    for (Slot& slot : slots_) {
      const auto filled = fill(slot);
      if (!filled) return tl::unexpected(filled.error());
      playing = playing || *filled;
    }
    if (!playing) return state().legs() - state().played();
    const auto exit = processes_.wait();
    if (!exit) {
      return fail(Errc::interrupted, "interrupted after " + std::to_string(state().played()) +
                                         " of " + std::to_string(state().legs()) +
                                         " legs; the same command goes on from here");
    }
    if (exit->tag == joiner_tag) continue;
    if (auto finished = finish(slots_[exit->tag], *exit); !finished)
      return tl::unexpected(finished.error());
  }
}

Result<void> Runner::start_league() {
  if (state().is_started) return {};
  if (state().file.teams.size() < 2)
    return fail(Errc::input, folder_.config() + ": a league needs two teams");
  const auto config = files_.read(folder_.config());
  if (!config) return tl::unexpected(config.error());
  const std::string sha256 = record::sha256(*config);
  if (auto written = league_.journal.append(
          "start", {{"config_sha256", sha256}, {"version", record::software_version()}});
      !written) {
    return written;
  }
  league_.state.is_started = true;
  league_.state.config_sha256 = sha256;
  return {};
}

// The libraries that play are those that the journal names: booked at the start, unchanged ever
// since.
Result<void> Runner::check_entries() {
  for (const TeamEntry& team : state().file.teams) {
    const auto library = files_.read(folder_.library(team.name, entry_number));
    if (!library) return tl::unexpected(library.error());
    const std::string sha256 = record::sha256(*library);
    const auto booked = std::find_if(
        league_.journal.lines().begin(), league_.journal.lines().end(), [&team](const Json& line) {
          return line.at("kind") == "entry" && line.at("team") == team.name;
        });
    if (booked == league_.journal.lines().end()) {
      if (auto written = league_.journal.append(
              "entry", {{"team", team.name}, {"entry", entry_number}, {"sha256", sha256}});
          !written) {
        return written;
      }
    } else if (booked->at("sha256") != sha256) {
      return fail(Errc::damaged, folder_.library(team.name, entry_number) +
                                     " is not the library that the league was started with");
    }
  }
  return {};
}

std::optional<int> Runner::next_leg(const FixtureState& fixture) const {
  for (int leg = 1; leg <= legs_per_fixture; ++leg) {
    if (!fixture.legs[leg - 1] && fixture.voids[leg - 1] < most_attempts) return leg;
  }
  return std::nullopt;
}

bool Runner::is_taken(int fixture) const {
  return std::any_of(slots_.begin(), slots_.end(),
                     [fixture](const Slot& s) { return s.fixture == fixture; });
}

// Gives a free slot its next leg; false if there is none and it plays nothing.
Result<bool> Runner::fill(Slot& slot) {
  if (slot.leg != 0) return true;
  if (slot.fixture < 0 || !next_leg(state().fixtures[slot.fixture])) {
    slot.fixture = -1;
    for (int i = 0; i < static_cast<int>(state().fixtures.size()); ++i) {
      if (is_taken(i) || !next_leg(state().fixtures[i])) continue;
      slot.fixture = i;
      break;
    }
    if (slot.fixture < 0) return false;
  }
  slot.leg = *next_leg(state().fixtures[slot.fixture]);
  if (auto started = start_leg(slot); !started) return tl::unexpected(started.error());
  return true;
}

int Runner::attempt_of(const Slot& slot) const {
  return state().fixtures[slot.fixture].voids[slot.leg - 1] + 1;
}

std::string Runner::seat_of(int team) const {
  const TeamEntry& entry = state().file.teams[team];
  return entry.over_dds ? "dds:" + entry.name : folder_.library(entry.name, entry_number);
}

// A league with credentials plays in secure mode.
std::vector<std::string> Runner::credentials_of(const std::string& whose) const {
  const std::string folder = folder_.credentials() + "/" + whose;
  if (!files_.exists(folder_.credentials() + "/server")) return {};
  return {"--credentials", folder};
}

Result<void> Runner::start_leg(Slot& slot) {
  const Fixture& fixture = state().fixtures[slot.fixture].fixture;
  const LeagueFile& file = state().file;
  const int blue = blue_team(fixture, slot.leg);
  const int yellow = blue == fixture.home ? fixture.away : fixture.home;
  // Other leagues may play on this host at the same time.
  const std::string match_id = record::sha256(folder_.path + state().config_sha256).substr(0, 12) +
                               "-" + fixture.id() + "-" + std::to_string(slot.leg);
  const std::string record = folder_.record(fixture, slot.leg, attempt_of(slot));
  std::vector<std::string> arguments{record::sibling_program("mirocup"),
                                     "match",
                                     "--blue",
                                     seat_of(blue),
                                     "--blue-name",
                                     file.teams[blue].name,
                                     "--yellow",
                                     seat_of(yellow),
                                     "--yellow-name",
                                     file.teams[yellow].name,
                                     "--league",
                                     std::string(to_string(file.league)),
                                     "--seed",
                                     std::to_string(fixture_seed(file.seed, fixture)),
                                     "--match",
                                     match_id,
                                     "--record",
                                     record};
  const std::vector<std::string> rules = rule_options(file.rules, file.league);
  arguments.insert(arguments.end(), rules.begin(), rules.end());
  const int tag = static_cast<int>(&slot - slots_.data());
  const std::vector<std::string> credentials = credentials_of("server");
  arguments.insert(arguments.end(), credentials.begin(), credentials.end());
  if (auto started = processes_.start(arguments, tag, slot.cpu, record + ".out"); !started) {
    return tl::unexpected(started.error());
  }
  if (auto joined = start_joiner(slot, blue, "blue", match_id); !joined) return joined;
  return start_joiner(slot, yellow, "yellow", match_id);
}

Result<void> Runner::start_joiner(Slot& slot, int team, const std::string& colour,
                                  const std::string& match_id) {
  const TeamEntry& entry = state().file.teams[team];
  if (!entry.over_dds) return {};
  const std::string log =
      folder_.record(state().fixtures[slot.fixture].fixture, slot.leg, attempt_of(slot)) + "." +
      colour + ".join";
  std::vector<std::string> arguments{record::sibling_program("mirocup"),
                                     "join",
                                     "--match",
                                     match_id,
                                     "--team",
                                     colour,
                                     "--name",
                                     entry.name,
                                     folder_.library(entry.name, entry_number)};
  const std::vector<std::string> credentials = credentials_of("teams/" + entry.name);
  arguments.insert(arguments.end(), credentials.begin(), credentials.end());
  const auto pid = processes_.start(arguments, joiner_tag, slot.cpu, log);
  if (!pid) return tl::unexpected(pid.error());
  slot.joiner[colour == "blue" ? 0 : 1] = *pid;
  return {};
}

Result<void> Runner::finish(Slot& slot, const Exit& exit) {
  for (pid_t& joiner : slot.joiner) {
    if (joiner != 0) processes_.kill(joiner);
    joiner = 0;
  }
  const int attempt = attempt_of(slot);
  const Fixture fixture = state().fixtures[slot.fixture].fixture;
  const std::string record = folder_.record(fixture, slot.leg, attempt);
  Result<void> booked;
  if (exit.signal == 0 && exit.code == exit_yes) {
    booked = book(slot, attempt);
  } else {
    const std::string why = exit.signal != 0 ? std::string("the match server died of signal ") +
                                                   std::to_string(exit.signal)
                                             : last_line_of(files_, record + ".out");
    booked = book_void(slot, attempt, why);
  }
  slot.leg = 0;
  return booked;
}

Result<void> Runner::book(const Slot& slot, int attempt) {
  FixtureState& fixture = league_.state.fixtures[slot.fixture];
  const std::string path = folder_.record(fixture.fixture, slot.leg, attempt);
  const auto text = files_.read(path);
  if (!text) return book_void(slot, attempt, text.error().what);
  const Json record = Json::parse(*text, nullptr, false);
  if (record.is_discarded()) return book_void(slot, attempt, path + " is not JSON");
  const Json line = leg_line(state().file, fixture.fixture, slot.leg, attempt, record,
                             Folder::record_name(fixture.fixture, slot.leg, attempt));
  if (auto written = league_.journal.append("leg", line); !written) return written;
  // The state follows the journal, by the same code that reads it.
  auto state_now = league_state(state().file, league_.journal);
  if (!state_now) return tl::unexpected(state_now.error());
  league_.state = std::move(*state_now);
  progress_(std::to_string(state().played()) + "/" + std::to_string(state().legs()) + "  " +
            line.at("home").get<std::string>() + " " + line.at("score").at("home").dump() + " : " +
            line.at("score").at("away").dump() + " " + line.at("away").get<std::string>() + "  (" +
            line.at("end").get<std::string>() + ")");
  return {};
}

Result<void> Runner::book_void(const Slot& slot, int attempt, const std::string& why) {
  const Fixture& fixture = state().fixtures[slot.fixture].fixture;
  progress_(fixture.id() + " leg " + std::to_string(slot.leg) + ": void: " + why);
  const Json line{{"fixture", fixture.id()}, {"leg", slot.leg}, {"attempt", attempt}, {"why", why}};
  if (auto written = league_.journal.append("void", line); !written) return written;
  ++league_.state.fixtures[slot.fixture].voids[slot.leg - 1];
  return {};
}

}  // namespace mirocup::league
