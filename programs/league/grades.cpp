// SPDX-License-Identifier: MIT
//
// mirocup league grades: a row for each team, or for each student.
#include "tournaments/publish/grades.hpp"

#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "tournaments/league/class_list.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/play/comparison_run.hpp"
#include "tournaments/play/leg_command.hpp"
#include "tournaments/publish/exports.hpp"

#include <algorithm>
#include <set>

namespace mirocup::league {

namespace {

struct GradesOptions : LeagueOptions {
  std::string drills;  // the output of mirocup drill --csv; "": none
  std::string output;
  bool per_member = false;
  bool moodle = false;
  bool gradescope = false;
  std::string scale;  // a file of read_scale(); "": none
  bool decide = false;
  int most = 100;  // fixtures of a team against a house team
  int jobs = 0;
};

// The marks of a league by a scale.
class Marking {
 public:
  Marking(system::Files& files, const LeagueStore& store, const GradesOptions& options)
      : files_(files), store_(store), state_(store.state()), options_(options) {}

  Result<MarksOfTeams> marks() {
    MIROCUP_TRY(const auto text, files_.read_named(options_.scale, system::size_limit::note));
    MIROCUP_TRY(scale_, read_scale(text, options_.scale));
    const Ratings before = state_.ratings();
    table_ = state_.table(before);
    std::erase_if(table_, [](const TableRow& row) { return row.played == 0; });
    MIROCUP_TRY_VOID(find_steps());
    MIROCUP_TRY_VOID(decide(before));
    const Ratings ratings = state_.ratings(further_);
    MarksOfTeams marks(state_.teams.size());
    for (const TableRow& row : table_) {
      marks[row.team] = mark_of(ratings, steps_, scale_.below, row.team);
      if (!marks[row.team])
        return fail(Errc::input, options_.scale +
                                     ": by the legs that were played, a house team of the scale is "
                                     "not stronger than the one before it");
      marks[row.team]->is_decided = !undecided_.contains(row.team);
    }
    return marks;
  }

 private:
  Result<void> find_steps() {
    for (const NamedStep& step : scale_.steps) {
      const auto found = std::find_if(table_.begin(), table_.end(), [&](const TableRow& row) {
        return state_.file.teams[row.team].source == "house:" + step.beats;
      });
      if (found == table_.end())
        return fail(Errc::input,
                    options_.scale + ": no team of the league has played as house:" + step.beats);
      steps_.push_back({step.mark, found->team});
    }
    return {};
  }

  // Notes the teams of which the league's legs do not decide whether they are better than a step.
  // With --decide, such teams play further legs until a test that may stop at any time decides.
  Result<void> decide(const Ratings& before) {
    const auto progress = options_.decide ? make_progress_reporter() : nullptr;
    for (const TableRow& row : table_) {
      for (std::size_t step = 0; step < steps_.size(); ++step) {
        const int house = steps_[step].team;
        if (house == row.team || are_apart(before, row.team, house)) continue;
        const TeamConfig& config = state_.file.teams[row.team];
        const bool can_play = options_.decide && !config.is_house() && !config.is_on_network();
        if (can_play) {
          MIROCUP_TRY(const auto verdict,
                      play(row.team, house, scale_.steps[step].beats, *progress));
          if (verdict != ComparisonVerdict::undecided) continue;
        }
        undecided_.insert(row.team);
      }
    }
    return {};
  }

  Result<ComparisonVerdict> play(int team, int house, const std::string& name,
                                 ProgressReporter& progress) {
    const TeamConfig& config = state_.file.teams[team];
    const int entry = state_.teams[team].entry;
    ComparisonRun run;
    run.teams = {store_.folder().library(config.name, entry), name};
    for (const auto& [key, value] : config.parameters)
      run.teams[0] += ":" + key + "=" + record::json_text(Json(value));
    run.league = state_.file.league;
    run.terms = term_options(state_);
    run.seed = state_.file.seed;
    run.jobs = options_.jobs;
    run.max_fixtures = options_.most;
    const std::string home = store_.folder().path + "/marks";
    run.folder = home + "/" + config.name + "-" + std::to_string(entry) + "-" + name;
    run.keeps_legs = true;
    MIROCUP_TRY_VOID(files_.make_folder(home, system::Readers::owner));
    MIROCUP_TRY_VOID(files_.make_folder(run.folder, system::Readers::owner));
    MIROCUP_TRY(const auto pairs, run_comparison(files_, run, progress));
    for (const auto& legs : pairs[0].fixtures) {
      further_.emplace_back();
      for (const ComparedLeg& leg : legs) {
        further_.back().push_back({.home = team,
                                   .away = house,
                                   .home_goals = leg.score[0],
                                   .away_goals = leg.score[1],
                                   .both_lose = leg.both_lose,
                                   .home_entry = entry,
                                   .away_entry = state_.teams[house].entry});
      }
    }
    return pairs[0].verdict;
  }

  system::Files& files_;
  const LeagueStore& store_;
  const LeagueState& state_;
  const GradesOptions& options_;
  std::vector<TableRow> table_;  // the teams that have played
  Scale scale_;
  std::vector<ScaleStep> steps_;
  std::vector<FixtureResults> further_;
  std::set<int> undecided_;
};

GradesLayout layout_of(const GradesOptions& options) {
  if (options.moodle) return GradesLayout::moodle;
  if (options.gradescope) return GradesLayout::gradescope;
  return options.per_member ? GradesLayout::members : GradesLayout::teams;
}

Result<int> run_grades(system::Files& files, const LeagueStore& store,
                       const GradesOptions& options) {
  MIROCUP_TRY(const auto found, say_gaps(files, store));
  const int result = found.lost.empty() ? exit_yes : exit_no;
  std::string drills;
  if (!options.drills.empty()) {
    MIROCUP_TRY(drills, files.read_named(options.drills, system::size_limit::note));
  }
  MIROCUP_TRY_VOID(spare_class_list(files, store.folder(),
                                    options.output.empty() ? "/proc/self/fd/1" : options.output));
  MIROCUP_TRY(const auto people, everybody(files, store));
  MarksOfTeams marks;
  if (!options.scale.empty()) {
    MIROCUP_TRY(marks, Marking(files, store, options).marks());
  }
  MIROCUP_TRY(const auto file, grades(overview(store.state()), people, drills, options.drills,
                                      layout_of(options), marks));
  if (options.output.empty()) {
    std::cout << file.bytes;
    return result;
  }
  MIROCUP_TRY_VOID(files.write(options.output, file.bytes, system::Readers::owner));
  std::cout << options.output << '\n';
  return result;
}

}  // namespace

void add_grades(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, on_league<run_grades, GradesOptions>, "grades", to_show,
                  "Print the figures for a lecturer's grades, as CSV",
                  {"mirocup league grades spring --drills drills.csv -o grades.csv",
                   "mirocup league grades spring --moodle -o moodle.csv"});
  command.option("--drills FILE", o.drills,
                 "File with the marks of the teams, as mirocup drill --csv prints them");
  const system::Option per_member =
      command.flag("--per-member", o.per_member, "Write a row for each member of a team");
  const system::Option moodle =
      command.flag("--moodle", o.moodle,
                   "Write a row for each student, as Moodle's grade import reads it; the class "
                   "list needs a column mail or number");
  const system::Option gradescope = command.flag(
      "--gradescope", o.gradescope, "Write a row for each student, with Gradescope's columns");
  moodle.excludes(per_member).excludes(gradescope);
  gradescope.excludes(per_member);
  const system::Option scale =
      command.option("--scale FILE", o.scale,
                     "Scale of marks, JSON: [{\"mark\": 5.0}, {\"mark\": 4.0, \"beats\": "
                     "\"chaser\"}, {\"mark\": 1.0, \"beats\": \"tactician\"}]; linear in "
                     "strength between the house teams");
  scale.excludes(gradescope);
  const system::Option decide =
      command.flag("--decide", o.decide,
                   "Play further legs against the house teams of the scale, until it is decided "
                   "at 1 in 20 which is better; the legs lie in DIR/marks");
  decide.needs(scale);
  command
      .option("--most NUMBER", o.most,
              "Most fixtures (two legs each) of a team against a house team")
      .between(1, 100'000)
      .shows_default()
      .needs(decide);
  command.jobs(o.jobs, "legs of --decide played");
  command.option("-o,--output DIR", o.output,
                 "File to write to, which only you can then read (default: standard output)");
}

}  // namespace mirocup::league
