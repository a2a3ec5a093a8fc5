// SPDX-License-Identifier: MIT
#include "tournaments/play/comparison_run.hpp"

#include "core/base/random.hpp"
#include "record/answer.hpp"
#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "record/rules_json.hpp"
#include "system/digest.hpp"
#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "tournaments/format/schedule.hpp"
#include "tournaments/league/event.hpp"

#include <sstream>
#include <tuple>

namespace mirocup::league {

namespace {

// After so many fixtures a pair whose legs are copies is given up.
constexpr int enough_to_see_copies = 20;

// A leg of a run: its number counts the legs of a pair, two for each fixture.
struct Leg {
  std::size_t pair = 0;
  int number = 0;

  bool is_swapped() const { return number % legs_per_fixture == 1; }
  auto operator<=>(const Leg&) const = default;
};

// Returns the path of the record of a leg of two teams, counted as in Leg.
std::string record_path(const ComparisonRun& run, const std::array<int, 2>& teams, int number) {
  const auto [one, other] = teams;
  return run.folder + "/" + std::to_string(one + 1) + "-" + std::to_string(other + 1) + "-" +
         std::to_string(number / legs_per_fixture + 1) +
         (number % legs_per_fixture == 1 ? "b" : "a") + ".json";
}

std::string digits(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

// Reads what a comparison needs; `blue` is the index in the pair of the team that plays in blue.
ComparedLeg compared_leg(const record::JsonReader& json, int blue) {
  ComparedLeg leg;
  const auto team_of = [blue](const std::string& colour) {
    return colour == "blue" ? blue : 1 - blue;
  };
  const record::JsonReader result = json.at("result");
  leg.score[blue] = result.at("score").at("blue").integer(0, max_count);
  leg.score[1 - blue] = result.at("score").at("yellow").integer(0, max_count);
  leg.both_lose = result.at("end").text() == "double_forfeit";
  for (const record::JsonReader& fault : result.at("faults").elements())
    leg.faults[team_of(fault.at("team").text())] = 1;
  for (const record::JsonReader& call : json.at("decisions").elements()) {
    if (call.at("decision").text() != "GOAL") continue;
    const int team = team_of(call.at("team").text());
    ++leg.goals[team][call.at("kind").name<match::GoalKind>()];
    // Ticks of the colours and not of the teams: a swapped leg may be a copy, too.
    leg.trajectory += std::to_string(call.at("tick").integer<int>()) + call.at("team").text() + ' ';
  }
  if (leg.trajectory.empty()) leg.trajectory = json.at("state_hash").text();
  return leg;
}

class Comparison {
 public:
  Comparison(system::Files& files, const ComparisonRun& run, ProgressReporter& progress)
      : files_(files), run_(run), progress_(progress) {
    const int teams = static_cast<int>(run.teams.size());
    for (int one = 0; one < (run.all_pairs ? teams : 1); ++one) {
      for (int other = one + 1; other < teams; ++other) {
        pairs_.emplace_back().teams = {one, other};
      }
    }
    next_.resize(pairs_.size(), 0);
  }

  Result<std::vector<PairComparison>> play() {
    if (run_.keeps_legs) MIROCUP_TRY_VOID(open_folder());
    const std::vector<int> cpus = system::processors();
    const std::size_t jobs = run_.jobs > 0 ? static_cast<std::size_t>(run_.jobs) : cpus.size();
    int started = 0;
    while (!is_finished()) {
      const auto leg = processes_.running() < jobs ? next_leg() : std::nullopt;
      if (leg) {
        ++next_[leg->pair];
        if (run_.keeps_legs && files_.exists(record_of(*leg))) {
          MIROCUP_TRY_VOID(count(*leg, true));
        } else {
          MIROCUP_TRY_VOID(start(*leg, cpus[started++ % cpus.size()]));
        }
        continue;
      }
      const auto exit = processes_.wait();
      if (!exit) return fail(Errc::interrupted, "interrupted; " + how_to_go_on());
      MIROCUP_TRY_VOID(count_child(*exit));
    }
    return pairs_;
  }

 private:
  bool is_finished() const {
    for (const PairComparison& pair : pairs_) {
      if (!is_over(pair, run_)) return false;
    }
    return true;
  }

  std::string how_to_go_on() const {
    return run_.keeps_legs ? "the same command continues from " + run_.folder
                           : std::string("nothing can be said (--keep FOLDER keeps the legs)");
  }

  // Returns the next leg of the pair of which the fewest have been started.
  std::optional<Leg> next_leg() const {
    std::optional<Leg> best;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (is_over(pairs_[i], run_) || next_[i] >= run_.max_fixtures * legs_per_fixture) continue;
      if (!best || next_[i] < best->number) best = Leg{i, next_[i]};
    }
    return best;
  }

  std::string record_of(const Leg& leg) const {
    return record_path(run_, pairs_[leg.pair].teams, leg.number);
  }

  std::string answer_of(const Leg& leg) const { return record_of(leg) + ".answer"; }

  // Writes comparison.json, or compares with the one that is there.
  Result<void> open_folder() {
    MIROCUP_TRY(const auto wanted, comparison_identity(files_, run_));
    const std::string path = run_.folder + "/comparison.json";
    if (!files_.exists(path)) return files_.write(path, record::json_text(wanted, 1) + "\n");
    MIROCUP_TRY(const auto text, files_.read(path, {.max_size = system::size_limit::note}));
    MIROCUP_TRY(const auto there, record::read_json<Json>(
                                      text, path, Errc::input,
                                      [](const record::JsonReader& json) { return json.json(); }));
    for (const auto& [key, value] : wanted.items()) {
      if (there.contains(key) && there.at(key) == value) continue;
      return fail(Errc::input,
                  path + ": " + key + " is " +
                      (there.contains(key) ? record::json_text(there.at(key)) : "missing") +
                      ", and not " + record::json_text(value) +
                      ": the folder holds another comparison; name a new folder");
    }
    return {};
  }

  Result<void> start(const Leg& leg, int cpu) {
    const auto& teams = pairs_[leg.pair].teams;
    const std::uint64_t seed = comparison_seed(run_, teams, leg.number / legs_per_fixture);
    std::vector<std::string> arguments{system::sibling_program("mirocup"), "match"};
    arguments.insert(arguments.end(), {"--league", std::string(to_string(run_.league))});
    arguments.insert(arguments.end(), {"--seed", std::to_string(seed), "--record", record_of(leg)});
    for (const bool is_blue : {true, false}) {
      const std::string colour = is_blue ? "--blue" : "--yellow";
      const ComparedTeam team =
          compared_team(run_.teams[teams[is_blue == leg.is_swapped() ? 1 : 0]]);
      arguments.insert(arguments.end(), {colour, team.team});
      for (const std::string& parameter : team.parameters)
        arguments.insert(arguments.end(), {colour + "-param", parameter});
    }
    if (run_.half_s > 0.0) arguments.insert(arguments.end(), {"--half", digits(run_.half_s)});
    if (!run_.conditions.empty())
      arguments.insert(arguments.end(), {"--conditions", run_.conditions});
    arguments.insert(arguments.end(), run_.terms.begin(), run_.terms.end());
    arguments.insert(arguments.end(), {"--answer", answer_of(leg)});
    playing_[++tag_] = leg;
    MIROCUP_TRY_VOID(processes_.start(arguments, tag_, cpu, "/dev/null"));
    return {};
  }

  Result<void> count_child(const system::Exit& exit) {
    const Leg leg = playing_[exit.tag];
    playing_.erase(exit.tag);
    const Json answer = record::last_answer(files_, answer_of(leg)).value_or(Json());
    MIROCUP_TRY_VOID(files_.remove(answer_of(leg)));
    if (exit.signal != 0 || exit.code != exit_yes)
      return fail(exit.code == 2 ? Errc::input : Errc::host,
                  "a leg could not be played: " + record::text_in(answer, "error"));
    repeat_warnings(answer);
    return count(leg, false);
  }

  // Reads the record of a leg, and counts the fixtures of its pair of which both legs are there.
  Result<void> count(const Leg& leg, bool was_kept) {
    const std::string path = record_of(leg);
    MIROCUP_TRY(const auto text, files_.read(path, {.max_size = system::size_limit::record}));
    MIROCUP_TRY(const auto read, record::read_json<ComparedLeg>(
                                     text, path, run_.keeps_legs ? Errc::damaged : Errc::host,
                                     [&leg](const record::JsonReader& json) {
                                       return compared_leg(json, leg.is_swapped() ? 1 : 0);
                                     }));
    read_[leg] = read;
    read_[leg].record = path;
    if (!run_.keeps_legs) {
      for (const std::string& file : {path, record::replay_path_of(path)})
        MIROCUP_TRY_VOID(files_.remove(file));
    }
    PairComparison& pair = pairs_[leg.pair];
    while (!is_over(pair, run_)) {
      const int first = legs_per_fixture * static_cast<int>(pair.fixtures.size());
      const auto one = read_.find({leg.pair, first});
      const auto other = read_.find({leg.pair, first + 1});
      if (one == read_.end() || other == read_.end()) break;
      count_fixture(pair, {one->second, other->second}, run_);
      read_.erase(one);
      read_.erase(other);
      if (!was_kept) tell(pair);
    }
    return {};
  }

  // Says once of each parameter that no team asks for it.
  void repeat_warnings(const Json& answer) {
    if (!answer.contains("unknown_parameters")) return;
    for (const Json& name : answer["unknown_parameters"]) {
      const auto* text = name.get_ptr<const std::string*>();
      if (text && warnings_.insert(*text).second)
        progress_.say("warning: no team asked for the parameter " + *text);
    }
  }

  void tell(const PairComparison& pair) {
    const ComparisonInterval difference = pair.scores.difference(run_.test);
    std::ostringstream line;
    line.precision(0);
    line << std::fixed << run_.teams[pair.teams[0]] << " - " << run_.teams[pair.teams[1]]
         << ": fixture " << pair.fixtures.size() << ", " << difference.value << " Elo ("
         << difference.low << " to " << difference.high << ")";
    progress_.say(line.str());
  }

  system::Files& files_;
  const ComparisonRun& run_;
  ProgressReporter& progress_;
  system::ProcessSet processes_;
  std::vector<PairComparison> pairs_;
  std::vector<int> next_;            // by pair: the leg that is started next
  std::map<int, Leg> playing_;       // by tag of the child process
  std::map<Leg, ComparedLeg> read_;  // legs that are not counted yet
  std::set<std::string> warnings_;   // that have been said
  int tag_ = 0;
};

}  // namespace

Result<nlohmann::ordered_json> comparison_identity(system::Files& files, const ComparisonRun& run) {
  Json teams = Json::array();
  for (const std::string& team : run.teams) {
    const std::string path = compared_team(team).team;
    const std::string house = system::house_team(path);
    MIROCUP_TRY(const auto library,
                files.read_named(house.empty() ? path : house, system::size_limit::entry));
    teams.push_back({{"team", team}, {"sha256", system::sha256(library)}});
  }
  Json identity{{"schema", "mirocup/comparison/1"},
                {"game", record::this_software().behaviour_hash},
                {"teams", teams},
                {"league", to_string(run.league)},
                {"half_s", run.half_s},
                {"conditions", run.conditions},
                {"seed", run.seed}};
  if (!run.terms.empty()) identity["terms"] = run.terms;
  return identity;
}

ComparedTeam compared_team(const std::string& text) {
  ComparedTeam team{text, {}};
  for (;;) {
    const std::size_t colon = team.team.rfind(':');
    const std::size_t equals = team.team.find('=', colon);
    if (colon == std::string::npos || equals == std::string::npos || equals == colon + 1) break;
    team.parameters.insert(team.parameters.begin(), team.team.substr(colon + 1));
    team.team.resize(colon);
  }
  return team;
}

std::uint64_t comparison_seed(const ComparisonRun& run, const std::array<int, 2>& teams,
                              int fixture) {
  std::uint64_t seed = mix_seed(run.seed);
  for (const int number : {teams[0], teams[1], fixture})
    seed = mix_seed(seed ^ static_cast<std::uint64_t>(number));
  return seed >> 11;  // so that a double holds it, as in JSON
}

void count_fixture(PairComparison& pair, const std::array<ComparedLeg, 2>& legs,
                   const ComparisonRun& run) {
  int points = 0;
  for (const ComparedLeg& leg : legs) {
    const auto [one, other] = leg.score;
    points += leg.both_lose || one == other ? 1 : one > other ? 2 : 0;
    pair.trajectories.insert(leg.trajectory);
  }
  pair.courses.insert(legs[0].trajectory + '|' + legs[1].trajectory);
  pair.scores.add(points);
  pair.fixtures.push_back(legs);
  const int count = static_cast<int>(pair.fixtures.size());
  pair.is_of_copies = 2 * static_cast<int>(pair.courses.size()) < count;
  if (pair.is_of_copies || (run.plays_all && count < run.max_fixtures)) return;
  pair.verdict = pair.scores.verdict(run.test);
}

int kept_fixtures(system::Files& files, const ComparisonRun& run, const std::array<int, 2>& teams) {
  int legs = 0;
  while (files.exists(record_path(run, teams, legs))) ++legs;
  return legs / legs_per_fixture;
}

bool is_over(const PairComparison& pair, const ComparisonRun& run) {
  const int count = static_cast<int>(pair.fixtures.size());
  if (count >= run.max_fixtures) return true;
  if (pair.is_of_copies && count >= enough_to_see_copies) return true;
  return pair.verdict != ComparisonVerdict::undecided;
}

FixtureResults results_of(const std::array<ComparedLeg, 2>& legs, const LegResult& between) {
  FixtureResults results(legs.size(), between);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    std::tie(results[i].home_goals, results[i].away_goals) =
        std::tie(legs[i].score[0], legs[i].score[1]);
    results[i].both_lose = legs[i].both_lose;
  }
  return results;
}

Ratings rate(const ComparisonRun& run, const std::vector<PairComparison>& pairs) {
  std::vector<FixtureResults> results;
  for (const PairComparison& pair : pairs) {
    const LegResult between{.home = pair.teams[0], .away = pair.teams[1]};
    for (const auto& legs : pair.fixtures) results.push_back(results_of(legs, between));
  }
  return rate(static_cast<int>(run.teams.size()), results);
}

void add_terms(const system::Command& command, std::string& league, ComparisonRun& run) {
  command
      .option("--league", league,
              "Field and number of robots: small (3 a side), middle (5), large (11)")
      .one_of({"small", "middle", "large"})
      .shows_default();
  command.option("--half SECONDS", run.half_s, "Length of a half in seconds")
      .between(record::min_half_s, record::max_half_s);
  command
      .option("--conditions", run.conditions,
              "Conditions: exact, hall or camera (default: as in a match)")
      .one_of({"exact", "hall", "camera"});
}

Result<std::vector<PairComparison>> run_comparison(system::Files& files, const ComparisonRun& run,
                                                   ProgressReporter& progress) {
  return Comparison(files, run, progress).play();
}

}  // namespace mirocup::league
