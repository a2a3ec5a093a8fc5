// SPDX-License-Identifier: MIT
#include "tournaments/publish/bests.hpp"

#include "system/text.hpp"
#include "tournaments/publish/replay_pages.hpp"
#include "tournaments/publish/team_page.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace mirocup::league {

namespace {

constexpr double run_up = 3.0;            // s of a replay before a goal
constexpr double upset = 100.0;           // strength; a smaller difference is no surprise
constexpr double late = 10.0;             // s before the end; such a goal decided late
constexpr double late_share = 0.1;        // of the leg, if that is longer
constexpr int most_goals_that_count = 8;  // of the excitement of a leg

std::string one_digit(double value) {
  return system::formatted("%.1f", value);
}

std::string place_of(const LegView& leg) {
  return leg.round + ", leg " + std::to_string(leg.leg);
}

std::string page_of(const LegView& leg, double at = -1.0) {
  std::string page = leg.page();
  if (at >= 0.0 && !page.empty()) page += "#t=" + one_digit(std::max(0.0, at - run_up));
  return page;
}

std::string pair(const Overview& o, const LegView& leg) {
  return o.state.shown_name(leg.home) + " – " + o.state.shown_name(leg.away);
}

std::string score(const LegView& leg) {
  return std::to_string(leg.goals(leg.home)) + ":" + std::to_string(leg.goals(leg.away));
}

// Keeps the first of the best.
template <class T>
struct Largest {
  double value = -1e300;
  std::optional<T> what;

  void offer(double other, const T& candidate) {
    if (what && other <= value) return;
    value = other;
    what = candidate;
  }
};

class BestFinder {
 public:
  explicit BestFinder(const Overview& o) : o_(o) {
    for (const LegView& leg : o.legs) {
      if (leg.has_replay() && !leg.is_annulled) legs_.push_back(&leg);
    }
  }

  std::vector<Best> all() {
    fastest_goal();
    biggest_win();
    most_goals();
    biggest_upset();
    longest_runs();
    top_scorer();
    cleanest_team();
    return std::move(bests_);
  }

 private:
  using Goal = std::pair<const LegView*, const GoalFact*>;

  std::string team_of(const Goal& goal) const {
    const int team = goal.second->is_home ? goal.first->home : goal.first->away;
    std::string who = o_.state.shown_name(team);
    if (goal.second->is_own_goal) return who + ", own goal of the other team";
    return goal.second->scorer < 0 ? who : who + ", robot " + std::to_string(goal.second->scorer);
  }

  void fastest_goal() {
    Largest<Goal> best;
    for (const LegView* leg : legs_) {
      if (leg->facts == nullptr || leg->facts->goals.empty()) continue;
      best.offer(-leg->facts->goals[0].at, {leg, leg->facts->goals.data()});
    }
    if (!best.what) return;
    const LegView& leg = *best.what->first;
    bests_.push_back({"Fastest goal", one_digit(-best.value) + " s", team_of(*best.what),
                      pair(o_, leg) + ", " + place_of(leg), page_of(leg, -best.value)});
  }

  void leg_with_most(const std::string& title, auto value, double least) {
    Largest<const LegView*> best;
    for (const LegView* leg : legs_) best.offer(value(*leg), leg);
    if (!best.what || best.value < least) return;
    const LegView& leg = **best.what;
    bests_.push_back({title, score(leg), pair(o_, leg), place_of(leg), page_of(leg)});
  }

  void biggest_win() {
    leg_with_most(
        "Biggest win",
        [](const LegView& leg) { return std::abs(leg.goals(leg.home) - leg.goals(leg.away)); },
        1.0);
  }

  void most_goals() {
    leg_with_most(
        "Most goals in a leg",
        [](const LegView& leg) { return leg.goals(leg.home) + leg.goals(leg.away); }, 1.0);
  }

  void biggest_upset() {
    Largest<std::pair<const LegView*, int>> best;
    for (const LegView* leg : legs_) {
      for (const int team : {leg->home, leg->away}) {
        if (leg->letter(team) != 'W') continue;
        const int other = team == leg->home ? leg->away : leg->home;
        best.offer(o_.ratings.strengths[other].value - o_.ratings.strengths[team].value,
                   {leg, team});
      }
    }
    if (!best.what || best.value < upset) return;
    const auto [leg, team] = *best.what;
    bests_.push_back(
        {"Biggest upset", score(*leg),
         o_.state.shown_name(team) + ", weaker by " + std::to_string(std::lround(best.value)),
         pair(o_, *leg) + ", " + place_of(*leg), page_of(*leg)});
  }

  void longest_runs() {
    longest_run("Longest winning run", "legs won in a row",
                [](char letter) { return letter == 'W'; });
    longest_run("Longest run without defeat", "legs without defeat",
                [](char letter) { return letter != 'L'; });
  }

  void longest_run(const std::string& title, const std::string& unit, auto counts) {
    Largest<int> best;
    for (int team = 0; team < static_cast<int>(o_.state.teams.size()); ++team) {
      int run = 0;
      for (const LegView* leg : legs_) {
        if (!leg->is_of(team)) continue;
        run = counts(leg->letter(team)) ? run + 1 : 0;
        if (run > 1) best.offer(run, team);
      }
    }
    if (!best.what) return;
    add_of_team(title, std::to_string(std::lround(best.value)), *best.what, "", unit);
  }

  void top_scorer() {
    std::map<std::pair<int, int>, int> goals;
    for (const LegView* leg : legs_) {
      if (leg->facts == nullptr) continue;
      for (const GoalFact& goal : leg->facts->goals) {
        if (goal.scorer >= 0) ++goals[{goal.is_home ? leg->home : leg->away, goal.scorer}];
      }
    }
    Largest<std::pair<int, int>> best;
    for (const auto& [robot, count] : goals) best.offer(count, robot);
    if (!best.what) return;
    add_of_team("Top scorer", std::to_string(std::lround(best.value)) + " goals", best.what->first,
                ", robot " + std::to_string(best.what->second), "");
  }

  void cleanest_team() {
    const std::size_t teams = o_.state.teams.size();
    std::vector<int> fouls(teams);
    std::vector<int> legs(teams);
    for (const LegView* leg : legs_) {
      if (leg->facts == nullptr) continue;
      fouls[leg->home] += leg->facts->fouls.home;
      fouls[leg->away] += leg->facts->fouls.away;
      ++legs[leg->home];
      ++legs[leg->away];
    }
    Largest<int> best;
    for (std::size_t team = 0; team < teams; ++team) {
      if (legs[team] > 0) best.offer(-double(fouls[team]) / legs[team], static_cast<int>(team));
    }
    if (!best.what) return;
    add_of_team("Cleanest team", one_digit(std::abs(best.value)), *best.what, "", "fouls a leg");
  }

  void add_of_team(const std::string& title, const std::string& value, int team,
                   const std::string& robot, const std::string& unit) {
    bests_.push_back(
        {title, value, o_.state.shown_name(team) + robot, unit, team_page_of(o_.state.name(team))});
  }

  const Overview& o_;
  std::vector<const LegView*> legs_;
  std::vector<Best> bests_;
};

// How a leg went, goal by goal.
struct Course {
  int lead_changes = 0;
  double decided_before_end = 1e300;  // s; when the winner went ahead for good
};

Course course_of(const LegFacts& facts) {
  Course course;
  int ahead = 0;   // goals of the home team
  int leader = 0;  // sign of the last lead
  for (const GoalFact& goal : facts.goals) {
    const bool was_level = ahead == 0;
    ahead += goal.is_home ? 1 : -1;
    if (was_level) course.decided_before_end = facts.length - goal.at;
    if (ahead == 0) continue;
    const int now = ahead > 0 ? 1 : -1;
    if (leader != 0 && now != leader) ++course.lead_changes;
    leader = now;
  }
  return course;
}

struct Excitement {
  int points = 0;
  std::string why;

  void add(int more, const std::string& reason) {
    points += more;
    why += (why.empty() ? "" : ", ") + reason;
  }
};

std::string times(int count) {
  return count == 1 ? "once" : count == 2 ? "twice" : std::to_string(count) + " times";
}

Excitement excitement(const Overview& o, const LegView& leg) {
  Excitement e;
  const int goals = leg.goals(leg.home) + leg.goals(leg.away);
  const int apart = std::abs(leg.goals(leg.home) - leg.goals(leg.away));
  e.points = std::min(goals, most_goals_that_count);
  if (apart <= 1 && goals > 0) e.points += 2;
  if (leg.played->end == LegEnd::shoot_out) e.add(6, "shoot-out");
  if (leg.played->end == LegEnd::golden_goal) e.add(5, "golden goal");
  if (leg.facts != nullptr) {
    const Course course = course_of(*leg.facts);
    if (course.lead_changes > 0)
      e.add(4 * course.lead_changes, "the lead changed " + times(course.lead_changes));
    const double limit = std::max(late, late_share * leg.facts->length);
    if (apart > 0 && leg.played->end == LegEnd::full_time && course.decided_before_end < limit)
      e.add(3, "decided " + one_digit(course.decided_before_end) + " s before the end");
  }
  for (const int team : {leg.home, leg.away}) {
    const int other = team == leg.home ? leg.away : leg.home;
    const double weaker = o.ratings.strengths[other].value - o.ratings.strengths[team].value;
    if (leg.letter(team) == 'W' && weaker >= upset)
      e.add(static_cast<int>(weaker / upset), o.state.shown_name(team) + " was the weaker team");
  }
  if (goals >= 4) e.add(0, std::to_string(goals) + " goals");
  if (e.why.empty()) e.why = apart == 0 ? "a draw" : "a close leg";
  return e;
}

}  // namespace

std::vector<Best> bests_of(const Overview& o) {
  return BestFinder(o).all();
}

std::vector<WorthWatching> worth_watching(const Overview& o, int team, std::size_t most) {
  struct Candidate {
    const LegView* leg;
    Excitement excitement;
  };
  std::vector<Candidate> legs;
  for (const LegView& leg : o.legs) {
    if (leg.page().empty() || leg.is_annulled || (team >= 0 && !leg.is_of(team))) continue;
    legs.push_back({&leg, excitement(o, leg)});
  }
  std::stable_sort(legs.begin(), legs.end(), [](const Candidate& a, const Candidate& b) {
    return a.excitement.points > b.excitement.points;
  });
  std::vector<WorthWatching> best;
  for (const Candidate& one : legs) {
    if (best.size() == most || one.excitement.points <= 0) break;
    // The legs of a fixture are often mirror images.
    const bool is_second = std::any_of(best.begin(), best.end(), [&](const WorthWatching& other) {
      return other.leg->fixture == one.leg->fixture;
    });
    if (!is_second) best.push_back({one.leg, one.excitement.why});
  }
  return best;
}

}  // namespace mirocup::league
