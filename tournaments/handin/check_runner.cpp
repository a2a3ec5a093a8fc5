// SPDX-License-Identifier: MIT
#include "tournaments/handin/check_runner.hpp"

#include "record/answer.hpp"
#include "system/locations.hpp"
#include "system/process_tree.hpp"

#include <algorithm>
#include <csignal>

namespace mirocup::league {

namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr double wait_s = 0.02;        // s until a new hand-in is noticed
constexpr auto look_interval = 250ms;  // between two looks at the checks
constexpr auto rest_time = 1s;         // after a fault of the host

}  // namespace

CheckRunner::CheckRunner(system::Files& files, Folder folder, Portal& portal,
                         system::ProcessSet& processes, int jobs,
                         std::function<void(const std::string& line)> tell,
                         const CheckLimits& limits)
    : files_(files),
      folder_(std::move(folder)),
      portal_(portal),
      processes_(processes),
      jobs_(jobs),
      tell_(std::move(tell)),
      limits_(limits),
      friendlies_(folder_, portal.friendlies(), processes) {}

std::string CheckRunner::log_of(const HandedIn& handed) const {
  return folder_.entry(handed.team, handed.entry) + "/checking.log";
}

bool CheckRunner::step() {
  start_checks();
  // Friendlies take what the checks leave.
  while (busy() < jobs_ && friendlies_.start_next(next_tag_)) ++next_tag_;
  look_at_checks();
  friendlies_.look_at_time();
  const auto news = processes_.wait_within(wait_s);
  if (news.exit) {
    if (const auto ended = running_.find(news.exit->tag); ended != running_.end()) {
      const Running check = std::move(ended->second);
      running_.erase(ended);
      start_checks();  // a processor does not wait for the disk
      book(check, *news.exit);
    } else {
      friendlies_.book(*news.exit);
    }
  }
  return !news.is_asked_to_stop;
}

void CheckRunner::start_checks() {
  while (busy() < jobs_ && steady_clock::now() >= rests_until_) {
    const std::size_t before = running_.size();
    start_next();
    if (running_.size() == before) break;
  }
}

void CheckRunner::start_next() {
  const auto next = portal_.begin_next();
  if (!next) return;
  const bool is_source = source_kind_of(next->file) != SourceKind::none;
  const int compile_seconds = compile_time_.of(next->team);
  // The name of the file is a stranger's: one argument with its option, so it cannot be an option.
  const std::vector<std::string> command{system::sibling_program("mirocup-league"),
                                         "check-hand-in",
                                         folder_.path,
                                         next->team,
                                         std::to_string(next->entry),
                                         "--file=" + next->file,
                                         "--compile-seconds=" + std::to_string(compile_seconds)};
  const auto pid = processes_.start(command, next_tag_, -1, log_of(*next));
  if (!pid) {
    tell_(next->team + ": entry " + std::to_string(next->entry) + ": " + pid.error().what);
    rests_until_ = steady_clock::now() + rest_time;
    (void)portal_.wait_again(next->team, next->entry);
    return;
  }
  running_[next_tag_++] = {.handed = *next,
                           .pid = *pid,
                           .begun = steady_clock::now(),
                           .compile_seconds = is_source ? compile_seconds : 0,
                           .used = {.team = next->team, .entry = next->entry}};
}

void CheckRunner::book(const Running& check, const system::Exit& exit) {
  const std::string& team = check.handed.team;
  const std::string log = log_of(check.handed);
  Result<void> booked;
  if (exit.signal == 0 && (exit.code == exit_yes || exit.code == exit_no)) {
    if (check.compile_seconds > 0)
      compile_time_.note(team, exit.code == exit_yes || check.is_compiled, check.used.processor);
    booked = portal_.conclude(team, check.handed.entry).map([this](const Submission& done) {
      tell_(done.message);
    });
  } else {
    const auto said = files_.read(log, {.max_size = system::size_limit::log});
    booked = book_no_answer(check, exit, said ? *said : said.error().what);
  }
  if (!booked) {
    tell_(booked.error().what);
    rests_until_ = steady_clock::now() + rest_time;
  }
  (void)files_.remove(log);
}

Result<void> CheckRunner::book_no_answer(const Running& check, const system::Exit& exit,
                                         const std::string& said) {
  const std::string& team = check.handed.team;
  const int entry = check.handed.entry;
  const std::string name = team + ": entry " + std::to_string(entry) + ": ";
  const double most = most_processor(check);
  if (check.stopped == NoAnswer::spent) {
    tell_(name + "its check was stopped after " + std::to_string(static_cast<int>(most)) +
          " s of processor time");
  } else if (check.stopped) {
    tell_(name + "its check gives way to the check of another team");
  } else {
    constexpr std::size_t enough = 500;  // bytes
    tell_(name + "its check ended with " +
          (exit.signal != 0 ? "signal " + std::to_string(exit.signal)
                            : "code " + std::to_string(exit.code)) +
          " " + said.substr(0, enough));
    rests_until_ = steady_clock::now() + (exit.signal != 0 ? 0s : rest_time);
  }
  return portal_.wait_again(team, entry, check.stopped.value_or(NoAnswer::host_failed), most);
}

void CheckRunner::look_at_checks() {
  const auto now = steady_clock::now();
  if (now - last_look_ < look_interval) return;
  const double since_last = std::chrono::duration<double>(now - last_look_).count();
  last_look_ = now;
  std::vector<pid_t> pids;
  for (const auto& [tag, check] : running_) pids.push_back(check.pid);
  const auto used = pids.empty() ? std::map<pid_t, system::TreeUse>() : system::use_of_trees(pids);
  std::vector<RunningCheck> uses;
  for (auto& [tag, check] : running_) {
    const std::string& team = check.handed.team;
    const int entry = check.handed.entry;
    const auto answer = record::last_answer(files_, folder_.check_answer(team, entry));
    if (const auto step = answer ? step_in(*answer) : std::nullopt) {
      check.is_compiled = true;
      portal_.set_step(team, entry, *step);
    }
    const system::TreeUse& use = used.at(check.pid);
    check.used.processor = std::max(check.used.processor, use.seconds);
    const double clock = std::chrono::duration<double>(now - check.begun).count();
    if (!use.is_runnable) check.used.asleep += std::min(since_last, clock);
    if (check.used.processor > most_processor(check)) check.stopped = NoAnswer::spent;
    // It is booked when its end is noticed.
    if (check.stopped || clock > limits_.clock) ::kill(check.pid, SIGKILL);
    uses.push_back(check.used);
  }
  if (busy() >= jobs_) make_room(uses);
}

// Stops one check or friendly, if a hand-in waits that may begin.
void CheckRunner::make_room(const std::vector<RunningCheck>& uses) {
  const bool is_stopping =
      std::ranges::any_of(running_, [](const auto& one) { return one.second.stopped.has_value(); });
  if (is_stopping || !portal_.has_next() || friendlies_.give_way()) return;
  const auto stopped = portal_.to_stop(uses);
  if (!stopped) return;
  for (auto& [tag, check] : running_) {
    if (check.handed.team != stopped->team || check.handed.entry != stopped->entry) continue;
    check.stopped = NoAnswer::gave_way;
    ::kill(check.pid, SIGKILL);
  }
}

}  // namespace mirocup::league
