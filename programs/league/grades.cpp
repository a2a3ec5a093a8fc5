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
  bool release = false;
  int most = 100;  // fixtures of a team against a house team
  int jobs = 0;
};

// The marks of a league by a scale.
struct Marking {
  system::Files& files;
  const Folder& folder;
  const Overview& league;
  const GradesOptions& options;
  const LeagueState& state = league.state;
  Scale scale = {};
  std::vector<ScaleStep> steps = {};
  // By team: what --decide has played. It counts for this team alone: a test that stops when it is
  // sure favours the one that is ahead, and the marks of the others would follow.
  std::map<int, std::vector<FixtureResults>> further = {};
  std::set<int> undecided = {};
  std::map<int, Json> legs = {};  // by team: those against steps, for page/team_desk.html

  Result<MarksOfTeams> marks() {
    MIROCUP_TRY(const auto text, files.read_named(options.scale, system::size_limit::note));
    MIROCUP_TRY(scale, read_scale(text, options.scale));
    MIROCUP_TRY_VOID(find_steps());
    note_legs_of_league();
    MIROCUP_TRY_VOID(decide());
    MarksOfTeams marks(state.teams.size());
    for (const TableRow& row : league.table) {
      if (row.played == 0) continue;
      const auto& own = further[row.team];
      auto& mark = marks[row.team] =
          mark_of(own.empty() ? league.ratings : state.ratings(own), steps, scale.below, row.team);
      if (!mark)
        return fail(Errc::input, options.scale +
                                     ": by the legs that were played, a house team of the scale is "
                                     "not stronger than the one before it");
      mark->is_decided = !undecided.contains(row.team);
      mark->legs = row.played + legs_per_fixture * static_cast<int>(own.size());
    }
    return marks;
  }

  // Lets each team see its mark; a later release replaces all.
  Result<void> release(const MarksOfTeams& marks) {
    const auto number = [](double mark) { return system::formatted("%.2f", mark); };
    Json shown{{"below", number(scale.below)}, {"steps", Json::array()}};
    for (const NamedStep& step : scale.steps)
      shown["steps"].push_back({{"mark", number(step.mark)}, {"beats", step.beats}});
    MIROCUP_TRY_VOID(files.make_folder(folder.marks(), system::Readers::owner));
    for (std::size_t team = 0; team < marks.size(); ++team) {
      const std::string path = folder.released_mark(state.file.teams[team].name);
      const auto& mark = marks[team];
      MIROCUP_TRY_VOID(files.remove(path));
      if (!mark || state.file.teams[team].is_house()) continue;
      shown.update({{"mark", number(mark->value)},
                    {"low", number(mark->low)},
                    {"high", number(mark->high)},
                    {"is_decided", mark->is_decided},
                    {"count", mark->legs},
                    {"legs", legs[static_cast<int>(team)]}});
      MIROCUP_TRY_VOID(files.write(path, record::json_text(shown) + "\n", system::Readers::owner));
    }
    return {};
  }

  Result<void> find_steps() {
    for (const NamedStep& step : scale.steps) {
      const auto& table = league.table;
      const auto found = std::ranges::find_if(table, [&](const TableRow& row) {
        return row.played > 0 && state.file.teams[row.team].source == "house:" + step.beats;
      });
      if (found == table.end())
        return fail(Errc::input,
                    options.scale + ": no team of the league has played as house:" + step.beats);
      steps.push_back({step.mark, found->team});
    }
    return {};
  }

  void note_leg(int team, int house, int goals, int against, const std::string& record) {
    legs[team].push_back({{"number", legs[team].size() + 1},
                          {"opponent", state.shown_name(house)},
                          {"score", std::to_string(goals) + " : " + std::to_string(against)},
                          {"record", record}});
  }

  void note_legs_of_league() {
    for (const ScaleStep& step : steps) {
      for (const LegView& leg : league.legs) {
        if (!leg.is_of(step.team) || !leg.has_replay()) continue;
        const int team = leg.other(step.team);
        if (leg.counts_for(team))
          note_leg(team, step.team, leg.goals(team), leg.goals(step.team), leg.played->record);
      }
    }
  }

  // Notes the teams of which the league's legs do not decide whether they are better than a step.
  // With --decide, such teams play further legs until a test that may stop at any time decides.
  // Without it, the legs of an earlier --decide count, so that each call gives the same marks.
  Result<void> decide() {
    const auto progress = make_progress_reporter();
    for (const TableRow& row : league.table) {
      for (std::size_t step = 0; row.played > 0 && step < steps.size(); ++step) {
        const int house = steps[step].team;
        if (house == row.team || are_apart(league.ratings, row.team, house)) continue;
        const TeamConfig& config = state.file.teams[row.team];
        if (!config.is_house() && !config.is_on_network()) {
          MIROCUP_TRY(const auto verdict,
                      play(row.team, house, scale.steps[step].beats, *progress));
          if (verdict != ComparisonVerdict::undecided) continue;
        }
        undecided.insert(row.team);
      }
    }
    return {};
  }

  Result<ComparisonVerdict> play(int team, int house, const std::string& name,
                                 ProgressReporter& progress) {
    const TeamConfig& config = state.file.teams[team];
    const int entry = state.teams[team].entry;
    ComparisonRun run;
    run.teams = {folder.library(config.name, entry), name};
    for (const auto& [key, value] : config.parameters)
      run.teams[0] += ":" + key + "=" + record::json_text(Json(value));
    run.league = state.file.league;
    run.terms = term_options(state);
    run.seed = state.file.seed;
    run.jobs = options.jobs;
    run.folder = folder.marks() + "/" + config.name + "-" + std::to_string(entry) + "-" + name;
    run.keeps_legs = true;
    run.max_fixtures = options.decide ? options.most : kept_fixtures(files, run, {0, 1});
    if (run.max_fixtures == 0) return ComparisonVerdict::undecided;
    MIROCUP_TRY_VOID(files.make_folder(folder.marks(), system::Readers::owner));
    MIROCUP_TRY_VOID(files.make_folder(run.folder, system::Readers::owner));
    MIROCUP_TRY(const auto pairs, run_comparison(files, run, progress));
    const LegResult between{
        .home = team, .away = house, .home_entry = entry, .away_entry = state.teams[house].entry};
    for (const auto& played : pairs[0].fixtures) {
      further[team].push_back(results_of(played, between));
      for (const ComparedLeg& leg : played)
        note_leg(team, house, leg.score[0], leg.score[1],
                 leg.record.substr(folder.path.size() + 1));
    }
    return pairs[0].verdict;
  }
};

GradesLayout layout_of(const GradesOptions& options) {
  if (options.moodle) return GradesLayout::moodle;
  if (options.gradescope) return GradesLayout::gradescope;
  return options.per_member ? GradesLayout::members : GradesLayout::teams;
}

Result<int> run_grades(system::Files& files, const LeagueStore& store,
                       const GradesOptions& options) {
  if (options.release && options.scale.empty() && options.drills.empty())
    return fail(Errc::input, "--release needs --scale, --drills or both: what may teams see?");
  MIROCUP_TRY(const auto found, say_gaps(files, store));
  const int result = found.lost.empty() ? exit_yes : exit_no;
  std::string drills;
  if (!options.drills.empty()) {
    MIROCUP_TRY(drills, files.read_named(options.drills, system::size_limit::note));
  }
  MIROCUP_TRY_VOID(spare_class_list(files, store.folder(),
                                    options.output.empty() ? "/proc/self/fd/1" : options.output));
  MIROCUP_TRY(const auto people, everybody(files, store));
  const Overview league = overview(store.state());
  Marking marking{files, store.folder(), league, options};
  MarksOfTeams marks;
  if (!options.scale.empty()) {
    MIROCUP_TRY(marks, marking.marks());
  }
  MIROCUP_TRY(const auto file,
              grades(league, people, drills, options.drills, layout_of(options), marks));
  if (options.release && !drills.empty()) {
    MIROCUP_TRY(const auto scores, scores_of_sheets(drills, options.drills));
    MIROCUP_TRY_VOID(release_scores(files, store.folder(), store.state().file, scores));
  }
  if (options.release && !options.scale.empty()) MIROCUP_TRY_VOID(marking.release(marks));
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
  command.flag(
      "--release", o.release,
      "Let each team see on its page of serve --hand-in: its scores in the sheets of "
      "--drills; with --scale its mark, and the legs against the house teams of the scale");
  command.option("-o,--output FILE", o.output,
                 "File to write to, which only you can then read (default: standard output)");
}

}  // namespace mirocup::league
