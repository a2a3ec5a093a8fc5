// SPDX-License-Identifier: MIT
#include "programs/coach/study.hpp"

#include "programs/coach/process_copy.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unistd.h>

namespace mirocup::coach {

namespace {

constexpr double stride_s = 0.3;
constexpr double after_goal_s = 1.0;
constexpr int counted_futures = 100;  // of a share that is told
constexpr int first_counted = 1000;   // their numbers; those of the tests are lower

// Sets the draws of futures apart from the other uses of a leg's seed.
constexpr std::uint64_t domain = 0x636f616368000000ULL;

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
 private:
  // Asks about all robots at once.
  template <class Work>
  auto of_each_robot(Work work) {
    const int robots = rehearsal_.leg().field().robots_per_team;
    using T = std::invoke_result_t<Work, int>;
    std::vector<Copy<T>> copies;
    for (int robot = 0; robot < robots; ++robot) copies.emplace_back([&] { return work(robot); });
    std::vector<T> answers;
    for (Copy<T>& copy : copies) {
      const auto answer = copy.wait();
      if (!answer) _exit(1);
      answers.push_back(*answer);
    }
    return answers;
  }

 public:
  GoalSearch(Rehearsal& rehearsal, Team team, std::uint32_t goal)
      : rehearsal_(rehearsal), team_(team), first_(rehearsal.leg().tick()), goal_(goal) {}

  std::optional<Prevention> last_prevention() {
    std::optional<Prevention> best;
    const auto rank = [](const Prevention& p) { return std::tuple(p.tick, p.share.without); };
    for (const auto& one : of_each_robot([&](int robot) { return last_prevention_by(robot); })) {
      if (one && (!best || rank(*one) > rank(*best))) best = one;
    }
    if (best) best->as_played = in_a_copy([&] { return count(best->tick, std::nullopt); });
    return best;
  }

  // Returns the first tick from `first` on after which no robot has hope.
  std::uint32_t hopeless_from(std::uint32_t first) {
    const auto last_hopes = of_each_robot([&](int robot) {
      const auto last = last_yes_of(robot, Question::hope, first, goal_);
      return last ? *last + 1 : first;
    });
    return *std::max_element(last_hopes.begin(), last_hopes.end());
  }

 private:
  std::uint32_t ticks_of(double seconds) const {
    return static_cast<std::uint32_t>(
        std::ceil(seconds / rehearsal_.leg().setup().control_period - 1e-9));
  }
  std::uint32_t end_of_goal() const { return goal_ + ticks_of(after_goal_s); }

  // Plays one future from where the rehearsal stands.
  bool play(std::optional<int> robot, int number) {
    const std::uint64_t seed = mix_seed(mix_seed(rehearsal_.leg().setup().seed ^ domain) + goal_);
    return rehearsal_.is_without_goal(
        robot, mix_seed(seed + static_cast<std::uint64_t>(number)),
        {.recorded_end = goal_,
         .end = std::max(rehearsal_.leg().tick() + ticks_of(studied_s), end_of_goal())});
  }

  // These two run in a copy, which they bring to the tick.
  bool test(std::uint32_t tick, int robot, Question question) {
    rehearsal_.follow(tick);
    SequentialTest test(question);
    while (!test.answer()) test.add(in_a_copy([&] { return play(robot, test.share().futures); }));
    return *test.answer();
  }
  Share count(std::uint32_t tick, std::optional<int> robot) {
    rehearsal_.follow(tick);
    Share share;
    for (; share.futures < counted_futures; ++share.futures)
      share.without += in_a_copy([&] { return play(robot, first_counted + share.futures); });
    return share;
  }

  std::optional<std::uint32_t> last_yes_of(int robot, Question question, std::uint32_t first,
                                           std::uint32_t end) {
    return last_yes(first, end, ticks_of(stride_s), [&](std::uint32_t tick) {
      return in_a_copy([&] { return test(tick, robot, question); });
    });
  }

  // A test may err about one of the many ticks that it is asked about: other futures confirm it.
  std::optional<Prevention> last_prevention_by(int robot) {
    std::uint32_t end = goal_;
    while (const auto tick = last_yes_of(robot, Question::prevention, first_, end)) {
      const Prevention found = in_a_copy([&] {
        const Share share = count(*tick, robot);
        const match::Leg& leg = rehearsal_.leg();
        const Vec2 ball = leg.ball().position;
        return Prevention{.robot = robot,
                          .tick = *tick,
                          .share = share,
                          .as_played = {},
                          .to_ball = (leg.robot(team_, robot).position - ball).norm(),
                          .ball = team_frame(leg.end_of(team_), ball)};
      });
      if (found.share.value() >= limit_of(Question::prevention)) return found;
      end = *tick;
    }
    return std::nullopt;
  }

  Rehearsal& rehearsal_;
  Team team_;
  std::uint32_t first_;
  std::uint32_t goal_;
};

// Brings the rehearsal to the moment at which the study of a goal begins: 3 s before it, but play
// has begun after the last restart.
void go_before(Rehearsal& rehearsal, const replay::Recording& recording, std::uint32_t goal) {
  const double window = std::ceil(studied_s / recording.setup.control_period - 1e-9);
  auto tick = static_cast<std::uint32_t>(std::max(goal - window, 0.0));
  for (const match::LoggedDecision& d : recording.decisions) {
    if (d.tick < goal && d.decision.restart != referee::Restart::none)
      tick = std::max(tick, d.tick + 1);
  }
  rehearsal.follow(tick);
  while (rehearsal.leg().state() != match::State::PLAY && rehearsal.leg().tick() < goal)
    rehearsal.follow(rehearsal.leg().tick() + 1);
}

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
  const Error failed{Errc::host, "a copy of this process, which played futures, did not end"};
  std::vector<GoalStudy> goals;
  int number = 0;
  for (const match::LoggedDecision& goal : goals_against(record.recording, cast.team)) {
    ++number;
    if (only && *only != number) continue;
    go_before(*rehearsal, record.recording, goal.tick);
    GoalSearch search(*rehearsal, cast.team, goal.tick);
    GoalStudy study{.number = number,
                    .tick = goal.tick,
                    .clock = {leg.referee().phase(), goal.decision.clock},
                    .first = leg.tick(),
                    .prevention = {},
                    .hopeless = 0,
                    .decides = {rehearsal->decides(Team::blue), rehearsal->decides(Team::yellow)}};
    const auto found = Copy([&] {
                         study.prevention = search.last_prevention();
                         study.hopeless = search.hopeless_from(
                             study.prevention ? study.prevention->tick + 1 : study.first);
                         return study;
                       }).wait();
    if (!found) return tl::unexpected(failed);
    goals.push_back(*found);
  }
  return goals;
}

}  // namespace mirocup::coach
