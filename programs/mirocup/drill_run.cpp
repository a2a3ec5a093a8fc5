// SPDX-License-Identifier: MIT
#include "programs/mirocup/drill_run.hpp"

#include "plugins/host/sandbox/probe.hpp"
#include "system/interrupt.hpp"
#include "system/process_set.hpp"
#include "web/page.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <thread>

namespace mirocup::app {

namespace {

// A try that the host has spoiled is played again, so often at most.
constexpr int max_attempts = 3;

constexpr std::chrono::milliseconds between_polls{20};

// Two teams that share the robots of one: both are asked, and each steers its own.
class SharedTeam final : public match::Controller {
 public:
  SharedTeam(match::Controller& tested, match::Controller& mates, referee::RobotSet robots)
      : tested_(tested), mates_(mates), robots_(robots) {}

  void post(const match::Observation& observation) override {
    tested_.post(observation);
    mates_.post(observation);
  }

  match::Answer collect() override {
    match::Answer answer = tested_.collect();
    const match::Answer others = mates_.collect();
    auto* command = std::get_if<match::Command>(&answer);
    if (command == nullptr) return answer;
    const auto* helping = std::get_if<match::Command>(&others);
    for (std::size_t i = 0; i < command->wheels.size(); ++i) {
      if (robots_[i]) continue;
      command->wheels[i] = helping != nullptr ? helping->wheels[i] : simulator::WheelSpeeds{};
    }
    return answer;
  }

 private:
  match::Controller& tested_;
  match::Controller& mates_;
  referee::RobotSet robots_;
};

// The leg of one try with its teams.
class Try {
 public:
  Try(const DrillTask& task, const match::Setup& setup, plugins::Isolation isolation)
      : task_(task), match_(setup) {
    terms_.isolation = isolation;
    mates_terms_.isolation = isolation;
  }

  Result<void> seat_teams() {
    MIROCUP_TRY_VOID(seat(task_.teams.tested, drills::tested, terms_));
    const Team opponent = opponent_of(drills::tested);
    MIROCUP_TRY_VOID(seat(task_.teams.opponent, opponent, terms_));
    if (!task_.teams.mates) return {};
    return seat(*task_.teams.mates, drills::tested, mates_terms_);
  }

  // Plays until the try is decided. Returns false if the host has failed.
  bool play() {
    server::wait_until_ready(seats_, match_, nullptr);  // signals are left to the main thread
    if (!match_.is_over() && seats_.size() > 2) {
      if (!seats_[2].wait_until_ready()) return false;
      shared_ = std::make_unique<SharedTeam>(seats_[0].controller(), seats_[2].controller(),
                                             task_.drill->robots);
    }
    drills::Judge judge(*task_.drill, match_);
    bool goes_on = !match_.is_over();
    while (goes_on) {
      advance();
      goes_on = judge.follow();
    }
    result_ = judge.result();
    const bool has_lost = !fault().empty();
    if (has_lost) result_ = {.passed = false, .marks = 0.0, .seconds = 0.0, .why = fault()};
    return !(match_.is_over() && match_.outcome().kind == match::OutcomeKind::void_);
  }

  // Plays the rest of the leg, so that there is a record of a whole one.
  void play_on() {
    while (!match_.is_over()) advance();
  }

  const drills::TryResult& result() const { return result_; }

  std::string fault() const {
    if (!match_.is_over()) return "";
    for (const match::TeamFault& fault : match_.outcome().faults) {
      if (fault.team != drills::tested) continue;
      return fault_text(fault.fault);
    }
    return "";
  }

  const match::Leg& leg() const { return match_; }

  Result<void> save(const std::string& path) const {
    record::MatchRecord record;
    record.software = record::this_software();
    record.isolation = to_string(terms_.isolation);
    for (const Team team : both_teams) {
      const int i = index_of(team);
      record.teams[i] = seats_[i].info();
      record.budget[i] = seats_[i].budget_report();
      record.budget[i].late_ticks = match_.late_ticks()[i];
      record.budget[i].bad_commands = match_.bad_values()[i];
    }
    record.recording = replay::record(match_, trace_);
    system::Disk disk;
    MIROCUP_TRY_VOID(record::save(disk, path, record));
    const auto page = web::replay_page(record, web::Times::left_out);
    if (!page) return fail(Errc::host, path + ": it cannot be shown: " + page.error().what);
    const std::string shown = std::filesystem::path(path).replace_extension(".html");
    return disk.write(shown, page->html);
  }

 private:
  Result<void> seat(const server::TeamChoice& choice, Team team,
                    const plugins::ProcessTerms& terms) {
    MIROCUP_TRY(auto seat, server::TeamSeat::take_in_process(choice, match_.briefing(team), terms));
    seats_.push_back(std::move(seat));
    return {};
  }

  match::Controller& blue() { return shared_ ? *shared_ : seats_[0].controller(); }
  void advance() {
    match_.advance(blue(), seats_[1].controller());
    trace_.add(match_);
  }

  const DrillTask& task_;
  match::Leg match_;
  plugins::ProcessTerms terms_;
  plugins::ProcessTerms mates_terms_;
  std::vector<server::TeamSeat> seats_;  // tested, opponent, mates
  std::unique_ptr<SharedTeam> shared_;
  replay::StateTrace trace_;
  drills::TryResult result_;
};

Result<PlayedTry> play_one(const DrillTask& task, std::uint64_t seed, const DrillTerms& terms,
                           plugins::Isolation isolation) {
  MIROCUP_TRY(const auto setup, drills::setup_of(*task.drill, seed));
  std::string why_void;
  for (int attempt = 0; attempt < max_attempts; ++attempt) {
    Try one(task, setup, isolation);
    MIROCUP_TRY_VOID(one.seat_teams());
    if (!one.play()) {
      why_void = one.leg().is_over() ? one.leg().outcome().why_void
                                     : "the mates of the tested team cannot play";
      continue;
    }
    PlayedTry played{.seed = seed, .result = one.result(), .fault = one.fault()};
    if (!terms.replay_folder.empty() && !played.result.passed) {
      one.play_on();
      const std::string name = task.teams.tested.info.name + "-" + task.drill->name + "-" +
                               std::to_string(seed) + ".json";
      const auto path = std::filesystem::path(terms.replay_folder) / name;
      MIROCUP_TRY_VOID(one.save(path.string()));
    }
    return played;
  }
  return fail(Errc::host, task.drill->name + ", seed " + std::to_string(seed) + ": " + why_void);
}

}  // namespace

std::string fault_text(const match::Fault& fault) {
  return std::string(to_string(fault.code)) + ": " + fault.text;
}

Result<std::vector<std::vector<PlayedTry>>> play_drills(const std::vector<DrillTask>& tasks,
                                                        const DrillTerms& terms,
                                                        const std::function<void(int)>& progress) {
  MIROCUP_TRY(const auto isolation, plugins::strongest_isolation());
  std::vector<std::vector<PlayedTry>> played;
  std::vector<std::pair<std::size_t, std::size_t>> order;  // of the tries: task and number
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    played.emplace_back(static_cast<std::size_t>(tasks[task].tries));
    for (std::size_t i = 0; i < played[task].size(); ++i) order.emplace_back(task, i);
  }
  system::Interrupt interrupt;  // before the threads, which then leave the signals to this one
  const std::vector<int> processors = system::processors();
  const std::size_t wanted =
      terms.jobs > 0 ? static_cast<std::size_t>(terms.jobs) : processors.size();
  const std::size_t jobs = std::min(wanted, order.size());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::atomic<std::size_t> working{jobs};
  std::mutex mutex;
  std::optional<Error> error;  // the first one
  const auto stop = [&](Error why) {
    const std::lock_guard lock(mutex);
    if (!error) error = std::move(why);
    next = order.size();
  };
  const auto work = [&](std::size_t worker) {
    // A leg and its teams take turns, so they share a processor (server::stay_on_this_core()).
    const int own = processors[worker % processors.size()];
    if (own >= 0) system::stay_on(own);
    for (std::size_t at = next++; at < order.size(); at = next++, ++done) {
      const auto [task, number] = order[at];
      auto one = play_one(tasks[task], terms.first_seed + number, terms, isolation);
      if (one)
        played[task][number] = std::move(*one);
      else
        stop(one.error());
    }
    --working;
  };
  std::vector<std::jthread> crew;
  for (std::size_t i = 0; i < jobs; ++i) crew.emplace_back(work, i);
  while (working > 0) {
    std::this_thread::sleep_for(between_polls);
    if (interrupt.is_asked_for()) stop(Error{Errc::interrupted, "interrupted"});
    progress(static_cast<int>(done));
  }
  crew.clear();
  if (error) return tl::unexpected(*error);
  return played;
}

}  // namespace mirocup::app
