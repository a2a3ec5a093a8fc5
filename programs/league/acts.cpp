// SPDX-License-Identifier: MIT
//
// The subcommands for what the staff decides: award, rule, void, withdraw, pause, resume, freeze,
// release, close, undo. Each decision is a line of the journal with a reason; the lines before it
// stay. Decisions may be made while the league is being played.
#include "tournaments/league/acts.hpp"

#include "programs/league/commands.hpp"
#include "programs/league/finals.hpp"
#include "programs/league/playing.hpp"
#include "programs/league/publishing.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/publish/site.hpp"

#include <array>

namespace mirocup::league {

namespace {

struct ActOptions : LeagueOptions {
  Act act;
  int legs = legs_per_fixture;  // of each pair in the closing round
  int jobs = 0;                 // legs of the closing round at once; 0: one for each processor
};

// Makes and plays the closing round. An interrupted one is continued by `league start`.
Result<int> play_closing_round(system::Files& files, const LeagueStore& season,
                               const LeagueFile& file, int jobs) {
  const Folder folder = season.folder().closing_round();
  MIROCUP_TRY_VOID(init_from(files, season, folder, file, true));
  MIROCUP_TRY_VOID(publish_league(files, season.folder(), jobs));
  MIROCUP_TRY(auto held, hold_league(files, folder, ""));
  MIROCUP_TRY(const auto end, play_and_publish(files, std::move(held.store), {{.jobs = jobs}}));
  std::cout << table_text(end.state);
  return exit_code_of(end, end.state);
}

Result<int> run_act(system::Files& files, LeagueStore& store, const ActOptions& options) {
  LeagueFile closing;
  if (!options.act.final.empty()) {
    MIROCUP_TRY(closing, closing_round(files, store, *from_string<FormatKind>(options.act.final),
                                       options.legs));
    if (files.exists(store.folder().closing_round().config()))
      return fail(Errc::input, options.folder + "/final is there already: mirocup league start " +
                                   options.folder + "/final continues it");
  }
  MIROCUP_TRY(const auto lines, perform(files, store, options.act, system::now_s()));
  for (const std::string& line : lines) std::cout << system::printable(line) << '\n';
  // What is held back must not stay on the pages, and what is released is looked for there.
  if (options.act.kind == ActKind::release && !options.act.is_dry_run &&
      files.exists(store.folder().site())) {
    return publish_league(files, store.folder());
  }
  if (options.act.final.empty()) return exit_yes;
  std::cout << closing.teams.size() << " teams, " << new_league(closing).legs()
            << " legs in the closing round, " << options.folder << "/final\n"
            << std::flush;
  return options.act.is_dry_run ? exit_yes
                                : play_closing_round(files, store, closing, options.jobs);
}

// The description of an act in the help, and an example of its subcommand.
struct ActHelp {
  ActKind kind;
  const char* description;
  const char* example;
};

constexpr std::array<ActHelp, 10> act_helps{{
    {ActKind::award, "Award legs to a team, as if its opponent had forfeited",
     "mirocup league award spring r3-f1 alpha --all-legs --reason \"beta left\""},
    {ActKind::rule, "Decide the score of a leg, or of all legs",
     "mirocup league rule spring r3-f1 --leg 1 --score 2:1 --reason \"appeal 4\""},
    {ActKind::void_, "Declare legs void; they are played again with another seed",
     "mirocup league void spring r3-f1 --leg 2 --reason \"power cut\""},
    {ActKind::withdraw, "Take a team out of the league",
     "mirocup league withdraw spring beta --reason \"left the course\""},
    {ActKind::pause, "Start no legs of a team until it is resumed",
     "mirocup league pause spring beta --reason \"is looked at\""},
    {ActKind::resume, "Let a paused team play again",
     "mirocup league resume spring beta --reason \"repaired\""},
    {ActKind::freeze, "Stop taking entries, now or at a given time",
     "mirocup league freeze spring --reason \"last day\""},
    {ActKind::release, "Choose the rounds that the pages show",
     "mirocup league release spring --through r3 --reason \"it is Friday\""},
    {ActKind::close, "End a league: it has no further night and takes no entry",
     "mirocup league close spring --reason \"the term is over\""},
    {ActKind::undo, "Take a decision back",
     "mirocup league undo spring 3 --reason \"the wrong leg\""},
}};

void add_fixture(const system::Command& command, Act& act) {
  command.option("FIXTURE", act.fixture, "Id of the fixture, as in r3-f1").required();
  const system::Option leg =
      command.option("--leg NUMBER", act.leg, "Number of the leg: 1, 2 or 3").between(1, 3);
  command.flag("--all-legs", act.has_all_legs, "All legs of the fixture").excludes(leg);
}

void add_freeze(const system::Command& command, Act& act) {
  const system::Option at =
      command.option("--at TIME", act.from,
                     "Time in the league's zone (\"2026-11-30 18:00\"), or "
                     "with an offset (+01:00) or Z at its end (default: now)");
  command.flag("--lift", act.is_lifted, "Take entries again").excludes(at);
  const system::Option except = command.option(
      "--except TEAM", act.except,
      "Let this team alone hand in longer, until --until; then the reason is not published");
  except.excludes(at);
  command.option("--until TIME", act.from, "Until when, in the forms of --at").needs(except);
}

void add_close(const system::Command& command, ActOptions& options) {
  const system::Option final =
      command.option("--final", options.act.final,
                     "Play a closing round of the last entries in DIR/final, which decides the "
                     "season: every pair plays equally often");
  final.one_of({"double_round_robin", "round_robin"});
  command.option("--legs", options.legs, "Legs of each pair in the closing round (1 to 100)")
      .between(1, 100)
      .needs(final);
  command.jobs(options.jobs, "legs of the closing round played");
}

void add_release(const system::Command& command, Act& act) {
  act.level = "all";
  command
      .option("--level", act.level,
              "Who sees later rounds: all (everybody), teams (each team reads its own digest), "
              "hidden (nobody)")
      .one_of({"all", "teams", "hidden"})
      .shows_default();
  command.option("--through ROUND", act.through,
                 "Last round that the pages show, r3 or k1 (default: every round with --level all, "
                 "otherwise none)");
}

// Adds the options that no other act has.
void add_own_options(const system::Command& command, Act& act) {
  if (act.kind == ActKind::rule)
    command.option("--score HOME:AWAY", act.score, "Goals of the home team and of the away team")
        .required();
  if (act.kind == ActKind::void_)
    command.flag("--same-seed", act.keeps_seed,
                 "Keep the seed: the same libraries then play the same leg again");
  if (act.kind == ActKind::withdraw) {
    act.results = "keep";
    command.option("--results", act.results, "Keep the team's results, or annul them")
        .one_of({"keep", "annul"})
        .shows_default();
  }
  if (act.kind == ActKind::freeze) add_freeze(command, act);
  if (act.kind == ActKind::release) add_release(command, act);
  if (act.kind == ActKind::undo)
    command.option("NUMBER", act.decision, "Number of the decision, as league decisions lists it")
        .required();
}

}  // namespace

void add_acts(system::Commands& commands) {
  for (const auto& [kind, description, example] : act_helps) {
    const auto [command, options] =
        add_command(commands, on_own_league<run_act, ActOptions>, to_string(kind).data(),
                    kind == ActKind::release ? to_show : to_rule, description, {example});
    Act& act = options.act;
    act.kind = kind;
    if (kind == ActKind::award || kind == ActKind::rule || kind == ActKind::void_)
      add_fixture(command, act);
    if (kind == ActKind::award || kind == ActKind::withdraw || kind == ActKind::pause ||
        kind == ActKind::resume)
      command.option("TEAM", act.team, "Name of the team").required();
    add_own_options(command, act);
    if (kind == ActKind::close) add_close(command, options);
    command.option("--reason TEXT", act.reason, "Reason, which is published").required();
    command.option("--by NAME", act.by, "Name of the person who decides; it is published");
    command.flag("--dry-run", act.is_dry_run, "Print what would change, and change nothing");
  }
}

}  // namespace mirocup::league
