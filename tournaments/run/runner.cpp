// SPDX-License-Identifier: MIT
#include "tournaments/run/runner.hpp"

#include "server/record/digest.hpp"
#include "server/record/locations.hpp"
#include "tournaments/run/begin.hpp"
#include "tournaments/run/leg_command.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace mirocup::league {

namespace {

// Joiners' exits are of no interest: the match server says what became of their team.
constexpr int joiner_tag = -1;

// What a loaded host can cause: such a loss counts when it happens again.
bool is_by_a_clock(const std::string& fault) {
  return fault == "budget" || fault == "hang" || fault == "start_timeout";
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
  if (auto begun = begin_league(files_, book_); !begun) return tl::unexpected(begun.error());
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
    const auto spoiled = spoiled_.find(Folder::record_name(fixture.fixture, leg, now.version));
    if (spoiled == spoiled_.end() || spoiled->second < most_attempts) return leg;
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

const FixtureState* Runner::next_fixture(const Slot& slot) const {
  // The legs of a fixture stay on one processor.
  const FixtureState* own = slot.fixture.empty() ? nullptr : find(slot.fixture);
  if (own != nullptr && next_leg(*own)) return own;
  const auto& fixtures = state().fixtures;
  for (std::size_t i = state().first_open(); i < fixtures.size(); ++i) {
    const std::string id = fixtures[i].fixture.id();
    if (next_leg(fixtures[i]) && (id == slot.fixture || !is_taken(id))) return &fixtures[i];
  }
  return nullptr;
}

// Gives a free slot its next leg; false if there is none and it plays nothing.
Result<bool> Runner::fill(Slot& slot) {
  while (slot.leg == 0) {
    const FixtureState* next = next_fixture(slot);
    slot.fixture.clear();
    if (next == nullptr) return false;
    slot.fixture = next->fixture.id();
    slot.playing = next->fixture;
    slot.leg = *next_leg(*next);
    slot.attempt = next->legs[slot.leg - 1].voids + 1;
    slot.version = next->legs[slot.leg - 1].version;
    // A shard may have played it, or this program died before it could book it.
    const std::string name = Folder::record_name(slot.playing, slot.leg, slot.version);
    std::optional<Json> record;
    if (looked_at_.insert(name).second)
      record = played_record(files_, book_.folder(), state(), id_of(slot));
    if (record) {
      if (auto booked = book_record(slot, *record); !booked) return tl::unexpected(booked.error());
      slot.leg = 0;
    } else if (auto started = start_leg(slot); !started) {
      return tl::unexpected(started.error());
    }
  }
  return true;
}

LegId Runner::id_of(const Slot& slot) const {
  return {slot.playing, slot.leg, slot.version};
}

// A league with credentials plays in secure mode.
std::vector<std::string> Runner::credentials_of(const std::string& whose) const {
  const std::string folder = book_.folder().credentials();
  if (!files_.exists(folder + "/server")) return {};
  return {"--credentials", folder + "/" + whose};
}

Result<void> Runner::start_leg(Slot& slot) {
  const int blue = blue_team(slot.playing, slot.leg);
  const int yellow = blue == slot.playing.home ? slot.playing.away : slot.playing.home;
  // Other leagues may play on this host at the same time.
  const std::string match_id =
      record::sha256(book_.folder().path + state().config_sha256).substr(0, 12) + "-" +
      slot.fixture + "-" + std::to_string(slot.leg);
  const std::string log = book_.folder().record(slot.playing, slot.leg, slot.version) + ".out";
  const int tag = static_cast<int>(&slot - slots_.data());
  auto command = leg_command(book_.folder(), state(), id_of(slot), match_id);
  const std::vector<std::string> credentials = credentials_of("server");
  command.insert(command.end(), credentials.begin(), credentials.end());
  if (auto started = processes_.start(command, tag, slot.cpu, log); !started)
    return tl::unexpected(started.error());
  if (auto joined = start_joiner(slot, blue, "blue", match_id); !joined) return joined;
  return start_joiner(slot, yellow, "yellow", match_id);
}

Result<void> Runner::start_joiner(Slot& slot, int team, const std::string& colour,
                                  const std::string& match_id) {
  const TeamEntry& entry = state().file.teams[team];
  if (!entry.over_dds) return {};
  const std::string log =
      book_.folder().record(slot.playing, slot.leg, slot.version) + "." + colour + ".join";
  std::vector<std::string> command{record::sibling_program("mirocup"),
                                   "join",
                                   "--match",
                                   match_id,
                                   "--team",
                                   colour,
                                   "--name",
                                   entry.name,
                                   book_.folder().library(entry.name, state().teams[team].entry)};
  const std::vector<std::string> credentials = credentials_of("teams/" + entry.name);
  command.insert(command.end(), credentials.begin(), credentials.end());
  const auto pid = processes_.start(command, joiner_tag, slot.cpu, log);
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
  slot.leg = 0;
  return booked;
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
  return book_record(slot, record);
}

Result<void> Runner::book_record(const Slot& slot, const Json& record) {
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
  return pause_after_strikes(slot.playing);
}

Result<void> Runner::book_void(const Slot& slot, const std::string& cause, const std::string& why) {
  if (cause == "host") ++spoiled_[Folder::record_name(slot.playing, slot.leg, slot.version)];
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
