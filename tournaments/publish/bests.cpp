// SPDX-License-Identifier: MIT
#include "system/text.hpp"
#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/site_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace mirocup::league {

namespace {

constexpr double upset = 100.0;           // strength; a smaller difference is no surprise
constexpr double late = 10.0;             // s before the end; such a goal decided late
constexpr double late_share = 0.1;        // of the leg, if that is longer
constexpr int most_goals_that_count = 8;  // of the excitement of a leg
constexpr std::size_t worth_length = 5;   // legs

std::string one_digit(double value) {
  return system::formatted("%.1f", value);
}

std::string place_of(const LegView& leg) {
  return leg.round + ", leg " + std::to_string(leg.leg);
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

// The numbers of one team over all legs with a replay.
struct TeamRuns {
  int won = 0;  // legs in a row, up to the latest
  int unbeaten = 0;
  int longest_won = 0;
  int longest_unbeaten = 0;
  int fouls = 0;
  int counted = 0;  // legs with known fouls
};

// The best of all legs and teams; of equals the first.
struct Records {
  Largest<std::pair<const LegView*, const GoalFact*>> fastest;
  Largest<const LegView*> win, goals;
  Largest<std::pair<const LegView*, int>> surprise;  // its winner
  std::vector<TeamRuns> teams;
  std::map<std::pair<int, int>, int> scored;  // by team and robot

  void add(const Overview& o, const LegView& leg) {
    const int home = leg.goals(leg.home);
    const int away = leg.goals(leg.away);
    win.offer(std::abs(home - away), &leg);
    goals.offer(home + away, &leg);
    for (const int team : {leg.home, leg.away}) {
      const int other = leg.other(team);
      const char letter = leg.letter(team);
      if (letter == 'W')
        surprise.offer(o.ratings.strengths[other].value - o.ratings.strengths[team].value,
                       {&leg, team});
      TeamRuns& runs = teams[team];
      runs.won = letter == 'W' ? runs.won + 1 : 0;
      runs.unbeaten = letter != 'L' ? runs.unbeaten + 1 : 0;
      runs.longest_won = std::max(runs.longest_won, runs.won);
      runs.longest_unbeaten = std::max(runs.longest_unbeaten, runs.unbeaten);
      if (leg.facts == nullptr) continue;
      runs.fouls += team == leg.home ? leg.facts->fouls.home : leg.facts->fouls.away;
      ++runs.counted;
    }
    if (leg.facts == nullptr || leg.facts->goals.empty()) return;
    fastest.offer(-leg.facts->goals[0].at, {&leg, leg.facts->goals.data()});
    for (const GoalFact& goal : leg.facts->goals) {
      if (goal.scorer >= 0) ++scored[{goal.is_home ? leg.home : leg.away, goal.scorer}];
    }
  }
};

std::string scorer_of(const Overview& o, const LegView& leg, const GoalFact& goal) {
  const std::string who = o.state.shown_name(goal.is_home ? leg.home : leg.away);
  if (goal.is_own_goal) return who + ", own goal of the other team";
  return goal.scorer < 0 ? who : who + ", robot " + std::to_string(goal.scorer);
}

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
    const double weaker =
        o.ratings.strengths[leg.other(team)].value - o.ratings.strengths[team].value;
    if (leg.letter(team) == 'W' && weaker >= upset)
      e.add(static_cast<int>(weaker / upset), o.state.shown_name(team) + " was the weaker team");
  }
  if (goals >= 4) e.add(0, std::to_string(goals) + " goals");
  if (e.why.empty()) e.why = apart == 0 ? "a draw" : "a close leg";
  return e;
}

}  // namespace

Json best(const std::string& title, const std::string& value, const std::string& who,
          const std::string& where, const std::string& page) {
  return {{"title", title}, {"value", value}, {"who", who}, {"where", where}, {"page", page}};
}

Json bests_of(const Overview& o) {
  Records records;
  records.teams.resize(o.state.teams.size());
  for (const LegView& leg : o.legs) {
    if (leg.has_replay() && !leg.is_annulled) records.add(o, leg);
  }
  Json bests = Json::array();
  if (const auto& goal = records.fastest; goal.what) {
    const LegView& leg = *goal.what->first;
    bests.push_back(best("Fastest goal", one_digit(-goal.value) + " s",
                         scorer_of(o, leg, *goal.what->second), pair(o, leg) + ", " + place_of(leg),
                         leg.page("", -goal.value)));
  }
  for (const auto& [title, most] :
       {std::pair("Biggest win", &records.win), std::pair("Most goals in a leg", &records.goals)}) {
    if (!most->what || most->value < 1.0) continue;
    const LegView& leg = **most->what;
    bests.push_back(best(title, score(leg), pair(o, leg), place_of(leg), leg.page()));
  }
  if (const auto& most = records.surprise; most.what && most.value >= upset) {
    const auto [leg, team] = *most.what;
    bests.push_back(
        best("Biggest upset", score(*leg),
             o.state.shown_name(team) + ", weaker by " + std::to_string(std::lround(most.value)),
             pair(o, *leg) + ", " + place_of(*leg), leg->page()));
  }
  const auto add_of_team = [&](const char* title, const std::string& value, int team,
                               const std::string& robot, const std::string& unit) {
    bests.push_back(best(title, value, o.state.shown_name(team) + robot, unit,
                         team_page_of(o.state.name(team))));
  };
  Largest<int> won, unbeaten, cleanest;
  for (int team = 0; team < static_cast<int>(records.teams.size()); ++team) {
    const TeamRuns& runs = records.teams[team];
    won.offer(runs.longest_won, team);
    unbeaten.offer(runs.longest_unbeaten, team);
    if (runs.counted > 0) cleanest.offer(-double(runs.fouls) / runs.counted, team);
  }
  const auto add_run = [&](const char* title, const Largest<int>& run, const char* unit) {
    if (run.what && run.value > 1.0)
      add_of_team(title, std::to_string(std::lround(run.value)), *run.what, "", unit);
  };
  add_run("Longest winning run", won, "legs won in a row");
  add_run("Longest run without defeat", unbeaten, "legs without defeat");
  Largest<std::pair<int, int>> scorer;
  for (const auto& [robot, count] : records.scored) scorer.offer(count, robot);
  if (scorer.what)
    add_of_team("Top scorer", std::to_string(std::lround(scorer.value)) + " goals",
                scorer.what->first, ", robot " + std::to_string(scorer.what->second), "");
  if (cleanest.what)
    add_of_team("Cleanest team", one_digit(std::abs(cleanest.value)), *cleanest.what, "",
                "fouls a leg");
  return bests;
}

Json worth_watching(const Overview& o) {
  struct Candidate {
    const LegView* leg;
    Excitement excitement;
  };
  std::vector<Candidate> legs;
  for (const LegView& leg : o.legs) {
    if (!leg.page().empty() && !leg.is_annulled) legs.push_back({&leg, excitement(o, leg)});
  }
  std::ranges::stable_sort(legs, std::greater(),
                           [](const Candidate& one) { return one.excitement.points; });
  Json best = Json::array();
  std::set<std::string> fixtures;  // the legs of a fixture are often mirror images
  for (const auto& [leg, excitement] : legs) {
    if (best.size() == worth_length || excitement.points <= 0) break;
    if (fixtures.insert(leg->fixture).second)
      best.push_back(leg_values(o, *leg, "", excitement.why));
  }
  return best;
}

}  // namespace mirocup::league
