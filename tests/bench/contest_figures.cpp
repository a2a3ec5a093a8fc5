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

// Every team meets each other in one fixture of two legs.
std::vector<FixtureResults> season(const std::vector<double>& truth, Random& random) {
  std::vector<FixtureResults> fixtures;
  for (int i = 0; i < static_cast<int>(truth.size()); ++i) {
    for (int j = 0; j < i; ++j) {
      const double difference = truth[i] - truth[j];
      fixtures.push_back({played(i, j, difference, random), played(j, i, -difference, random)});
    }
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

LegResult played(int home, int home_entry, int away, int away_entry, double difference,
                 Random& random) {
  LegResult leg = played(home, away, difference, random);
  leg.home_entry = home_entry;
  leg.away_entry = away_entry;
  return leg;
}

double points_of(const LegResult& leg, int team) {
  const int ahead = leg.difference(team);
  return ahead > 0 ? 3.0 : ahead == 0 ? 1.0 : 0.0;
}

// What a rule of ranking does in many terms.
struct Rule {
  const char* name;
  double concordant = 0.0;  // pairs in the right order, less those in the wrong order
  double ordered = 0.0;     // pairs that the rule orders
  double tau = 0.0;         // sum over the terms
  double equals = 0.0;      // pairs of equal last entries of which one was handed in earlier
  double earlier = 0.0;     // of these, how often the earlier entry is above; half of a tie

  void add(const std::vector<double>& value, const std::vector<double>& truth,
           const std::vector<int>& since) {
    concordant = ordered = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double same = (value[i] - value[j]) * (truth[i] - truth[j]);
        concordant += same > 0.0 ? 1.0 : same < 0.0 ? -1.0 : 0.0;
        ordered += same != 0.0 ? 1.0 : 0.0;
        if (std::abs(truth[i] - truth[j]) >= 20.0 || std::abs(since[i] - since[j]) < 3) continue;
        const auto [early, late] = since[i] < since[j] ? std::pair(i, j) : std::pair(j, i);
        equals += 1.0;
        earlier += value[early] > value[late] ? 1.0 : value[early] == value[late] ? 0.5 : 0.0;
      }
    }
    tau += concordant / std::max(1.0, ordered);
  }
};

// Each team improves by its own steps and hands in every fourth night, and
// before the last night every second team does.
void terms(int count, std::uint64_t seed, int opponents) {
  constexpr int teams = 30;
  constexpr int nights = 20;
  Random random(mix_seed(seed));
  Rule rules[]{{"points a leg"}, {"strength"}, {"closing round"}};
  double held = 0.0, apart = 0.0, apart_wrongly = 0.0, neighbours = 0.0, same = 0.0,
         same_apart = 0.0;
  for (int term = 0; term < count; ++term) {
    std::vector<double> skill(teams), entry(teams), work(teams);
    std::vector<int> since(teams, 1);
    std::vector<std::vector<double>> points(teams);
    std::vector<FixtureResults> fixtures;
    for (double& most : work) most = 10.0 + 50.0 * random.uniform();
    for (int night = 1; night <= nights; ++night) {
      for (int team = 0; team < teams; ++team) {
        skill[team] += work[team] * random.uniform();
        if (night > 1 && random.uniform() >= (night < nights ? 0.25 : 0.5)) continue;
        entry[team] = skill[team];
        since[team] = night;
        points[team].clear();
      }
      std::vector<std::pair<int, int>> pairs;
      for (int i = 0; i < teams; ++i) {
        for (int j = 0; j < i; ++j) pairs.emplace_back(i, j);
      }
      for (std::size_t i = pairs.size(); i > 1; --i)
        std::swap(pairs[i - 1], pairs[random.below(i)]);
      std::vector<int> met(teams);
      for (const auto& [i, j] : pairs) {
        if (opponents > 0 && (met[i] >= opponents || met[j] >= opponents)) continue;
        ++met[i];
        ++met[j];
        const double d = entry[i] - entry[j];
        fixtures.push_back({played(i, since[i], j, since[j], d, random),
                            played(j, since[j], i, since[i], -d, random)});
        for (const LegResult& leg : fixtures.back()) {
          for (const int team : {i, j}) points[team].push_back(points_of(leg, team));
        }
      }
    }
    std::vector<double> a_leg, strength, closing(teams);
    const Ratings ratings = rate_entries(since, fixtures, false);
    const double mean = std::accumulate(entry.begin(), entry.end(), 0.0) / teams;
    for (int team = 0; team < teams; ++team) {
      a_leg.push_back(std::accumulate(points[team].begin(), points[team].end(), 0.0) /
                      std::max<double>(1.0, double(points[team].size())));
      const Strength& s = ratings.strengths[team];
      strength.push_back(s.value);
      held += s.low <= entry[team] - mean && entry[team] - mean <= s.high ? 1.0 : 0.0;
    }
    for (int i = 0; i < teams; ++i) {
      for (int j = 0; j < i; ++j) {
        for (int leg = 0; leg < 4; ++leg) {
          const LegResult result = played(i, j, entry[i] - entry[j], random);
          closing[i] += points_of(result, i);
          closing[j] += points_of(result, j);
        }
      }
    }
    std::vector<int> order = all_teams(teams);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return strength[a] > strength[b]; });
    for (int i = 0; i + 1 < teams; ++i) {
      neighbours += 1.0;
      if (!are_apart(ratings, order[i], order[i + 1])) continue;
      apart += 1.0;
      apart_wrongly += entry[order[i]] <= entry[order[i + 1]] ? 1.0 : 0.0;
    }
    for (int i = 0; i < teams; ++i) {
      for (int j = 0; j < i; ++j) {
        if (std::abs(entry[i] - entry[j]) >= 5.0) continue;
        same += 1.0;
        same_apart += are_apart(ratings, i, j) ? 1.0 : 0.0;
      }
    }
    rules[0].add(a_leg, entry, since);
    rules[1].add(strength, entry, since);
    rules[2].add(closing, entry, since);
  }
  for (const Rule& rule : rules) {
    std::printf(
        "{\"rule\": \"%s\", \"opponents\": %d, \"seed\": %d, \"terms\": %d, \"tau\": %.3f, "
        "\"equals\": %.0f, \"earlier_above\": %.3f}\n",
        rule.name, opponents, static_cast<int>(seed), count, rule.tau / count, rule.equals,
        rule.earlier / rule.equals);
  }
  std::printf(
      "{\"intervals_that_hold\": %.3f, \"neighbours_decided\": %.3f, \"of_these_wrong\": %.3f, "
      "\"equals_apart\": %.3f}\n",
      held / (count * teams), apart / neighbours, apart_wrongly / std::max(1.0, apart),
      same_apart / same);
  std::fflush(stdout);
}

// One of eight teams hands in the same play six times, and each time meets three of the others in
// fixtures of two legs.
void ladders(int count, std::uint64_t seed) {
  constexpr int teams = 8;
  constexpr int hand_ins = 6;
  Random random(mix_seed(seed));
  std::array<int, teams> spans{};
  std::array<int, teams> spans_by_points{};
  int risen = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<double> truth = true_strengths(teams, 700.0, Spread::even, random);
    std::vector<int> entries(teams, 1);
    std::vector<FixtureResults> fixtures;
    const int own = static_cast<int>(random.below(teams));
    const auto meet = [&](int team, int most, double better) {
      std::vector<int> others = all_teams(teams);
      std::erase(others, team);
      for (int n = 0; n < most; ++n) {
        const std::size_t chosen = random.below(others.size());
        const int other = others[chosen];
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(chosen));
        const double d = truth[team] - truth[other] + better;
        fixtures.push_back({played(team, entries[team], other, entries[other], d, random),
                            played(other, entries[other], team, entries[team], -d, random)});
      }
    };
    for (int team = 0; team < teams; ++team) meet(team, 3, 0.0);
    const auto rank = [&](bool by_points) {
      std::vector<double> value(teams);
      if (by_points) {
        for (int team = 0; team < teams; ++team) {
          double sum = 0.0, legs = 0.0;
          for (const FixtureResults& fixture : fixtures) {
            for (const LegResult& leg : fixture) {
              if ((leg.home != team || leg.home_entry != entries[team]) &&
                  (leg.away != team || leg.away_entry != entries[team]))
                continue;
              sum += points_of(leg, team);
              legs += 1.0;
            }
          }
          value[team] = sum / std::max(1.0, legs);
        }
      } else {
        const Ratings ratings = rate_entries(entries, fixtures, true);
        for (int team = 0; team < teams; ++team) value[team] = ratings.strengths[team].value;
      }
      return static_cast<int>(
          std::count_if(value.begin(), value.end(), [&](double v) { return v > value[own]; }));
    };
    std::vector<int> ranks, by_points;
    for (int n = 0; n < hand_ins; ++n) {
      if (n > 0) {
        ++entries[own];
        meet(own, 3, 0.0);
      }
      ranks.push_back(rank(false));
      by_points.push_back(rank(true));
    }
    const auto span = [](const std::vector<int>& r) {
      const auto [low, high] = std::minmax_element(r.begin(), r.end());
      return *high - *low;
    };
    ++spans[span(ranks)];
    ++spans_by_points[span(by_points)];
    const int before = rank(false);
    ++entries[own];
    meet(own, 3, 200.0);
    risen += rank(false) < before || rank(false) == 0 ? 1 : 0;
  }
  for (const auto* of : {&spans, &spans_by_points}) {
    std::printf("{\"ladders\": %d, \"seed\": %d, \"by\": \"%s\", \"span\": [", count,
                static_cast<int>(seed), of == &spans ? "strength" : "points a leg");
    for (std::size_t i = 0; i < of->size(); ++i) std::printf("%s%d", i > 0 ? ", " : "", (*of)[i]);
    std::printf("]}\n");
  }
  std::printf("{\"entries_200_better_that_rise\": %.3f}\n", double(risen) / count);
  std::fflush(stdout);
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
    std::vector<FixtureResults> fixtures;
    for (int times = 0; times < 2; ++times) {
      const auto one = season(truth, random);
      fixtures.insert(fixtures.end(), one.begin(), one.end());
    }
    const Ratings ratings = rate(students + 2, fixtures);
    for (int team = 0; team < students; ++team) {
      const auto mark = mark_of(ratings, scale, 5.0, team);
      if (!mark) continue;
      const double true_mark = 4.0 - 3.0 * (truth[team] + 200.0) / 400.0;
      ++given;
      const auto [low, high] = std::minmax(mark->low, mark->high);
      held += low <= true_mark && true_mark <= high ? 1 : 0;
      width += high - low;
    }
  }
  std::printf("{\"marks\": %d, \"held\": %.3f, \"width\": %.2f}\n", given, double(held) / given,
              width / given);
  std::fflush(stdout);
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
  if (what == "terms" && argc > 4) {
    terms(std::atoi(argv[2]), std::strtoull(argv[3], nullptr, 10), std::atoi(argv[4]));
    return EXIT_SUCCESS;
  }
  if (what == "ladders" && argc > 3) {
    ladders(std::atoi(argv[2]), std::strtoull(argv[3], nullptr, 10));
    return EXIT_SUCCESS;
  }
  if (what == "marks" && argc > 3) {
    marks(std::atoi(argv[2]), std::strtoull(argv[3], nullptr, 10));
    return EXIT_SUCCESS;
  }
  if (what == "comparisons" && argc > 3) {
    const std::vector<int> pool = read_pool();
    if (pool.empty()) return 2;
    for (const Drawing& drawing : {Drawing{"as played", false}, Drawing{"equal", true},
                                   Drawing{"20 Elo", true, 20.0}, Drawing{"60 Elo", true, 60.0}})
      comparisons(std::atoi(argv[2]) / 4, std::atoi(argv[3]), pool, drawing);
    return EXIT_SUCCESS;
  }
  std::fprintf(
      stderr,
      "usage: contest_figures leagues COUNT | terms COUNT SEED OPPONENTS | ladders COUNT SEED | "
      "marks COUNT SEED | "
      "comparisons COUNT MOST < POINTS\n");
  return 2;
}
