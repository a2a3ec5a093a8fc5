// SPDX-License-Identifier: MIT
#include "tournaments/run/runner.hpp"

#include "server/record/digest.hpp"
#include "server/record/locations.hpp"
#include "server/record/match_record.hpp"
#include "server/record/rules_json.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

// Joiners' exits are of no interest: the match server says what became of their team.
constexpr int joiner_tag = -1;

// What a loaded host can cause: such a loss counts when it happens again.
bool is_by_a_clock(const std::string& fault) {
  return fault == "budget" || fault == "hang" || fault == "start_timeout";
}

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

Runner::Runner(record::Files& files, Book book, Progress& progress)
    : files_(files), book_(std::move(book)), progress_(progress) {}

Result<int> Runner::run(const RunOptions& options) {
  if (auto started = start_league(); !started) return tl::unexpected(started.error());
  if (auto booked = book_entries(); !booked) return tl::unexpected(booked.error());
  const std::vector<int> cpus = processors();
  const int jobs = options.jobs > 0 ? options.jobs : static_cast<int>(cpus.size());
  slots_.resize(jobs);
  for (int i = 0; i < jobs; ++i) slots_[i].cpu = cpus[i % cpus.size()];

  bool is_asked_to_stop = false;
  while (true) {
    if (auto fresh = book_.refresh(); !fresh) return tl::unexpected(fresh.error());
    if (!is_asked_to_stop) {
      if (auto filled = fill_slots(); !filled) return tl::unexpected(filled.error());
    }
    progress_.stands_at(state().played(), state().legs(), playing());
    if (playing() == 0 && !is_asked_to_stop) return state().legs() - state().played();
    const auto exit = playing() > 0 ? processes_.wait() : std::nullopt;
    if (!exit && (is_asked_to_stop || playing() == 0)) {
      return fail(Errc::interrupted, "interrupted after " + std::to_string(state().played()) +
                                         " of " + std::to_string(state().legs()) +
                                         " legs; the same command goes on from here");
    }
    if (!exit) {
      is_asked_to_stop = true;
      progress_.say("stopping: " + std::to_string(playing()) +
                    " legs are being played to their end; interrupt again to stop at once");
      continue;
    }
    if (exit->tag == joiner_tag) continue;
    if (auto finished = finish(slots_[exit->tag], *exit); !finished)
      return tl::unexpected(finished.error());
  }
}

int Runner::playing() const {
  return static_cast<int>(
      std::count_if(slots_.begin(), slots_.end(), [](const Slot& s) { return s.leg != 0; }));
}

Result<void> Runner::start_league() {
  if (state().is_started) return {};
  const std::string why =
      objection(state().file.format, static_cast<int>(state().file.teams.size()));
  if (!why.empty()) return fail(Errc::input, book_.folder().config() + ": " + why);
  for (const TeamEntry& team : state().file.teams) {
    if (last_accepted_entry(files_, book_.folder(), team.name) == 0)
      return fail(Errc::input, team.name + " has no entry that was accepted");
  }
  const auto config = files_.read(book_.folder().config());
  if (!config) return tl::unexpected(config.error());
  return book_.write("start", {{"config_sha256", record::sha256(*config)},
                               {"version", record::software_version()}});
}

// The libraries that play are those that the journal names: booked at the start, unchanged ever
// since.
Result<void> Runner::book_entries() {
  for (std::size_t i = 0; i < state().teams.size(); ++i) {
    const std::string& team = state().file.teams[i].name;
    const TeamState& booked = state().teams[i];
    if (booked.standing == Standing::withdrawn) continue;
    const int number =
        booked.entry > 0 ? booked.entry : last_accepted_entry(files_, book_.folder(), team);
    const std::string path = book_.folder().library(team, number);
    const auto library = files_.read(path);
    if (!library) return tl::unexpected(library.error());
    const std::string sha256 = record::sha256(*library);
    if (booked.entry == 0) {
      if (auto written =
              book_.write("entry", {{"team", team}, {"entry", number}, {"sha256", sha256}});
          !written) {
        return written;
      }
    } else if (booked.sha256 != sha256) {
      return fail(Errc::damaged, path + " is not the library that the league was started with");
    }
  }
  return {};
}

const FixtureState* Runner::find(const std::string& id) const {
  const auto index = state().find_fixture(id);
  return index ? &state().fixtures[*index] : nullptr;
}

std::optional<int> Runner::next_leg(const FixtureState& fixture) const {
  if (!fixture.fixture.has_both()) return std::nullopt;
  for (const int team : {fixture.fixture.home, fixture.fixture.away}) {
    if (state().teams[team].standing != Standing::playing) return std::nullopt;
  }
  for (int leg = 1; leg <= fixture.needed(); ++leg) {
    const LegState& now = fixture.legs[leg - 1];
    if (now.played) continue;
    // What decides a tie waits for the others.
    if (leg > fixture.fixture.legs && fixture.decided() < fixture.fixture.legs) continue;
    if (now.host_faults < most_attempts) return leg;
  }
  return std::nullopt;
}

bool Runner::is_taken(const std::string& id) const {
  return std::any_of(slots_.begin(), slots_.end(),
                     [&id](const Slot& s) { return s.fixture == id; });
}

Result<bool> Runner::fill_slots() {
  bool any = false;
  for (Slot& slot : slots_) {
    const auto filled = fill(slot);
    if (!filled) return filled;
    any = any || *filled;
  }
  return any;
}

// Gives a free slot its next leg; false if there is none and it plays nothing.
Result<bool> Runner::fill(Slot& slot) {
  if (slot.leg != 0) return true;
  const FixtureState* next = slot.fixture.empty() ? nullptr : find(slot.fixture);
  if (next == nullptr || !next_leg(*next)) {
    slot.fixture.clear();
    next = nullptr;
    const auto& fixtures = state().fixtures;
    for (std::size_t i = state().first_open(); i < fixtures.size() && next == nullptr; ++i) {
      if (next_leg(fixtures[i]) && !is_taken(fixtures[i].fixture.id())) next = &fixtures[i];
    }
    if (next == nullptr) return false;
    slot.fixture = next->fixture.id();
  }
  if (auto started = start_leg(slot, *next); !started) return tl::unexpected(started.error());
  return true;
}

std::string Runner::seat_of(int team) const {
  const TeamEntry& entry = state().file.teams[team];
  return entry.over_dds ? "dds:" + entry.name
                        : book_.folder().library(entry.name, state().teams[team].entry);
}

std::vector<std::string> Runner::arguments_of(const Slot& slot, const std::string& match_id,
                                              const std::string& record) const {
  const Fixture& fixture = slot.playing;
  const LeagueFile& file = state().file;
  const int blue = blue_team(fixture, slot.leg);
  const int yellow = blue == fixture.home ? fixture.away : fixture.home;
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
  if (slot.leg > fixture.legs) {
    // Golden goal and shoot-out: somebody wins.
    arguments.insert(arguments.end(), {"--stage", "knockout"});
  }
  const std::vector<std::string> rules = rule_options(file.rules, file.league);
  arguments.insert(arguments.end(), rules.begin(), rules.end());
  return arguments;
}

Result<void> Runner::start_leg(Slot& slot, const FixtureState& fixture) {
  slot.playing = fixture.fixture;
  slot.leg = *next_leg(fixture);
  slot.attempt = fixture.legs[slot.leg - 1].voids + 1;
  slot.version = fixture.legs[slot.leg - 1].version;
  const int blue = blue_team(slot.playing, slot.leg);
  const int yellow = blue == slot.playing.home ? slot.playing.away : slot.playing.home;
  // Other leagues may play on this host at the same time.
  const std::string match_id =
      record::sha256(book_.folder().path + state().config_sha256).substr(0, 12) + "-" +
      slot.fixture + "-" + std::to_string(slot.leg);
  const std::string record = book_.folder().record(slot.playing, slot.leg, slot.version);
  const int tag = static_cast<int>(&slot - slots_.data());
  if (auto started =
          processes_.start(arguments_of(slot, match_id, record), tag, slot.cpu, record + ".out");
      !started) {
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
      book_.folder().record(slot.playing, slot.leg, slot.version) + "." + colour + ".join";
  const auto pid = processes_.start(
      {record::sibling_program("mirocup"), "join", "--match", match_id, "--team", colour, "--name",
       entry.name, book_.folder().library(entry.name, state().teams[team].entry)},
      joiner_tag, slot.cpu, log);
  if (!pid) return tl::unexpected(pid.error());
  slot.joiner[colour == "blue" ? 0 : 1] = *pid;
  return {};
}

Result<void> Runner::finish(Slot& slot, const Exit& exit) {
  for (pid_t& joiner : slot.joiner) {
    if (joiner != 0) processes_.kill(joiner);
    joiner = 0;
  }
  const std::string record = book_.folder().record(slot.playing, slot.leg, slot.version);
  Result<void> booked;
  if (exit.signal == 0 && exit.code == exit_yes) {
    booked = book(slot);
  } else {
    const std::string why = exit.signal != 0 ? std::string("the match server died of signal ") +
                                                   std::to_string(exit.signal)
                                             : last_line_of(files_, record + ".out");
    booked = book_void(slot, "host", why);
  }
  const Fixture fixture = slot.playing;
  slot.leg = 0;
  if (!booked) return booked;
  return pause_after_strikes(fixture);
}

// A line that no longer fits, because a person decided otherwise meanwhile, is dropped.
Result<void> Runner::written(Result<void> result) {
  if (result || result.error().code != Errc::input) return result;
  progress_.say("not counted: " + result.error().what);
  return {};
}

Result<void> Runner::book(const Slot& slot) {
  const std::string path = book_.folder().record(slot.playing, slot.leg, slot.version);
  const auto text = files_.read(path);
  if (!text) return book_void(slot, "host", text.error().what);
  const Json record = Json::parse(*text, nullptr, false);
  if (record.is_discarded()) return book_void(slot, "host", path + " is not JSON");
  const Json line = leg_line(state().file, slot.playing, slot.leg, slot.attempt, record,
                             Folder::record_name(slot.playing, slot.leg, slot.version));
  const Json& fault = line.at("fault");
  const FixtureState* fixture = find(slot.fixture);
  const bool is_confirmed = fixture != nullptr && fixture->legs[slot.leg - 1].is_to_confirm;
  if (!fault.is_null() && is_by_a_clock(fault.at("code").get<std::string>()) && !is_confirmed) {
    return book_void(slot, "confirm",
                     fault.at("team").get<std::string>() + ": " +
                         fault.at("code").get<std::string>() + ": " +
                         fault.at("text").get<std::string>() + "; played again to confirm it");
  }
  if (auto booked = written(book_.write("leg", line)); !booked) return booked;
  progress_.say(std::to_string(state().played()) + "/" + std::to_string(state().legs()) + "  " +
                line.at("home").get<std::string>() + " " + line.at("score").at("home").dump() +
                " : " + line.at("score").at("away").dump() + " " +
                line.at("away").get<std::string>() + "  (" + line.at("end").get<std::string>() +
                ")");
  return {};
}

Result<void> Runner::book_void(const Slot& slot, const std::string& cause, const std::string& why) {
  progress_.say(slot.fixture + " leg " + std::to_string(slot.leg) + ": void: " + why);
  return written(book_.write("void", {{"fixture", slot.fixture},
                                      {"leg", slot.leg},
                                      {"attempt", slot.attempt},
                                      {"cause", cause},
                                      {"why", why}}));
}

Result<void> Runner::pause_after_strikes(const Fixture& fixture) {
  const int most = state().file.strikes;
  for (const int team : {fixture.home, fixture.away}) {
    const TeamState& now = state().teams[team];
    if (most == 0 || now.strikes < most || now.standing != Standing::playing) continue;
    const std::string why = std::to_string(now.strikes) + " legs in a row lost by its own faults";
    const std::string name = state().name(team);
    if (auto paused = written(book_.write("pause", {{"team", name}, {"why", why}})); !paused)
      return paused;
    progress_.say(name + " is paused: " + why + "; mirocup league resume or withdraw " +
                  book_.folder().path + " " + name);
  }
  return {};
}

}  // namespace mirocup::league
