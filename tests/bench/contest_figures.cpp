// SPDX-License-Identifier: MIT
//
// The simulated part of tests/bench/contest: how often the statements of statistics hold where the
// truth is known. Prints one JSON object for each line.
//
// contest_figures leagues COUNT: leagues of teams whose strengths are known; how often the 95 %
// intervals hold the truth, for all teams and for the best and the worst.
//
// contest_figures terms COUNT SEED OPPONENTS: terms of a nightly league in which 30 teams improve
// and hand in again in 20 nights; for each rule of ranking, how often the right order is found, and
// how often the earlier of two equal last entries is above. OPPONENTS 0: each night all pairs meet.
//
// contest_figures ladders COUNT SEED: ladders of eight teams in which one team hands in the same
// play six times; how many ranks the team spans.
//
// contest_figures marks COUNT SEED: closing rounds of 20 teams and the two house teams of a scale;
// how often the interval of a mark holds the true mark.
//
// contest_figures comparisons COUNT MOST: reads the half points (0 to 4) of played fixtures from
// standard input. Draws the fixtures of COUNT comparisons from them, and counts wrong claims.
#include "core/base/random.hpp"
#include "tournaments/table/comparison.hpp"
#include "tournaments/table/rating.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

using namespace mirocup;
using namespace mirocup::league;

namespace {

// How the true strengths of a league are chosen.
enum class Spread { even, normal };

// Even: equally spaced, and `spread` from the best to the worst. Normal: drawn, with that standard
// deviation. The best is first, and the mean is 0.
std::vector<double> true_strengths(int teams, double spread, Spread kind, Random& random) {
  std::vector<double> truth;
  for (int i = 0; i < teams; ++i) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
    const double normal = radius * std::cos(2.0 * 3.14159265358979 * random.uniform());
    truth.push_back(spread * (kind == Spread::even ? 0.5 - double(i) / (teams - 1) : normal));
  }
  std::sort(truth.rbegin(), truth.rend());
  const double mean = std::accumulate(truth.begin(), truth.end(), 0.0) / teams;
  for (double& strength : truth) strength -= mean;
  return truth;
}

// A leg between two teams of these strengths; one leg in five between equal teams is a draw.
LegResult played(int home, int away, double difference, Random& random) {
  const double win = std::pow(10.0, difference / 400.0);
  const double draw = 0.5 * std::sqrt(win);
  const double drawn = random.uniform() * (win + 1.0 + draw);
  LegResult leg;
  leg.home = home;
  leg.away = away;
  leg.home_goals = drawn < win ? 1 : 0;
  leg.away_goals = drawn >= win && drawn < win + 1.0 ? 1 : 0;
  return leg;
}

std::vector<std::pair<int, int>> pairs_of(const std::vector<double>& teams) {
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < static_cast<int>(teams.size()); ++i) {
    for (int j = 0; j < i; ++j) pairs.emplace_back(i, j);
  }
  return pairs;
}

// Every team meets each other in one fixture of two legs.
std::vector<FixtureResults> season(const std::vector<double>& truth, Random& random) {
  std::vector<FixtureResults> fixtures;
  for (const auto& [i, j] : pairs_of(truth)) {
    const double difference = truth[i] - truth[j];
    fixtures.push_back({played(i, j, difference, random), played(j, i, -difference, random)});
  }
  return fixtures;
}

void leagues(int count, int teams, double spread, Spread kind) {
  Random random(mix_seed(static_cast<std::uint64_t>(spread) * 1000 + teams) ^
                static_cast<std::uint64_t>(kind));
  int held = 0;
  int held_at_the_ends = 0;
  double width = 0.0;
  for (int i = 0; i < count; ++i) {
    const std::vector<double> truth = true_strengths(teams, spread, kind, random);
    const Ratings ratings = rate(teams, season(truth, random));
    for (int team = 0; team < teams; ++team) {
      const Strength& strength = ratings.strengths[team];
      const int holds = strength.low <= truth[team] && truth[team] <= strength.high ? 1 : 0;
      held += holds;
      if (team == 0 || team == teams - 1) held_at_the_ends += holds;
      width += strength.high - strength.low;
    }
  }
  std::printf(
      "{\"teams\": %d, \"spread\": %.0f, \"kind\": \"%s\", \"covered\": %.4f, "
      "\"covered_at_the_ends\": %.4f, \"width\": %.0f}\n",
      teams, spread, kind == Spread::even ? "even" : "normal", double(held) / (count * teams),
      double(held_at_the_ends) / (2 * count), width / (count * teams));
  std::fflush(stdout);
}

// A fixture of two legs between the entries of two teams; `difference` is that of their strengths.
FixtureResults fixture(int one, int other, const std::vector<int>& entries, double difference,
                       Random& random) {
  FixtureResults legs{played(one, other, difference, random),
                      played(other, one, -difference, random)};
  for (LegResult& leg : legs) {
    leg.home_entry = entries[leg.home];
    leg.away_entry = entries[leg.away];
  }
  return legs;
}

double points_of(const LegResult& leg, int team) {
  const int ahead = leg.difference(team);
  return ahead > 0 ? 3.0 : ahead == 0 ? 1.0 : 0.0;
}

// What a rule of ranking does in many terms.
struct Rule {
  const char* name;
  double tau = 0.0;      // sum over the terms
  double equals = 0.0;   // pairs of equal last entries of which one was handed in earlier
  double earlier = 0.0;  // of these, how often the earlier entry is above; half of a tie

  void add(const std::vector<double>& value, const std::vector<double>& truth,
           const std::vector<int>& since) {
    double concordant = 0.0, ordered = 0.0;
    for (const auto& [i, j] : pairs_of(truth)) {
      const double same = (value[i] - value[j]) * (truth[i] - truth[j]);
      concordant += same > 0.0 ? 1.0 : same < 0.0 ? -1.0 : 0.0;
      ordered += same != 0.0 ? 1.0 : 0.0;
      if (std::abs(truth[i] - truth[j]) >= 20.0 || std::abs(since[i] - since[j]) < 3) continue;
      const double above = (value[i] - value[j]) * (since[j] - since[i]);
      equals += 1.0;
      earlier += above > 0.0 ? 1.0 : above == 0.0 ? 0.5 : 0.0;
    }
    tau += concordant / std::max(1.0, ordered);
  }
};

// Each team improves by its own steps and hands in every fourth night, and before the last night
// every second team does.
void terms(int count, std::uint64_t seed, int opponents) {
  constexpr int teams = 30;
  constexpr int nights = 20;
  Random random(mix_seed(seed));
  Rule rules[]{{"points a leg"}, {"strength"}, {"closing round"}};
  double held = 0.0;
  for (int term = 0; term < count; ++term) {
    std::vector<double> skill(teams), entry(teams), work(teams), sum(teams), legs(teams);
    std::vector<int> since(teams, 1);
    std::vector<FixtureResults> fixtures;
    for (double& most : work) most = 10.0 + 50.0 * random.uniform();
    for (int night = 1; night <= nights; ++night) {
      for (int team = 0; team < teams; ++team) {
        skill[team] += work[team] * random.uniform();
        if (night > 1 && random.uniform() >= (night < nights ? 0.25 : 0.5)) continue;
        entry[team] = skill[team];
        since[team] = night;
        sum[team] = legs[team] = 0.0;
      }
      auto pairs = pairs_of(entry);
      for (std::size_t i = pairs.size(); i > 1; --i)
        std::swap(pairs[i - 1], pairs[random.below(i)]);
      std::vector<int> met(teams);
      for (const auto& [i, j] : pairs) {
        if (opponents > 0 && (met[i] >= opponents || met[j] >= opponents)) continue;
        fixtures.push_back(fixture(i, j, since, entry[i] - entry[j], random));
        for (const int team : {i, j}) {
          ++met[team];
          legs[team] += 2.0;
          for (const LegResult& leg : fixtures.back()) sum[team] += points_of(leg, team);
        }
      }
    }
    std::vector<double> a_leg(teams), strength(teams), closing(teams);
    const Ratings ratings = rate_entries(since, fixtures, false);
    const double mean = std::accumulate(entry.begin(), entry.end(), 0.0) / teams;
    for (int team = 0; team < teams; ++team) {
      a_leg[team] = sum[team] / std::max(1.0, legs[team]);
      const Strength& s = ratings.strengths[team];
      strength[team] = s.value;
      held += s.low <= entry[team] - mean && entry[team] - mean <= s.high ? 1.0 : 0.0;
    }
    for (const auto& [i, j] : pairs_of(entry)) {
      for (int leg = 0; leg < 4; ++leg) {
        const LegResult result = played(i, j, entry[i] - entry[j], random);
        for (const int team : {i, j}) closing[team] += points_of(result, team);
      }
    }
    rules[0].add(a_leg, entry, since);
    rules[1].add(strength, entry, since);
    rules[2].add(closing, entry, since);
  }
  for (const Rule& rule : rules)
    std::printf("{\"rule\": \"%s\", \"tau\": %.3f, \"equals\": %.0f, \"earlier_above\": %.3f}\n",
                rule.name, rule.tau / count, rule.equals, rule.earlier / rule.equals);
  std::printf("{\"intervals_that_hold\": %.3f}\n", held / (count * teams));
}

// One of eight teams, 700 from the best to the worst, hands in the same play six times, and each
// time meets three of the others. A seventh entry is 200 stronger.
void ladders(int count, std::uint64_t seed) {
  constexpr int teams = 8;
  constexpr int hand_ins = 6;
  Random random(mix_seed(seed));
  std::array<int, teams> spans{};
  int risen = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<double> truth = true_strengths(teams, 700.0, Spread::even, random);
    std::vector<int> entries(teams, 1);
    std::vector<FixtureResults> fixtures;
    const int own = static_cast<int>(random.below(teams));
    const auto meet_three = [&](int team, double better) {
      std::vector<int> others = all_teams(teams);
      std::erase(others, team);
      for (int n = 0; n < 3; ++n) {
        const int other = others[random.below(others.size())];
        std::erase(others, other);
        fixtures.push_back(
            fixture(team, other, entries, truth[team] - truth[other] + better, random));
      }
    };
    const auto rank = [&] {
      const Ratings found = rate_entries(entries, fixtures, true);
      return static_cast<int>(std::count_if(
          found.strengths.begin(), found.strengths.end(),
          [&](const Strength& one) { return one.value > found.strengths[own].value; }));
    };
    for (int team = 0; team < teams; ++team) meet_three(team, 0.0);
    std::vector<int> ranks{rank()};
    for (int n = 1; n < hand_ins; ++n) {
      ++entries[own];
      meet_three(own, 0.0);
      ranks.push_back(rank());
    }
    const auto [low, high] = std::minmax_element(ranks.begin(), ranks.end());
    ++spans[*high - *low];
    ++entries[own];
    meet_three(own, 200.0);
    const int after = rank();
    risen += after < ranks.back() || after == 0 ? 1 : 0;
  }
  std::printf("{\"ladders\": %d, \"rose_if_200_better\": %d, \"span\": [%d", count, risen,
              spans[0]);
  for (int span = 1; span < teams; ++span) std::printf(", %d", spans[span]);
  std::printf("]}\n");
}

// The scale goes from mark 4 at a strength of -200 to mark 1 at 200. Students are between the two.
void marks(int count, std::uint64_t seed) {
  constexpr int students = 20;
  const std::vector<ScaleStep> scale{{4.0, students}, {1.0, students + 1}};
  Random random(mix_seed(seed));
  int held = 0, given = 0;
  double width = 0.0;
  for (int term = 0; term < count; ++term) {
    std::vector<double> truth = true_strengths(students, 380.0, Spread::even, random);
    truth.insert(truth.end(), {-200.0, 200.0});
    std::vector<FixtureResults> fixtures = season(truth, random);
    for (const FixtureResults& again : season(truth, random)) fixtures.push_back(again);
    const Ratings ratings = rate(students + 2, fixtures);
    for (int team = 0; team < students; ++team) {
      const auto mark = mark_of(ratings, scale, 5.0, team);
      if (!mark) continue;
      const double true_mark = 2.5 - 3.0 * truth[team] / 400.0;
      const auto [low, high] = std::minmax(mark->low, mark->high);
      ++given;
      held += low <= true_mark && true_mark <= high ? 1 : 0;
      width += high - low;
    }
  }
  std::printf("{\"marks\": %d, \"held\": %.3f, \"width\": %.2f}\n", given, double(held) / given,
              width / given);
}

// How the fixtures of a simulated comparison come from the pool.
struct Drawing {
  const char* name;
  bool is_turned;    // half of the fixtures, by a coin, as the other team saw them: equal teams
  double elo = 0.0;  // by which the first team is then better: some of the fixtures are won by it
};

int drawn(const std::vector<int>& pool, const Drawing& drawing, Random& random) {
  if (random.uniform() < 2.0 * share_of(drawing.elo) - 1.0) return ScoreSequence::most_points;
  const int points = pool[random.below(pool.size())];
  return drawing.is_turned && random.coin() ? ScoreSequence::most_points - points : points;
}

// Whether a claim is false where the first team's expected share is `share`.
bool is_wrong(ComparisonVerdict verdict, double share) {
  const double apart = std::abs(elo_of(share));
  switch (verdict) {
    case ComparisonVerdict::first:
      return share <= 0.5;
    case ComparisonVerdict::second:
      return share >= 0.5;
    case ComparisonVerdict::equal:
      return apart >= ComparisonOptions{}.equal_elo - 1e-6;  // at the bound, but for rounding
    case ComparisonVerdict::undecided:
      break;
  }
  return false;
}

void comparisons(int count, int most, const std::vector<int>& pool, const Drawing& drawing) {
  Random random(mix_seed(static_cast<std::uint64_t>(drawing.elo) * 2 + drawing.is_turned));
  const double mean = std::accumulate(pool.begin(), pool.end(), 0.0) /
                      (double(pool.size()) * ScoreSequence::most_points);
  const double share = drawing.is_turned ? share_of(drawing.elo) : mean;
  std::array<int, enum_names<ComparisonVerdict>.size()> verdicts{};
  int wrong = 0;
  std::vector<int> fixtures;
  for (int i = 0; i < count; ++i) {
    ScoreSequence scores;
    ComparisonVerdict verdict = ComparisonVerdict::undecided;
    while (verdict == ComparisonVerdict::undecided && scores.fixtures() < most) {
      scores.add(drawn(pool, drawing, random));
      verdict = scores.verdict();
    }
    ++verdicts[static_cast<std::size_t>(verdict)];
    wrong += is_wrong(verdict, share) ? 1 : 0;
    fixtures.push_back(scores.fixtures());
  }
  std::sort(fixtures.begin(), fixtures.end());
  std::printf(
      "{\"drawing\": \"%s\", \"elo\": %.1f, \"comparisons\": %d, \"wrong\": %d, \"first\": %d, "
      "\"second\": %d, \"equal\": %d, \"undecided\": %d, \"median_fixtures\": %d, "
      "\"slowest_tenth\": %d}\n",
      drawing.name, elo_of(share), count, wrong, verdicts[1], verdicts[2], verdicts[3], verdicts[0],
      fixtures[fixtures.size() / 2], fixtures[fixtures.size() * 9 / 10]);
  std::fflush(stdout);
}

std::vector<int> read_pool() {
  std::vector<int> pool;
  for (int points = 0; std::scanf("%d", &points) == 1;)
    pool.push_back(std::clamp(points, 0, ScoreSequence::most_points));
  return pool;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 2 ? argv[1] : "";
  if (what == "leagues") {
    for (const Spread kind : {Spread::even, Spread::normal}) {
      for (const int teams : {8, 20}) {
        for (const double spread : {100.0, 200.0, 400.0})
          leagues(std::atoi(argv[2]), teams, spread, kind);
      }
    }
    return EXIT_SUCCESS;
  }
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  if (what == "terms" && argc > 4) return terms(std::atoi(argv[2]), seed, std::atoi(argv[4])), 0;
  if (what == "ladders") return ladders(std::atoi(argv[2]), seed), 0;
  if (what == "marks") return marks(std::atoi(argv[2]), seed), 0;
  if (what == "comparisons" && argc > 3) {
    const std::vector<int> pool = read_pool();
    if (pool.empty()) return 2;
    for (const Drawing& drawing : {Drawing{"as played", false}, Drawing{"equal", true},
                                   Drawing{"20 Elo", true, 20.0}, Drawing{"60 Elo", true, 60.0}})
      comparisons(std::atoi(argv[2]) / 4, std::atoi(argv[3]), pool, drawing);
    return EXIT_SUCCESS;
  }
  std::fputs(
      "usage: contest_figures leagues COUNT | terms COUNT SEED OPPONENTS | ladders COUNT SEED | "
      "marks COUNT SEED | "
      "comparisons COUNT MOST < POINTS\n",
      stderr);
  return 2;
}
