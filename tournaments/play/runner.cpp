// SPDX-License-Identifier: MIT
#include "tournaments/play/runner.hpp"

#include "record/answer.hpp"
#include "record/team_parameters_json.hpp"
#include "system/digest.hpp"
#include "system/locations.hpp"
#include "system/memory.hpp"

#include <algorithm>
#include <filesystem>

namespace mirocup::league {

namespace {

// The exits of joiners are ignored: the match server reports the fate of their team.
constexpr int joiner_tag = -1;

// Free bytes below which nothing can be written any more, not even why.
constexpr std::uintmax_t least_room = 64u << 10;

// True if a match server has failed because there is no room for its record.
bool is_disk_full(const std::string& folder, const Json& answer) {
  if (record::text_in(answer, "code") == to_string(Errc::no_room)) return true;
  std::error_code unknown;
  const auto space = std::filesystem::space(folder, unknown);
  return !unknown && space.available < least_room;
}

}  // namespace

std::string memory_warning(std::optional<std::size_t> available, int jobs) {
  const std::size_t needed = static_cast<std::size_t>(jobs) * system::memory_of_a_leg;
  if (!available || *available >= needed) return "";
  const std::size_t room = *available / system::memory_of_a_leg;
  return "warning: " + system::mebibytes(*available) + " of memory are free, and " +
         std::to_string(jobs) + (jobs == 1 ? " leg" : " legs at once") + " may take " +
         system::mebibytes(needed) + "; a leg that runs out of memory is void and played again" +
         (room > 0 ? "; with --jobs " + std::to_string(room) + " the memory always suffices" : "");
}

Runner::Runner(system::Files& files, LeagueStore store, ProgressReporter& progress)
    : files_(files), recorder_(files, std::move(store), progress), progress_(progress) {}

Result<int> Runner::run(const RunOptions& options) {
  options_ = options;
  MIROCUP_TRY_VOID(recorder_.start(options.jobs));
  const std::vector<int> cpus = system::processors();
  const int jobs = options.jobs > 0 ? options.jobs : static_cast<int>(cpus.size());
  workers_.resize(jobs);
  if (const std::string warning = memory_warning(system::available_memory(), jobs);
      !warning.empty()) {
    progress_.say(warning);
  }
  for (int i = 0; i < jobs; ++i) workers_[i].cpu = cpus[i % cpus.size()];

  bool is_asked_to_stop = false;
  while (true) {
    MIROCUP_TRY_VOID(recorder_.refresh());
    if (!is_asked_to_stop) {
      MIROCUP_TRY_VOID(fill_workers());
    }
    progress_.update(state().played(), state().legs(), playing());
    if (playing() == 0 && !is_asked_to_stop) return state().legs() - state().played();
    const auto exit = playing() > 0 ? processes_.wait() : std::nullopt;
    if (!exit && (is_asked_to_stop || playing() == 0)) {
      return tl::unexpected(interrupted_after(state()));
    }
    if (!exit) {
      is_asked_to_stop = true;
      progress_.say("stopping: " + std::to_string(playing()) +
                    " legs are being played to their end; interrupt again to stop at once");
      continue;
    }
    if (exit->tag == joiner_tag) continue;
    MIROCUP_TRY_VOID(finish(workers_[exit->tag], *exit));
  }
}

int Runner::playing() const {
  return static_cast<int>(
      std::ranges::count_if(workers_, &std::optional<LegId>::has_value, &Worker::playing));
}

bool Runner::is_taken(const std::string& id) const {
  return std::ranges::count(workers_, id, &Worker::fixture) > 0;
}

Result<void> Runner::fill_workers() {
  for (Worker& worker : workers_) MIROCUP_TRY_VOID(start_next_leg(worker));
  return {};
}

const FixtureState* Runner::next_fixture(const Worker& worker) const {
  // The legs of a fixture stay on one processor.
  const FixtureState* own = worker.fixture.empty() ? nullptr : recorder_.find(worker.fixture);
  if (own != nullptr && recorder_.next_leg(*own)) return own;
  const auto& fixtures = state().fixtures;
  for (std::size_t i = state().first_open(); i < fixtures.size(); ++i) {
    const std::string id = fixtures[i].fixture.id();
    if (recorder_.next_leg(fixtures[i]) && (id == worker.fixture || !is_taken(id)) &&
        may_play(worker, fixtures[i]))
      return &fixtures[i];
  }
  return nullptr;
}

// Programs that people start look for their match at the same addresses each time, so their legs
// are played one after the other, by the first worker.
bool Runner::may_play(const Worker& worker, const FixtureState& fixture) const {
  const auto& teams = state().file.teams;
  const bool waits_for_people = teams[fixture.fixture.home].is_started_by_people() ||
                                teams[fixture.fixture.away].is_started_by_people();
  return !waits_for_people || &worker == workers_.data();
}

void Runner::tell_people(const LegId& leg, int blue, int yellow) const {
  for (const int team : {blue, yellow}) {
    const TeamConfig& entry = state().file.teams[team];
    if (!entry.is_started_by_people()) continue;
    progress_.say(leg.fixture.id() + " leg " + std::to_string(leg.leg) + ": " + entry.name +
                  " plays " + (team == blue ? "blue" : "yellow") +
                  "; the leg waits for the team's program");
  }
}

// Starts the next leg of a free worker, if there is one.
Result<void> Runner::start_next_leg(Worker& worker) {
  while (!worker.playing) {
    const FixtureState* next = next_fixture(worker);
    worker.fixture.clear();
    if (next == nullptr) return {};
    worker.fixture = next->fixture.id();
    const LegId leg = *recorder_.next_leg(*next);
    // A shard may have played it, or an earlier run may have died before it booked it.
    if (checked_records_.insert(Folder::record_name(leg.fixture, leg.leg, leg.version)).second) {
      MIROCUP_TRY(const bool booked, recorder_.book_found(leg));
      if (booked) continue;
    }
    worker.playing = leg;
    MIROCUP_TRY_VOID(start_leg(worker));
  }
  return {};
}

// A league with credentials plays in secure mode.
void Runner::add_network(std::vector<std::string>& command, const std::string& whose) const {
  const std::string folder = recorder_.folder().credentials();
  if (files_.exists(folder + "/server"))
    command.insert(command.end(), {"--credentials", folder + "/" + whose});
  if (options_.dds_domain != 0)
    command.insert(command.end(), {"--dds-domain", std::to_string(options_.dds_domain)});
}

Result<void> Runner::start_leg(Worker& worker) {
  const LegId& leg = *worker.playing;
  const auto [blue, yellow] = leg.fixture.colours(leg.leg);
  // The id must be unique, because other leagues may play on this host at the same time, also a
  // copy of this one.
  const std::string folder = std::filesystem::absolute(recorder_.folder().path);
  const std::string match_id = system::sha256(folder + state().config_sha256).substr(0, 12) + "-" +
                               worker.fixture + "-" + std::to_string(leg.leg);
  const int tag = static_cast<int>(&worker - workers_.data());
  auto command = leg_command(recorder_.folder(), state(), leg, match_id);
  add_network(command, "server");
  const auto& teams = state().file.teams;
  if (options_.nat && (teams[blue].over_dds || teams[yellow].over_dds)) command.push_back("--nat");
  command.insert(command.end(), {"--answer", leg_answer(recorder_.folder(), leg)});
  if (options_.watched) {
    command.insert(command.end(), {"--watch", "127.0.0.1:0"});
    if (!teams[blue].lives_by_the_clock() && !teams[yellow].lives_by_the_clock())
      command.insert(command.end(), {"--speed", "max"});
  }
  tell_people(leg, blue, yellow);
  MIROCUP_TRY_VOID(processes_.start(command, tag, worker.cpu, leg_output(recorder_.folder(), leg)));
  MIROCUP_TRY_VOID(start_joiner(worker, blue, "blue", match_id));
  return start_joiner(worker, yellow, "yellow", match_id);
}

Result<void> Runner::start_joiner(Worker& worker, int team, const std::string& colour,
                                  const std::string& match_id) {
  const TeamConfig& entry = state().file.teams[team];
  if (!entry.over_dds) return {};
  const LegId& leg = *worker.playing;
  const std::string log =
      recorder_.folder().record(leg.fixture, leg.leg, leg.version) + "." + colour + ".join";
  std::vector<std::string> command{system::sibling_program("mirocup"), "join"};
  command.insert(command.end(), {"--match", match_id, "--team", colour, "--name", entry.name});
  command.push_back(recorder_.folder().library(entry.name, state().teams[team].entry));
  const auto parameters = record::parameter_options(entry.parameters, "--param");
  command.insert(command.end(), parameters.begin(), parameters.end());
  add_network(command, "teams/" + entry.name);
  MIROCUP_TRY(const auto pid, processes_.start(command, joiner_tag, worker.cpu, log));
  worker.joiner[colour == "blue" ? 0 : 1] = pid;
  return {};
}

Result<void> Runner::finish(Worker& worker, const system::Exit& exit) {
  for (pid_t& joiner : worker.joiner) {
    if (joiner != 0) processes_.kill(joiner);
    joiner = 0;
  }
  const LegId leg = *worker.playing;
  worker.playing.reset();
  const std::string record = recorder_.folder().record(leg.fixture, leg.leg, leg.version);
  const bool has_failed = exit.signal != 0 || exit.code != exit_yes;
  const std::string path = leg_answer(recorder_.folder(), leg);
  const Json answer = record::last_answer(files_, path).value_or(Json());
  (void)files_.remove(path);
  if (has_failed && is_disk_full(recorder_.folder().path, answer)) {
    // Another attempt would fail as well, and so would the journal's next line.
    return fail(Errc::unavailable,
                "the disk is full: " + std::to_string(state().played()) + " of " +
                    std::to_string(state().legs()) +
                    " legs are played; make room, then the same command continues");
  }
  if (exit.signal != 0) {
    return recorder_.book_void(leg,
                               "the match server died of signal " + std::to_string(exit.signal));
  }
  if (exit.code != exit_yes) return recorder_.book_void(leg, recorder_.last_output_line(leg));
  MIROCUP_TRY(const auto booked, recorder_.book_own(leg));
  if (booked) return {};
  return recorder_.book_void(leg, record + " is not there, or is not the record of this leg");
}

}  // namespace mirocup::league
