// SPDX-License-Identifier: MIT
#include "programs/coach/study.hpp"

#include "programs/coach/process_copy.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unistd.h>

namespace mirocup::coach {

namespace {

constexpr double stride_s = 0.3;
constexpr int counted_futures = 100;  // of a share that is told
constexpr int most_goals = 20;        // of these, if the goal can be prevented
constexpr int at_once = 3;            // futures; a clear test needs 3 or 12

// Runs `work` in a copy and waits. Of a copy's copies: without their answer it has none either.
template <class Work>
auto in_a_copy(Work&& work) {
  const auto answer = Copy(work).wait();
  if (!answer) _exit(1);
  return *answer;
}

// The search for the last moments before one goal, from where a rehearsal stands. Everything that
// moves the rehearsal runs in a copy of the process.
class GoalSearch {
 public:
  GoalSearch(Rehearsal& rehearsal, Team team, std::uint32_t goal)
      : rehearsal_(rehearsal),
        team_(team),
        goal_(goal),
        ends_(static_cast<std::size_t>(rehearsal.leg().field().robots_per_team), goal) {}

  // A test may err about one of the many ticks that it is asked about: other futures confirm it.
  std::optional<Prevention> last_prevention(std::uint32_t first) {
    while (const auto latest = latest_yes(Question::prevention, first)) {
      const Prevention found = in_a_copy([&] { return with_facts(*latest); });
      if (is_confirmed(found)) return found;
      ends_[static_cast<std::size_t>(found.robot)] = found.tick;
    }
    return std::nullopt;
  }

  // Returns the first tick from `first` on after which no robot has hope.
  std::uint32_t hopeless_from(std::uint32_t first) {
    std::fill(ends_.begin(), ends_.end(), goal_);
    const auto latest = latest_yes(Question::hope, first);
    return latest ? latest->tick + 1 : first;
  }

 private:
  // Plays futures of the present tick from a number on, some at once, and counts them in the order
  // of their numbers until `is_enough` says so of their share.
  template <class IsEnough>
  Share count(int number, std::optional<int> robot, IsEnough is_enough) {
    Share share;
    for (; !is_enough(share); number += at_once) {
      std::vector<Copy<bool>> futures;
      for (int i = 0; i < at_once; ++i)
        futures.emplace_back([&] { return rehearsal_.is_without_goal(goal_, robot, number + i); });
      for (Copy<bool>& future : futures) {
        const auto is_without_goal = future.wait();
        if (!is_without_goal) _exit(1);
        if (!is_enough(share)) share.add(*is_without_goal);
      }
    }
    return share;
  }

  static bool is_confirmed(const Prevention& found) {
    return found.share.value() >= limit_of(Question::prevention);
  }

  // These two run in a copy, which they bring to the tick.
  bool test(std::uint32_t tick, int robot, Question question) {
    rehearsal_.follow(tick);
    const auto answer = [question](const Share& share) { return answer_of(question, share); };
    return *answer(count(0, robot, answer));
  }
  Prevention with_facts(Prevention found) {
    rehearsal_.follow(found.tick);
    const match::Leg& leg = rehearsal_.leg();
    const Vec2 ball = leg.ball().position;
    found.to_ball = (leg.robot(team_, found.robot).position - ball).norm();
    found.ball = team_frame(leg.end_of(team_), ball);
    const auto are_all = [](const Share& share) { return share.futures == counted_futures; };
    found.share = count(first_counted, found.robot, [&](const Share& share) {
      return are_all(share) || share.futures - share.without > most_goals;
    });
    if (is_confirmed(found)) found.as_played = count(first_counted, std::nullopt, are_all);
    return found;
  }

  // Returns robot and tick of the latest moment with a yes; of two robots with the same moment the
  // one with the lower number. A robot is asked about moments before its end. Goes back for all
  // robots together, so that none is asked about moments long before that of another.
  std::optional<Prevention> latest_yes(Question question, std::uint32_t first) {
    const std::uint32_t stride = ticks_of(stride_s, rehearsal_.leg());
    std::optional<Prevention> latest;
    if (first >= goal_) return latest;
    for (std::uint32_t from = goal_ - 1;; from -= std::min(stride, from - first)) {
      for (int robot = 0; robot < static_cast<int>(ends_.size()); ++robot) {
        const auto tick =
            last_yes(latest ? latest->tick + 1 : from, ends_[static_cast<std::size_t>(robot)],
                     stride, [&](std::uint32_t asked) { return answer(question, robot, asked); });
        if (tick) latest = Prevention{.robot = robot, .tick = *tick};
      }
      if (latest || from == first) return latest;
    }
  }

  bool answer(Question question, int robot, std::uint32_t tick) {
    const auto [known, is_new] = answers_.try_emplace({question, robot, tick});
    if (is_new) known->second = in_a_copy([&] { return test(tick, robot, question); });
    return known->second;
  }

  Rehearsal& rehearsal_;
  Team team_;
  std::uint32_t goal_;
  std::vector<std::uint32_t> ends_;  // for each robot, the tick before which moments are sought
  std::map<std::tuple<Question, int, std::uint32_t>, bool> answers_;  // of tests
};

}  // namespace

std::vector<match::LoggedDecision> goals_against(const replay::Recording& recording, Team team) {
  std::vector<match::LoggedDecision> goals;
  for (const match::LoggedDecision& d : recording.decisions) {
    if (d.decision.verdict == referee::Verdict::GOAL && d.team == opponent_of(team))
      goals.push_back(d);
  }
  return goals;
}

Result<std::vector<GoalStudy>> study_goals(const record::MatchRecord& record, const Cast& cast,
                                           std::optional<int> only) {
  MIROCUP_TRY(const auto rehearsal, Rehearsal::begin(record, cast));
  const match::Leg& leg = rehearsal->leg();
  std::vector<GoalStudy> goals;
  int number = 0;
  for (const match::LoggedDecision& goal : goals_against(record.recording, cast.team)) {
    ++number;
    if (only && *only != number) continue;
    rehearsal->go_before(goal.tick);
    GoalSearch search(*rehearsal, cast.team, goal.tick);
    GoalStudy study{.number = number,
                    .tick = goal.tick,
                    .clock = {leg.referee().phase(), goal.decision.clock},
                    .first = leg.tick(),
                    .prevention = {},
                    .hopeless = 0,
                    .decides = {rehearsal->decides(Team::blue), rehearsal->decides(Team::yellow)}};
    const auto found = Copy([&] {
                         study.prevention = search.last_prevention(study.first);
                         study.hopeless = search.hopeless_from(
                             study.prevention ? study.prevention->tick + 1 : study.first);
                         return study;
                       }).wait();
    if (!found)
      return fail(Errc::host, "a copy of this process, which played futures, did not end");
    goals.push_back(*found);
  }
  return goals;
}

}  // namespace mirocup::coach
