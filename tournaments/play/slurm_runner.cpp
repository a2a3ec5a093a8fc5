// SPDX-License-Identifier: MIT
#include "tournaments/play/slurm_runner.hpp"

#include "system/digest.hpp"
#include "system/locations.hpp"
#include "tournaments/play/shard.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace mirocup::league {

namespace {

constexpr double poll_interval_s = 2.0;

// Several tasks per processor keep the cost of a lost task and of a slow one low. By default Slurm
// takes arrays of up to 1000 tasks (MaxArraySize).
constexpr int tasks_per_processor = 4;
constexpr int max_array_tasks = 1000;

// Arguments: mirocup-league, the league's folder, the plan.
constexpr std::string_view script =
    "#!/bin/sh\n"
    "# Plays the fixtures in the line of the plan that is this task's.\n"
    "exec \"$1\" run-shard \"$2\" $(sed -n \"${SLURM_ARRAY_TASK_ID}p\" \"$3\")\n";

bool holds(const std::vector<SlurmTask>& tasks, const SlurmTask& task) {
  return std::ranges::count(tasks, task.id, &SlurmTask::id) > 0;
}

std::vector<std::string> ids_of(const std::vector<SlurmTask>& tasks) {
  std::vector<std::string> ids;
  for (const SlurmTask& task : tasks) ids.push_back(task.id);
  return ids;
}

}  // namespace

SlurmRunner::SlurmRunner(system::Files& files, LeagueStore store, ProgressReporter& progress)
    : files_(files), recorder_(files, std::move(store), progress), progress_(progress) {}

Result<int> SlurmRunner::run(int jobs) {
  MIROCUP_TRY_VOID(prepare(jobs));
  int answered = 0;  // interrupts
  while (true) {
    const std::vector<SlurmTask> before = tasks_;
    const bool is_known = poll_queue();
    MIROCUP_TRY_VOID(book_after(before, is_known));
    if (is_known) {
      MIROCUP_TRY(const auto fixtures, unqueued_fixtures());
      if (interrupts_ == 0) {
        MIROCUP_TRY_VOID(submit(fixtures));
      }
    }
    progress_.update(state().played(), state().legs(), running());
    if (is_known && tasks_.empty()) {
      if (interrupts_ > 0) return tl::unexpected(interrupted_after(state()));
      return state().legs() - state().played();
    }
    if (processes_.is_asked_to_stop_within(poll_interval_s)) ++interrupts_;
    if (interrupts_ == answered) continue;
    answered = interrupts_;
    if (answered == 1) {
      drain();
      continue;
    }
    progress_.say("stopping at once");
    (void)run_slurm(scancel_command(ids_of(tasks_), CancelScope::all));
    return tl::unexpected(interrupted_after(state()));
  }
}

Result<void> SlurmRunner::prepare(int jobs) {
  MIROCUP_TRY_VOID(recorder_.start());
  const std::string path = std::filesystem::absolute(recorder_.folder().path).lexically_normal();
  folder_ = path + "/cluster";
  league_ = system::sha256(path + state().config_sha256).substr(0, 12);
  if (auto made = files_.make_folder(folder_); !made) return made;
  if (auto written = files_.write(folder_ + "/shard.sh", script); !written) return written;
  while (files_.exists(plan_path(next_plan_))) ++next_plan_;

  MIROCUP_TRY(const auto queue, run_slurm(squeue_command()));
  tasks_ = parse_queue(queue, league_);
  if (!tasks_.empty())
    progress_.say(std::to_string(tasks_.size()) + " tasks of this league are in the queue");
  jobs_ = jobs;
  if (jobs == 0) {
    MIROCUP_TRY(const auto nodes, run_slurm(sinfo_command()));
    jobs_ = std::max(1, parse_processors(nodes));
  }
  return {};
}

// Runs one of Slurm's programs to its end and returns its output.
Result<std::string> SlurmRunner::run_slurm(const CommandLine& command) {
  MIROCUP_TRY(auto answer,
              system::ask(command, {.seconds = 300.0, .bytes = system::size_limit::log}));
  if (answer.code == exit_yes) return std::move(answer.output);
  if (answer.code == system::not_found) {
    return fail(Errc::unavailable,
                command[0] + " is not there: is this a host of a Slurm cluster?");
  }
  return fail(Errc::unavailable,
              command[0] + ": " + answer.output.substr(0, answer.output.find('\n')));
}

// Reads the queue. False if squeue does not answer.
bool SlurmRunner::poll_queue() {
  const auto queue = run_slurm(squeue_command());
  if (!queue) {
    if (!is_silent_) progress_.say(queue.error().what + "; asking again");
    is_silent_ = true;
    return false;
  }
  is_silent_ = false;
  tasks_ = parse_queue(*queue, league_);
  return true;
}

// Books the records that are new since the last poll, and voids the legs of tasks that have ended
// without them. A task's records are written before it leaves the queue.
Result<void> SlurmRunner::book_after(const std::vector<SlurmTask>& before, bool is_known) {
  if (auto fresh = recorder_.refresh(); !fresh) return fresh;
  for (const SlurmTask& task : before) {
    const bool is_gone = is_known && !holds(tasks_, task);
    if (!is_gone && !task.is_running) continue;
    MIROCUP_TRY(const auto fixtures, fixtures_of(task));
    for (const std::string& fixture : fixtures) {
      MIROCUP_TRY_VOID(
          is_gone ? book_lost(fixture, "task " + task.id + " has ended without the leg's record")
                  : book_records(fixture));
    }
  }
  if (!is_known) return {};
  for (const SlurmTask& task : tasks_) {
    if (task.is_running || task.restarts <= restarts_[task.id]) continue;
    restarts_[task.id] = task.restarts;
    if (auto back = requeue(task); !back) return back;
  }
  return {};
}

Result<void> SlurmRunner::book_records(const std::string& fixture) {
  MIROCUP_TRY(const auto count, recorder_.book_played(fixture));
  if (count > 0) futile_submissions_ = 0;
  return {};
}

// Books the records of a fixture and voids the leg that was being played.
Result<void> SlurmRunner::book_lost(const std::string& fixture, const std::string& why) {
  if (auto booked = book_records(fixture); !booked) return booked;
  const FixtureState* now = recorder_.find(fixture);
  const auto leg = now != nullptr ? recorder_.next_leg(*now) : std::nullopt;
  if (!leg || !recorder_.has_begun(*leg)) return {};
  const std::string said = recorder_.last_output_line(*leg);
  return recorder_.book_void(*leg, why + (said.empty() ? "" : ": " + said));
}

Result<void> SlurmRunner::requeue(const SlurmTask& task) {
  MIROCUP_TRY(const auto fixtures, fixtures_of(task));
  for (const std::string& fixture : fixtures) {
    MIROCUP_TRY_VOID(book_lost(fixture, "task " + task.id + " has lost its node"));
  }
  // If this fails, the task starts after its delay.
  (void)run_slurm(start_now_command(task.id));
  return {};
}

// Returns the fixtures that can be played now, have legs without a record and are not in the queue.
Result<std::vector<std::string>> SlurmRunner::unqueued_fixtures() {
  std::set<std::string> covered;
  for (const SlurmTask& task : tasks_) {
    MIROCUP_TRY(const auto planned, fixtures_of(task));
    covered.insert(planned.begin(), planned.end());
  }
  std::vector<std::string> fixtures;
  for (const std::string& id : open_shards(state())) {
    if (covered.contains(id)) continue;
    MIROCUP_TRY_VOID(book_records(id));
    const FixtureState* now = recorder_.find(id);
    if (now != nullptr && recorder_.next_leg(*now)) fixtures.push_back(id);
  }
  return fixtures;
}

Result<void> SlurmRunner::submit(const std::vector<std::string>& fixtures) {
  if (fixtures.empty()) return {};
  if (futile_submissions_ < max_attempts) return submit_array(fixtures);
  if (!tasks_.empty()) return {};
  return fail(Errc::host, "the cluster plays nothing: " + std::to_string(futile_submissions_) +
                              " arrays of tasks have ended without a record; " + folder_ +
                              " has their logs");
}

Result<void> SlurmRunner::submit_array(const std::vector<std::string>& fixtures) {
  const int count = static_cast<int>(fixtures.size());
  const int max_tasks = std::min(max_array_tasks, tasks_per_processor * jobs_);
  const int per_task = (count + max_tasks - 1) / max_tasks;
  PlanLines lines;
  std::string text;
  for (int i = 0; i < count; ++i) {
    if (i % per_task == 0) lines.emplace_back();
    lines.back().push_back(fixtures[i]);
    text += fixtures[i] + ((i + 1) % per_task == 0 || i + 1 == count ? "\n" : " ");
  }
  const int plan = next_plan_++;
  const int tasks = static_cast<int>(lines.size());
  if (auto written = files_.write(plan_path(plan), text); !written) return written;
  MIROCUP_TRY(const auto job,
              run_slurm(sbatch_command(
                  {.league = league_,
                   .plan = plan,
                   .tasks = tasks,
                   .max_running = jobs_,
                   .log = folder_ + "/" + std::to_string(plan),
                   .shard = {folder_ + "/shard.sh", system::sibling_program("mirocup-league"),
                             std::filesystem::path(folder_).parent_path(), plan_path(plan)}})));
  ++futile_submissions_;
  plans_[plan] = std::move(lines);
  const std::string id = job.substr(0, job.find_first_of(";\n"));
  progress_.say("job " + id + ": " + std::to_string(count) + " fixtures in " +
                std::to_string(tasks) + " tasks");
  for (int i = 1; i <= tasks; ++i)
    tasks_.push_back({.id = id + "_" + std::to_string(i), .plan = plan, .line = i});
  return {};
}

// Cancels the pending tasks and lets the present legs come to their end. Tasks that cannot be
// cancelled play on, and the next start books their records.
void SlurmRunner::drain() {
  (void)run_slurm(scancel_command(ids_of(tasks_), CancelScope::pending));
  poll_queue();
  progress_.say("stopping: legs are being played to their end in " + std::to_string(running()) +
                " tasks; interrupt again to stop at once");
  if (running() > 0) (void)run_slurm(scancel_command(ids_of(tasks_), CancelScope::after_leg));
}

// A task whose plan cannot be read may be playing any fixture, so no other may be submitted.
Result<std::vector<std::string>> SlurmRunner::fixtures_of(const SlurmTask& task) {
  if (!plans_.contains(task.plan)) {
    MIROCUP_TRY(const auto plan,
                files_.read_if_there(plan_path(task.plan), {.max_size = system::size_limit::note}));
    PlanLines& lines = plans_[task.plan];
    std::istringstream text(plan.value_or(""));
    for (std::string line; std::getline(text, line);) {
      std::istringstream words(line);
      lines.emplace_back();
      for (std::string id; words >> id;) lines.back().push_back(id);
    }
  }
  const PlanLines& lines = plans_[task.plan];
  if (task.line < 1 || task.line > static_cast<int>(lines.size()))
    return std::vector<std::string>{};
  return lines[task.line - 1];
}

std::string SlurmRunner::plan_path(int number) const {
  return folder_ + "/" + std::to_string(number) + ".plan";
}

int SlurmRunner::running() const {
  return static_cast<int>(std::ranges::count(tasks_, true, &SlurmTask::is_running));
}

}  // namespace mirocup::league
