// SPDX-License-Identifier: MIT
//
// The subcommand tune.
#include "core/base/random.hpp"
#include "labs/programs/commands.hpp"
#include "labs/tune/tuning_file.hpp"
#include "record/json_reader.hpp"
#include "system/number_of.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"
#include "tournaments/play/comparison_run.hpp"
#include "tournaments/play/scratch_folder.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

namespace mirocup::labs {

using namespace league;

namespace {

struct TuneOptions {
  std::string team;                     // as in compare
  std::vector<std::string> parameters;  // KEY=LOW:HIGH
  std::vector<std::string> against;
  std::string league = "small";
  ComparisonRun run;  // half, conditions and jobs; the teams are filled in
  TuningOptions tuning;
  std::string folder = "tune";
  bool json = false;
};

using TuningJson = nlohmann::ordered_json;

// The fixtures of a candidate need no lines of their own.
class Silence : public ProgressReporter {
 public:
  void say(const std::string& line) override {
    if (line.find("warning: ") != std::string::npos) warning = line;
  }
  void update(int, int, int) override {}

  std::string warning;  // the last one
};

std::string short_text(double number) {
  return system::formatted("%.6g", number);
}

// Without the sign of a zero.
std::string rounded(double number) {
  const std::string text = system::formatted("%.2f", number);
  return text == "-0.00" ? "0.00" : text;
}

// KEY=LOW:HIGH
Result<TunedParameter> parameter_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.find(':', equals == std::string::npos ? 0 : equals);
  if (equals != std::string::npos && equals > 0 && colon != std::string::npos) {
    const auto low = system::number_of<double>(text.substr(equals + 1, colon - equals - 1));
    const auto high = system::number_of<double>(text.substr(colon + 1));
    if (low && high && *low < *high)
      return TunedParameter{.name = text.substr(0, equals), .low = *low, .high = *high};
  }
  return fail(Errc::input,
              "--param " + text + ": KEY=LOW:HIGH is expected, with LOW less than HIGH");
}

std::string with_parameters(const std::string& team, const TuningOptions& options,
                            const std::optional<std::vector<double>>& values) {
  std::string text = team;
  for (std::size_t i = 0; values && i < values->size(); ++i) {
    text += ":" + options.parameters[i].name + "=" + short_text((*values)[i]);
  }
  return text;
}

// The marks of the first team of a comparison against the others.
std::vector<Mark> marks_of(const std::vector<PairComparison>& pairs) {
  std::size_t fixtures = pairs.front().fixtures.size();
  for (const PairComparison& pair : pairs) fixtures = std::min(fixtures, pair.fixtures.size());
  std::vector<Mark> marks(fixtures);
  const double legs = 2.0 * static_cast<double>(pairs.size());
  for (const PairComparison& pair : pairs) {
    for (std::size_t i = 0; i < fixtures; ++i) {
      for (const ComparedLeg& leg : pair.fixtures[i]) {
        const auto [own, other] = leg.score;
        marks[i].goals += (own - other) / legs;
        marks[i].points += (leg.both_lose  ? 0.0
                            : own > other  ? 1.0
                            : own == other ? 0.5
                                           : 0.0) /
                           legs;
      }
    }
  }
  return marks;
}

// Plays candidates, tells how the search gets on, and keeps both in its folder.
class Search {
 public:
  Search(system::Files& files, const TuneOptions& options, TuningOptions tuning, TuningFile file,
         std::string scratch, ProgressReporter& progress)
      : files_(files),
        options_(options),
        tuning_(std::move(tuning)),
        file_(std::move(file)),
        scratch_(std::move(scratch)),
        progress_(progress),
        begin_(std::chrono::steady_clock::now()) {}

  Result<TuningResult> run() {
    return tune(
        tuning_,
        [this](const auto& values, std::uint64_t seed, int fixtures) {
          return play(values, seed, fixtures);
        },
        [this](const std::vector<Generation>& course) { return tell(course); });
  }

 private:
  Result<std::vector<Mark>> play(const std::optional<std::vector<double>>& values,
                                 std::uint64_t seed, int fixtures) {
    const std::string team = with_parameters(options_.run.teams.front(), tuning_, values);
    const std::string key = team + " " + std::to_string(seed) + " " + std::to_string(fixtures);
    if (const auto* known = file_.find(key)) return *known;
    ComparisonRun run = options_.run;
    run.teams.front() = team;
    run.league = *from_string<RobotLeague>(options_.league);
    run.seed = seed;
    run.max_fixtures = fixtures;
    run.plays_all = true;
    run.folder = scratch_;
    Silence silence;
    const auto pairs = run_comparison(files_, run, silence);
    if (!pairs && pairs.error().code == Errc::interrupted) {
      return fail(Errc::interrupted,
                  "interrupted; the same command continues from " + options_.folder);
    }
    if (!pairs) return tl::unexpected(pairs.error());
    if (!silence.warning.empty() && std::exchange(warning_, silence.warning).empty()) {
      progress_.say(silence.warning);
    }
    auto marks = marks_of(*pairs);
    MIROCUP_TRY_VOID(file_.keep(key, marks));
    fixtures_played_ += fixtures;
    return marks;
  }

  Result<void> tell(const std::vector<Generation>& course) {
    const Generation& now = course.back();
    std::string line = "generation " + std::to_string(course.size()) + " of " +
                       std::to_string(tuning_.generations) + ": " + rounded(now.goals) +
                       " goals a leg;";
    for (std::size_t i = 0; i < now.mean.size(); ++i) {
      line += system::formatted(" %s %.4g +- %.2g,", tuning_.parameters[i].name.c_str(),
                                now.mean[i], now.deviation[i]);
    }
    line.pop_back();
    progress_.say(line + "; " + time_left(course));
    return files_.write(options_.folder + "/course.svg", course_svg(tuning_, course));
  }

  // From the fixtures of this start: those that were known took no time. The candidates of later
  // generations play as many fixtures as now, or twice as many each time, up to the most.
  std::string time_left(const std::vector<Generation>& course) const {
    if (fixtures_played_ == 0) return "known already";
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const double candidates = static_cast<double>(course.front().played) / course.front().fixtures;
    double least = 2.0 * tuning_.test_fixtures, most = least;
    int fixtures = course.back().fixtures;
    for (int k = static_cast<int>(course.size()); k < tuning_.generations; ++k) {
      fixtures = std::min(tuning_.most_fixtures, 2 * fixtures);
      least += candidates * course.back().fixtures;
      most += candidates * fixtures;
    }
    const auto minutes = [&](double count) {
      return short_text(std::ceil(count * seconds / fixtures_played_ / 60.0));
    };
    const std::string soon = minutes(least), late = minutes(most);
    return soon == late ? soon + " min left" : soon + " to " + late + " min left";
  }

  system::Files& files_;
  const TuneOptions& options_;
  TuningOptions tuning_;
  TuningFile file_;
  std::string scratch_;
  ProgressReporter& progress_;
  std::chrono::steady_clock::time_point begin_;
  int fixtures_played_ = 0;
  std::string warning_;
};

TuningJson gain_json(const Gain& gain, double before, double after) {
  return {{"gain", gain.value},
          {"low", gain.low},
          {"high", gain.high},
          {"before", before},
          {"after", after}};
}

void print_result(const TuningResult& result, const TuningOptions& tuning,
                  const TuneOptions& options) {
  const std::string& team = options.run.teams.front();
  if (options.json) {
    TuningJson parameters = TuningJson::object();
    for (std::size_t i = 0; i < result.values.size(); ++i) {
      parameters[tuning.parameters[i].name] = result.values[i];
    }
    std::cout << record::json_text(
                     {{"team", system::printable(team)},
                      {"parameters", parameters},
                      {"gained", result.has_gained()},
                      {"points",
                       gain_json(result.points, result.before.points, result.after.points)},
                      {"goals", gain_json(result.goals, result.before.goals, result.after.goals)},
                      {"test_fixtures", result.test_fixtures},
                      {"generations", result.course.size()},
                      {"fixtures", result.course.back().played}})
              << '\n';
    return;
  }
  std::string words, pairs;
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    pairs += ":" + tuning.parameters[i].name + "=" + short_text(result.values[i]);
    words += " --param " + tuning.parameters[i].name + "=" + short_text(result.values[i]);
  }
  const auto interval = [](const Gain& gain) {
    return rounded(gain.value) + ", 95 % interval " + rounded(gain.low) + " to " +
           rounded(gain.high);
  };
  std::cout << system::printable(team)
            << (result.has_gained() ? " is better with" : ": no gain can be claimed for") << words
            << "\n  points a leg  " << rounded(result.before.points) << " before, "
            << rounded(result.after.points) << " with them: gain " << interval(result.points)
            << "\n  goals a leg   " << rounded(result.before.goals) << " before, "
            << rounded(result.after.goals) << " with them: gain " << interval(result.goals)
            << "\n  test          " << result.test_fixtures
            << " fixtures of two legs against each opponent, on fresh seeds\n  course        "
            << system::printable(options.folder)
            << "/course.svg\n  to decide     mirocup league compare " << system::printable(team)
            << pairs << ' ' << system::printable(team) << '\n';
}

Result<int> run_tune(const TuneOptions& options) {
  TuningOptions tuning = options.tuning;
  for (const std::string& text : options.parameters) {
    MIROCUP_TRY(auto parameter, parameter_of(text));
    for (const TunedParameter& other : tuning.parameters) {
      if (other.name == parameter.name)
        return fail(Errc::input, "--param " + text + ": this parameter is named twice");
    }
    tuning.parameters.push_back(std::move(parameter));
  }
  tuning.most_fixtures = std::max(tuning.fixtures, tuning.most_fixtures);
  TuneOptions all = options;
  all.run.teams = {options.team};
  for (const std::string& opponent : options.against) all.run.teams.push_back(opponent);
  all.run.league = *from_string<RobotLeague>(options.league);
  system::Disk disk;
  MIROCUP_TRY(auto identity, comparison_identity(disk, all.run));
  identity.erase("seed");
  identity["parameters"] = options.parameters;
  const ScratchFolder scratch("mirocup-tune");
  if (scratch.path().empty()) return fail(Errc::unavailable, "no folder for the legs can be made");
  MIROCUP_TRY(auto file, TuningFile::open(disk, options.folder, identity));
  const auto progress = make_progress_reporter();
  MIROCUP_TRY(const auto result,
              Search(disk, all, tuning, std::move(file), scratch.path(), *progress).run());
  print_result(result, tuning, all);
  return result.has_gained() ? exit_yes : exit_no;
}

}  // namespace

void add_tune(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_tune, "tune", for_teams, "Find better values for a team's parameters",
                   {"mirocup tune mine.so --param wait=0.3:0.6 --against chaser,striker"});
  TuningOptions& t = o.tuning;
  command.option("TEAM", o.team, "Library, or name of a house team").required();
  command.option("--param KEY=LOW:HIGH", o.parameters, "Parameter of the team, and its range")
      .required();
  command.option("--against TEAM,TEAM", o.against, "Opponents, with commas between them")
      .split_at(',')
      .required();
  add_terms(command, o.league, o.run);
  command.option("--seed SEED", t.seed, "Seed of the search and of its fixtures")
      .is_a_seed()
      .shows_default();
  command.jobs(o.run.jobs, "legs played");
  command.option("--generations NUMBER", t.generations, "Generations of the search")
      .between(1, 10'000)
      .shows_default();
  command
      .option("--fixtures NUMBER", t.fixtures,
              "Fixtures (two legs each) that each candidate of the first generation plays against "
              "each opponent; later generations play more fixtures if their results are noisy")
      .between(2, 1000)
      .shows_default();
  command
      .option("--test NUMBER", t.test_fixtures,
              "Fixtures that the test at the end plays against each opponent")
      .between(10, 100'000)
      .shows_default();
  command
      .option("-o,--output DIR", o.folder,
              "Folder for the played fixtures and the picture; the same command, called again, "
              "continues from it")
      .shows_default();
  command.flag("--json", o.json, "Print one JSON object");
}

}  // namespace mirocup::labs
