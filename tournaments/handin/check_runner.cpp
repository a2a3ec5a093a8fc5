// SPDX-License-Identifier: MIT
#include "tournaments/handin/check_runner.hpp"

#include "server/record/json_reader.hpp"
#include "system/clock.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "tournaments/league/submission.hpp"

#include <csignal>
#include <iostream>
#include <sys/resource.h>

namespace mirocup::league {

namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr double wait_s = 0.02;        // s until a new hand-in is noticed
constexpr auto look_interval = 250ms;  // between two looks at the steps of checks
constexpr auto most_time = 180s;       // of a check, which takes 20 s of a processor at most
constexpr auto rest_time = 1s;         // after a fault of the host
constexpr int lower_priority = 10;     // pages and matches come first

}  // namespace

CheckRunner::CheckRunner(system::Files& files, Folder folder, Portal& portal,
                         system::ProcessSet& processes, int jobs,
                         std::function<void(const std::string& line)> tell)
    : files_(files),
      folder_(std::move(folder)),
      portal_(portal),
      processes_(processes),
      jobs_(jobs),
      tell_(std::move(tell)),
      friendlies_(folder_, portal.friendlies(), processes) {}

std::string CheckRunner::output_of(const WaitingHandIn& handed) const {
  return folder_.entry(handed.team, handed.entry) + "/answer.log";
}

bool CheckRunner::step() {
  start_checks();
  // Friendlies take what the checks leave.
  while (busy() < jobs_ && friendlies_.start_next(next_tag_, system::now_s())) ++next_tag_;
  look_at_steps();
  friendlies_.look_at_time();
  const auto news = processes_.wait_within(wait_s);
  if (news.exit) {
    if (const auto ended = running_.find(news.exit->tag); ended != running_.end()) {
      const Running check = std::move(ended->second);
      running_.erase(ended);
      start_checks();  // a processor does not wait for the disk
      book(check, *news.exit);
    } else {
      friendlies_.book(*news.exit, system::now_s());
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
  // The name of the file is a stranger's: one argument with its option, so it cannot be an option.
  const std::vector<std::string> command{system::sibling_program("mirocup-league"),
                                         "check-hand-in",
                                         folder_.path,
                                         next->team,
                                         std::to_string(next->entry),
                                         "--file=" + next->file,
                                         "--at=" + std::to_string(next->at)};
  const auto pid = processes_.start(command, next_tag_, -1, output_of(*next));
  if (!pid) {
    tell_(next->team + ": entry " + std::to_string(next->entry) + ": " + pid.error().what);
    rests_until_ = steady_clock::now() + rest_time;
    (void)portal_.wait_again(next->team, next->entry);
    return;
  }
  running_[next_tag_++] = {*next, *pid, steady_clock::now()};
}

void CheckRunner::book(const Running& check, const system::Exit& exit) {
  const std::string& team = check.handed.team;
  const int entry = check.handed.entry;
  const std::string path = output_of(check.handed);
  const auto said = files_.read(path, {.max_size = system::size_limit::log});
  const std::string output = said ? *said : said.error().what;
  const std::size_t end = output.find_last_not_of('\n');
  const std::size_t begin = end == std::string::npos ? end : output.rfind('\n', end);
  const record::ParsedJson answer = record::parse_json(
      std::string_view(output).substr(begin == std::string::npos ? 0 : begin + 1));
  const bool is_answer = exit.signal == 0 && (exit.code == exit_yes || exit.code == exit_no) &&
                         !answer.problem && answer.value.is_object();
  Result<void> booked;
  if (is_answer) {
    const std::string message = answer.value.value("message", "");
    tell_(message);
    booked = portal_.close(
        team, entry, exit.code == exit_yes ? HandInState::accepted : HandInState::refused, message);
  } else {
    constexpr std::size_t enough = 500;  // bytes
    tell_(team + ": entry " + std::to_string(entry) + ": its check ended with " +
          (exit.signal != 0 ? "signal " + std::to_string(exit.signal)
                            : "code " + std::to_string(exit.code)) +
          " " + output.substr(0, enough));
    rests_until_ = steady_clock::now() + (exit.signal != 0 ? 0s : rest_time);
    booked = portal_.wait_again(team, entry);
  }
  if (!booked) {
    tell_(booked.error().what);
    rests_until_ = steady_clock::now() + rest_time;
  }
  (void)files_.remove(path);
}

void CheckRunner::look_at_steps() {
  const auto now = steady_clock::now();
  if (now - steps_read_at_ < look_interval) return;
  steps_read_at_ = now;
  for (const auto& [tag, check] : running_) {
    const auto output =
        files_.read(folder_.check_log(check.handed.team, check.handed.entry),
                    {.max_size = system::size_limit::log, .growth = system::Growth::ignored});
    if (output) portal_.set_step(check.handed.team, check.handed.entry, last_step(*output));
    // It is told to have failed when its end is noticed.
    if (now - check.begun > most_time) ::kill(check.pid, SIGKILL);
  }
}

Result<int> check_hand_in(system::Files& files, const Folder& folder, const std::string& team,
                          int entry, const std::string& file, std::int64_t at) {
  setpriority(PRIO_PROCESS, 0, lower_priority);
  HandIn handed;
  handed.team = team;
  handed.path = folder.library(team, entry);
  handed.at = at;
  handed.entry = entry;
  handed.name = file;
  const SourceKind kind = source_kind_of(file);
  if (kind != SourceKind::none) handed.source = folder.source(team, entry);
  handed.language = language_of(kind);
  const auto done = submit(files, folder, handed);
  if (!done) return tl::unexpected(done.error());
  // An entry that was not even looked at needs no bytes.
  if (done->entry == 0) {
    (void)files.remove(handed.path);
    (void)files.remove(folder.source(team, entry));
  }
  std::cout << '\n'
            << record::json_text({{"accepted", done->is_accepted}, {"message", done->message}})
            << std::endl;
  return done->is_accepted ? exit_yes : exit_no;
}

}  // namespace mirocup::league
