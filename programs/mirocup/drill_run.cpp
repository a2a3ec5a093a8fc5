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
    MIROCUP_TRY_VOID(seat(task_.teams->tested, drills::tested, terms_));
    const Team opponent = opponent_of(drills::tested);
    MIROCUP_TRY_VOID(seat(task_.teams->opponent, opponent, terms_));
    if (!task_.teams->mates) return {};
    return seat(*task_.teams->mates, drills::tested, mates_terms_);
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

// A number of threads that take one try after the other.
class Crew {
 public:
  Crew(const std::vector<DrillTask>& tasks, const DrillTerms& terms, plugins::Isolation isolation)
      : tasks_(tasks), terms_(terms), isolation_(isolation) {
    for (std::size_t task = 0; task < tasks.size(); ++task) {
      played_.emplace_back(static_cast<std::size_t>(tasks[task].tries));
      for (int i = 0; i < tasks[task].tries; ++i) order_.push_back({task, i});
    }
  }

  Result<std::vector<std::vector<PlayedTry>>> play(const std::function<void(int)>& progress) {
    system::Interrupt interrupt;  // before the threads, which then leave the signals to this one
    const int processors = static_cast<int>(system::processors().size());
    const int jobs =
        std::min<int>(terms_.jobs > 0 ? terms_.jobs : processors, static_cast<int>(order_.size()));
    std::vector<std::thread> crew;
    working_ = jobs;
    for (int i = 0; i < jobs; ++i) crew.emplace_back([this, i] { work(i); });
    while (working_ > 0) {
      std::this_thread::sleep_for(between_polls);
      if (interrupt.is_asked_for()) stop(Error{Errc::interrupted, "interrupted"});
      progress(done_);
    }
    for (std::thread& worker : crew) worker.join();
    if (error_) return tl::unexpected(*error_);
    return std::move(played_);
  }

 private:
  struct Place {
    std::size_t task = 0;
    int number = 0;
  };

  void work(int worker) {
    // A leg and its teams take turns, so they share a processor (server::stay_on_this_core()).
    const std::vector<int> processors = system::processors();
    const int own = processors[static_cast<std::size_t>(worker) % processors.size()];
    if (own >= 0) system::stay_on(own);
    while (!is_stopped_) {
      const std::size_t at = next_++;
      if (at >= order_.size()) break;
      const Place place = order_[at];
      auto played = play_one(tasks_[place.task],
                             terms_.first_seed + static_cast<std::uint64_t>(place.number));
      if (!played) {
        stop(played.error());
        break;
      }
      played_[place.task][static_cast<std::size_t>(place.number)] = std::move(*played);
      ++done_;
    }
    --working_;
  }

  Result<PlayedTry> play_one(const DrillTask& task, std::uint64_t seed) const {
    MIROCUP_TRY(const auto setup, drills::setup_of(*task.drill, seed));
    std::string why_void;
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
      Try one(task, setup, isolation_);
      MIROCUP_TRY_VOID(one.seat_teams());
      if (!one.play()) {
        why_void = one.leg().is_over() ? one.leg().outcome().why_void
                                       : "the mates of the tested team cannot play";
        continue;
      }
      PlayedTry played{.seed = seed, .result = one.result(), .fault = one.fault()};
      if (!terms_.replay_folder.empty() && !played.result.passed) {
        one.play_on();
        const std::string name = task.teams->tested.info.name + "-" + task.drill->name + "-" +
                                 std::to_string(seed) + ".json";
        const auto path = std::filesystem::path(terms_.replay_folder) / name;
        MIROCUP_TRY_VOID(one.save(path.string()));
      }
      return played;
    }
    return fail(Errc::host, task.drill->name + ", seed " + std::to_string(seed) + ": " + why_void);
  }

  void stop(Error error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
    is_stopped_ = true;
  }

  const std::vector<DrillTask>& tasks_;
  const DrillTerms& terms_;
  plugins::Isolation isolation_;
  std::vector<Place> order_;
  std::vector<std::vector<PlayedTry>> played_;
  std::atomic<std::size_t> next_{0};
  std::atomic<int> done_{0};
  std::atomic<int> working_{0};
  std::atomic<bool> is_stopped_{false};
  std::mutex mutex_;
  std::optional<Error> error_;  // the first one; guarded by mutex_
};

}  // namespace

std::string fault_text(const match::Fault& fault) {
  return std::string(to_string(fault.code)) + ": " + fault.text;
}

Result<std::vector<std::vector<PlayedTry>>> play_drills(const std::vector<DrillTask>& tasks,
                                                        const DrillTerms& terms,
                                                        const std::function<void(int)>& progress) {
  MIROCUP_TRY(const auto isolation, plugins::strongest_isolation());
  Crew crew(tasks, terms, isolation);
  return crew.play(progress);
}

}  // namespace mirocup::app
