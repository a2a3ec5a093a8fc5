// SPDX-License-Identifier: MIT
//
// The subcommand compare.
#include "programs/league/commands.hpp"
#include "system/text.hpp"
#include "tournaments/league/event.hpp"
#include "tournaments/play/comparison_run.hpp"
#include "tournaments/play/scratch_folder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace mirocup::league {

namespace {

constexpr int fixtures_of_a_table = 50;  // of each pair, by default

struct CompareOptions {
  ComparisonRun run;
  std::string league = "small";
  std::string against = "first";
  int most = 0;      // fixtures of a pair; 0: the default
  std::string keep;  // folder for the records; "": they are not kept
  bool json = false;
};

// What is reported of a pair, for text and JSON alike.
struct PairReport {
  std::array<std::string, 2> names;  // printable
  ComparisonInterval difference;     // Elo, the first team less the second
  int won = 0;                       // fixtures of the first team
  int level = 0;
  int lost = 0;
  std::array<int, 2> goals{};  // by scores, so a decided forfeit counts as it was decided
  std::array<std::array<int, enum_names<match::GoalKind>.size()>, 2>
      kinds{};                  // of goals on the field
  std::array<int, 2> faults{};  // legs that a team forfeited
};

PairReport report_of(const PairComparison& pair, const ComparisonRun& run) {
  PairReport report;
  report.names = {system::printable(run.teams[pair.teams[0]]),
                  system::printable(run.teams[pair.teams[1]])};
  report.difference = pair.scores.difference(run.test);
  constexpr int even = ScoreSequence::most_points / 2;
  for (int points = 0; points <= ScoreSequence::most_points; ++points) {
    int& count = points > even ? report.won : points < even ? report.lost : report.level;
    count += pair.scores.count(points);
  }
  for (const auto& fixture : pair.fixtures) {
    for (const ComparedLeg& leg : fixture) {
      for (int team = 0; team < 2; ++team) {
        report.goals[team] += leg.score[team];
        report.faults[team] += leg.faults[team];
        for (const auto& [kind, goals] : leg.goals[team])
          report.kinds[team][static_cast<std::size_t>(kind)] += goals;
      }
    }
  }
  return report;
}

std::string elo_text(double elo) {
  if (std::isinf(elo)) return elo > 0.0 ? "any number" : "minus any number";
  return std::to_string(std::lround(elo));
}

std::string verdict_text(const PairComparison& pair, const PairReport& r,
                         const ComparisonRun& run) {
  const std::string& one = r.names[0];
  const std::string& other = r.names[1];
  if (pair.is_of_copies) {
    return one + " and " + other + ": nothing can be said, since only " +
           std::to_string(pair.courses.size()) + " of " + std::to_string(pair.fixtures.size()) +
           " fixtures are different; the others are copies of them";
  }
  using enum ComparisonVerdict;
  if (pair.verdict == first) return one + " is better than " + other;
  if (pair.verdict == second) return other + " is better than " + one;
  if (pair.verdict == equal)
    return one + " and " + other + " are less than " + elo_text(run.test.equal_elo) + " Elo apart";
  return one + " and " + other + ": it cannot be said which is better";
}

std::string goals_text(const PairReport& r, int team) {
  std::string text = r.names[team] + " " + std::to_string(r.goals[team]);
  std::string kinds;
  for (std::size_t kind = 0; kind < r.kinds[team].size(); ++kind) {
    if (r.kinds[team][kind] == 0) continue;
    kinds += (kinds.empty() ? "" : ", ") + std::string(enum_names<match::GoalKind>[kind]) + " " +
             std::to_string(r.kinds[team][kind]);
  }
  return kinds.empty() ? text : text + " (" + kinds + ")";
}

std::string pair_text(const PairComparison& pair, const ComparisonRun& run) {
  const PairReport r = report_of(pair, run);
  std::string text = verdict_text(pair, r, run) + "\n";
  if (!pair.is_of_copies) {
    text += "  difference  " + elo_text(r.difference.value) + " Elo, 95 % interval " +
            elo_text(r.difference.low) + " to " + elo_text(r.difference.high) + "\n";
  }
  text += "  fixtures    " + std::to_string(pair.fixtures.size()) + ": won " +
          std::to_string(r.won) + ", level " + std::to_string(r.level) + ", lost " +
          std::to_string(r.lost) + "\n  legs        " + std::to_string(pair.legs()) +
          ", of which " + std::to_string(pair.distinct_legs()) + " are different\n  goals       " +
          goals_text(r, 0) + " : " + goals_text(r, 1) + "\n";
  for (int team = 0; team < 2; ++team) {
    if (r.faults[team] > 0)
      text += "  forfeits    " + r.names[team] + " forfeited " + std::to_string(r.faults[team]) +
              " legs\n";
  }
  return text;
}

// JSON has no infinity.
Json or_null(double elo) {
  return std::isinf(elo) ? Json() : Json(std::round(elo * 10.0) / 10.0);
}

Json pair_json(const PairComparison& pair, const ComparisonRun& run) {
  const PairReport r = report_of(pair, run);
  Json results = Json::array();
  for (int i = 0; i < static_cast<int>(pair.fixtures.size()); ++i) {
    Json legs = Json::array();
    for (const ComparedLeg& leg : pair.fixtures[i]) legs.push_back(leg.score);
    results.push_back({{"seed", comparison_seed(run, pair.teams, i)}, {"legs", legs}});
  }
  Json goals = Json::object();
  Json forfeits = Json::object();
  for (int team = 0; team < 2; ++team) {
    Json kinds = Json::object();
    for (std::size_t kind = 0; kind < r.kinds[team].size(); ++kind)
      kinds[std::string(enum_names<match::GoalKind>[kind])] = r.kinds[team][kind];
    const std::string name = team == 0 ? "A" : "B";
    goals[name] = {{"all", r.goals[team]}, {"kinds", kinds}};
    forfeits[name] = r.faults[team];
  }
  return {{"A", r.names[0]},
          {"B", r.names[1]},
          {"verdict", to_string(pair.verdict)},
          {"copies", pair.is_of_copies},
          {"fixtures", pair.fixtures.size()},
          {"legs", pair.legs()},
          {"distinct_legs", pair.distinct_legs()},
          {"difference",
           {{"elo", or_null(r.difference.value)},
            {"low", or_null(r.difference.low)},
            {"high", or_null(r.difference.high)}}},
          {"equal_elo", run.test.equal_elo},
          {"error", run.test.error},
          {"won", r.won},
          {"level", r.level},
          {"lost", r.lost},
          {"goals", goals},
          {"forfeits", forfeits},
          {"results", results}};
}

// A row of the rated table, the strongest team first.
struct RatedTeam {
  int team = 0;
  Strength strength;
  int won = 0;  // fixtures
  int level = 0;
  int lost = 0;
  int goals = 0;
  int goals_against = 0;
  std::optional<int> legs_to_tell;  // from the next team
};

std::vector<RatedTeam> rated_table(const std::vector<PairComparison>& pairs,
                                   const ComparisonRun& run) {
  const Ratings ratings = rate(run, pairs);
  std::vector<RatedTeam> table(run.teams.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i].team = static_cast<int>(i);
    table[i].strength = ratings.strengths[i];
  }
  for (const PairComparison& pair : pairs) {
    const PairReport r = report_of(pair, run);
    for (int side = 0; side < 2; ++side) {
      RatedTeam& row = table[pair.teams[side]];
      row.won += side == 0 ? r.won : r.lost;
      row.level += r.level;
      row.lost += side == 0 ? r.lost : r.won;
      row.goals += r.goals[side];
      row.goals_against += r.goals[1 - side];
    }
  }
  std::ranges::stable_sort(table, std::greater(),
                           [](const RatedTeam& row) { return row.strength.value; });
  for (std::size_t i = 0; i + 1 < table.size(); ++i)
    table[i].legs_to_tell = legs_to_tell(ratings, table[i].team, table[i + 1].team);
  return table;
}

std::string table_text(const std::vector<RatedTeam>& table, const ComparisonRun& run) {
  std::string text =
      "     strength  95 % interval    won  level   lost        goals  legs to tell apart  team\n";
  for (std::size_t i = 0; i < table.size(); ++i) {
    const RatedTeam& row = table[i];
    const std::string goals = std::to_string(row.goals) + " : " + std::to_string(row.goals_against);
    const std::string legs = row.legs_to_tell ? std::to_string(*row.legs_to_tell) : "-";
    text += system::formatted("%3zu %9ld  %5ld .. %5ld %6d %6d %6d %12s %19s  %s\n", i + 1,
                              std::lround(row.strength.value), std::lround(row.strength.low),
                              std::lround(row.strength.high), row.won, row.level, row.lost,
                              goals.c_str(), legs.c_str(),
                              system::printable(run.teams[row.team]).c_str());
  }
  return text;
}

Json table_json(const std::vector<RatedTeam>& table, const ComparisonRun& run) {
  Json rows = Json::array();
  for (const RatedTeam& row : table) {
    rows.push_back({{"team", run.teams[row.team]},
                    {"strength",
                     {{"value", or_null(row.strength.value)},
                      {"low", or_null(row.strength.low)},
                      {"high", or_null(row.strength.high)}}},
                    {"won", row.won},
                    {"level", row.level},
                    {"lost", row.lost},
                    {"goals", row.goals},
                    {"goals_against", row.goals_against},
                    {"legs_to_tell", row.legs_to_tell ? Json(*row.legs_to_tell) : Json()}});
  }
  return rows;
}

void print(const std::vector<PairComparison>& pairs, const ComparisonRun& run,
           const CompareOptions& options) {
  const bool has_table = run.plays_all;
  const auto table = has_table ? rated_table(pairs, run) : std::vector<RatedTeam>();
  if (!options.json) {
    for (const PairComparison& pair : pairs) std::cout << pair_text(pair, run);
    if (has_table) std::cout << table_text(table, run);
    return;
  }
  if (pairs.size() == 1 && !has_table) {
    print_json(pair_json(pairs[0], run));
    return;
  }
  Json json{{"comparisons", Json::array()}};
  for (const PairComparison& pair : pairs) json["comparisons"].push_back(pair_json(pair, run));
  if (has_table) json["table"] = table_json(table, run);
  print_json(json);
}

Result<int> run_compare(const CompareOptions& options) {
  system::Disk disk;
  ComparisonRun run = options.run;
  run.league = *from_string<RobotLeague>(options.league);
  run.all_pairs = run.plays_all = options.against == "all";
  if (options.most > 0) {
    run.max_fixtures = options.most;
  } else if (run.plays_all) {
    run.max_fixtures = fixtures_of_a_table;
  }
  const std::unique_ptr<ScratchFolder> scratch =
      options.keep.empty() ? std::make_unique<ScratchFolder>("mirocup-compare") : nullptr;
  run.keeps_legs = scratch == nullptr;
  run.folder = run.keeps_legs ? options.keep : scratch->path();
  if (run.folder.empty()) return fail(Errc::unavailable, "no folder for the records can be made");
  MIROCUP_TRY_VOID(disk.make_folder(run.folder));
  const auto progress = make_progress_reporter();
  MIROCUP_TRY(const auto pairs, run_comparison(disk, run, *progress));
  print(pairs, run, options);
  const bool is_answered = std::ranges::all_of(pairs, [&](const auto& pair) {
    return run.plays_all ? !pair.is_of_copies : pair.verdict != ComparisonVerdict::undecided;
  });
  return is_answered ? exit_yes : exit_no;
}

}  // namespace

void add_compare(system::Commands& commands) {
  const auto [command, o] = commands.add(run_compare, "compare", to_make,
                                         "Play teams against each other until one is found to be "
                                         "better, or they are found to be equal",
                                         {"mirocup league compare new.so old.so",
                                          "mirocup league compare a.so b.so c.so --against all"});
  ComparisonRun& r = o.run;
  command
      .option(
          "TEAM", r.teams,
          "Libraries, or names of house teams; :KEY=VALUE after one sets a parameter of that team")
      .required()
      .takes(2, 100);
  command
      .option("--against", o.against,
              "first: compare the first team with each other team; all: let each pair of teams "
              "play as many fixtures as --most says, and print a rated table")
      .one_of({"first", "all"})
      .shows_default();
  add_terms(command, o.league, r);
  command.option("--seed SEED", r.seed, "Seed of the fixtures").is_a_seed().shows_default();
  command.jobs(r.jobs, "legs played");
  command
      .option("--most NUMBER", o.most,
              "Largest number of fixtures (two legs each) that a pair of teams plays; a pair that "
              "is not decided after them stays undecided (default: " +
                  std::to_string(r.max_fixtures) +
                  "; with --against all: " + std::to_string(fixtures_of_a_table) + ")")
      .between(1, 1'000'000);
  command
      .option("--equal ELO", r.test.equal_elo,
              "Difference in Elo below which two teams count as equal")
      .between(1.0, 400.0)
      .shows_default();
  command.option("--keep DIR", o.keep,
                 "Folder for the records; the same command, called again, continues from them");
  command.flag("--json", o.json, "Print one JSON object");
}

}  // namespace mirocup::league
