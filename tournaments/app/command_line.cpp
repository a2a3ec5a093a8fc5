// SPDX-License-Identifier: MIT
//
// The only source that includes CLI11, which takes long to compile.
#include "tournaments/app/command_line.hpp"

#include "server/record/match_record.hpp"
#include "server/record/rules_json.hpp"
#include "system/command_help.hpp"
#include "system/command_line.hpp"
#include "system/locations.hpp"
#include "system/users.hpp"
#include "tournaments/app/commands.hpp"
#include "tournaments/format/format.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace mirocup::league {

namespace {

// The subcommands that write into the league's folder. `serve` does if it takes entries.
constexpr std::string_view writers =
    " submit owner start nightly publish plan team token credentials award rule void withdraw "
    "pause resume freeze release close undo ";

// Refuses to write to a league of another user (Errc::unavailable), who could then not write to
// what this user makes.
Result<void> expect_owner(const std::string& folder) {
  const auto owner = system::owner_of(Folder{folder}.config());
  if (!owner || *owner == system::this_user()) return {};
  const std::string name = system::name_of_user(*owner);
  return fail(Errc::unavailable,
              folder + " belongs to " + name +
                  ", who must be able to write to all files in it: run this as " + name +
                  " (sudo -u), or give the folder to " + system::name_of_user(system::this_user()) +
                  " (chown -R)");
}

// A subcommand, the object that its options are written to, and the function that runs with it.
template <class Options>
struct Subcommand {
  Subcommand(CLI::App& app, Action& action, const char* name, const char* description,
             Result<int> (*command)(const Options&))
      : sub(app.add_subcommand(name, description)), options(std::make_shared<Options>()) {
    sub->callback([options = options, command, &action, words = std::string(name)] {
      action = [options, command, words]() -> Result<int> {
        if constexpr (requires { options->folder; }) {
          bool writes = writers.find(" " + words + " ") != std::string_view::npos;
          if constexpr (requires { options->hand_in; }) writes = options->hand_in;
          if (writes) MIROCUP_TRY_VOID(expect_owner(options->folder));
        }
        return command(*options);
      };
    });
  }
  CLI::App* operator->() const { return sub; }

  CLI::App* sub;
  std::shared_ptr<Options> options;
};

// An empty name, as of a variable of the shell that is not set, would stand for the folder "/".
CLI::Validator a_folder() {
  return {
      [](const std::string& text) { return text.empty() ? "\"\" names no folder" : std::string(); },
      "DIR"};
}

// The first argument of all subcommands but compare, which needs no league.
template <class Options>
void add_folder(const Subcommand<Options>& command) {
  command->add_option("DIR", command.options->folder, "the league's folder")
      ->required()
      ->check(a_folder());
}

using LeagueSubcommand = Subcommand<LeagueOptions>;

void add_init(CLI::App& app, Action& action) {
  LeagueSubcommand command(app, action, "init", "Make a league", run_init);
  LeagueOptions& o = *command.options;
  add_folder(command);
  command->add_option("--config", o.config, "a league.json to start from");
  command
      ->add_option("--team", o.teams,
                   "NAME=house:TEAM, NAME=FILE.so, NAME=FILE.py, NAME=firasim:NAME (people start "
                   "it), or NAME=submitted: it hands in "
                   "later; once for each team")
      ->type_name("NAME=TEAM")
      ->excludes("--config");
  std::vector<std::string> formats;
  for (const auto name : enum_names<FormatKind>) formats.emplace_back(name);
  command
      ->add_option("--format", o.format, "the format of the schedule (default: double_round_robin)")
      ->check(CLI::IsMember(formats))
      ->excludes("--config");
  command->add_option("--half", o.half_s, "seconds of a half")
      ->check(CLI::Range(record::min_half_s, record::max_half_s))
      ->excludes("--config");
  command->add_option("--seed", o.seed, "seed of all random draws")
      ->check(CLI::Validator(system::problem_with_seed, "SEED"))
      ->excludes("--config");
}

void add_submit(CLI::App& app, Action& action) {
  Subcommand<SubmitOptions> command(
      app, action, "submit", "Hand in an entry: store it, check it, and play with it if it passes",
      run_submit);
  SubmitOptions& o = *command.options;
  add_folder(command);
  CLI::Option* team = command->add_option("TEAM", o.team, "its name");
  CLI::Option* file =
      command->add_option("FILE", o.file,
                          "its library (.so), its file of Python (.py), house:TEAM, or "
                          "firasim:NAME for a program that speaks FIRASim's protocol");
  CLI::Option* inbox =
      command
          ->add_option("--inbox", o.inbox,
                       "a folder: hand in each TEAM.so and TEAM.py in it that is new")
          ->excludes(team)
          ->excludes(file);
  CLI::Option* run =
      command
          ->add_option("--run", o.run,
                       "the command that starts a program for FIRASim in each leg; without it, "
                       "people start it")
          ->type_name("COMMAND")
          ->excludes(inbox);
  command->add_option("--folder", o.run_folder, "the folder in which it runs (default: this one)")
      ->type_name("DIR")
      ->needs(run);
  command
      ->add_flag("--lockstep", o.lockstep,
                 "the legs of that program wait for its answers, not for the clock")
      ->excludes(inbox);
  command->add_flag("--json", o.json, "one JSON object for each entry on standard output");
}

void add_owner(CLI::App& app, Action& action) {
  Subcommand<OwnerOptions> command(
      app, action, "owner", "Say which user hands in for a team by an inbox that users share",
      run_owner);
  OwnerOptions& o = *command.options;
  add_folder(command);
  command->add_option("TEAM", o.team, "its name")->required();
  CLI::Option* user = command->add_option("USER", o.user, "name or number (default: print it)");
  command->add_flag("--free", o.is_free, "the next user whose file is accepted")->excludes(user);
}

void add_other_program(const LeagueSubcommand& command) {
  command->add_flag("--other-program", command.options->accepts_other_program,
                    "go on with this program, although another one has played until now");
}

// Playing and showing a league.
void add_running(CLI::App& app, Action& action) {
  LeagueSubcommand nightly(app, action, "nightly",
                           "Let what is accepted play, publish, and tell each team what changed",
                           run_nightly);
  add_folder(nightly);
  nightly
      ->add_option("--jobs", nightly.options->jobs,
                   "number of legs at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
  nightly->add_flag("--another", nightly.options->another, "one more night on the same day");
  nightly
      ->add_option(
          "--on-night", nightly.options->on_night,
          "a program that is started after the night, once, with the folder of its digests "
          "as its argument")
      ->type_name("PROGRAM");
  nightly
      ->add_option("--address", nightly.options->address,
                   "what the links in the digests for mails begin with, as "
                   "https://league.example/")
      ->type_name("URL");
  add_other_program(nightly);

  LeagueSubcommand start(app, action, "start", "Play the league, or resume it", run_start);
  add_folder(start);
  add_other_program(start);
  start
      ->add_option("--engine", start.options->engine,
                   "where legs are played: on this host, or on the nodes of its Slurm cluster")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  start->add_flag("--watch", start.options->watched,
                  "let league serve show the legs of this host while they are played");
  start
      ->add_option("--jobs", start.options->jobs,
                   "number of legs, and then of pages, at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
  start
      ->add_option("--dds-domain", start.options->dds_domain,
                   "DDS domain of legs on this host in which a team plays over DDS")
      ->check(CLI::Range(0, 230))
      ->capture_default_str();

  LeagueSubcommand stop(app, action, "stop", "Stop a league that is being played", run_stop);
  add_folder(stop);
  stop->add_flag("--now", stop.options->now,
                 "stop the present legs, too, instead of playing them to their end");

  LeagueSubcommand status(
      app, action, "status",
      "Print the table and the state of the league (exit code 1: legs are left)", run_status);
  add_folder(status);
  status->add_flag("--entries", status.options->entries,
                   "what each team has handed in, and what became of it; the exit code stays: 0 if "
                   "every leg is decided, 1 if not");
  status->add_flag("--json", status.options->json, "one JSON object on standard output");

  Subcommand<StatsOptions> stats(app, action, "stats",
                                 "Print the football statistics of all legs that count", run_stats);
  add_folder(stats);
  stats->add_flag("--goals", stats.options->goals,
                  "how goals fell, where the ball was lost before, which laws were broken");
  stats->add_option("--team", stats.options->team, "only the legs of this team");
  CLI::Option* csv = stats->add_flag("--csv", stats.options->csv, "comma-separated values");
  stats->add_flag("--json", stats.options->json, "everything as one JSON object")->excludes(csv);

  LeagueSubcommand pages(app, action, "publish", "Make the pages", run_publish);
  add_folder(pages);
  CLI::Option* output = pages
                            ->add_option("-o,--output", pages.options->output,
                                         "the folder for the pages of --through")
                            ->check(a_folder());
  output->needs(pages
                    ->add_option("--through", pages.options->through,
                                 "leave out all rounds after this one: r3, or k1 of a knockout")
                    ->needs(output));

  Subcommand<ServeOptions> serve(app, action, "serve", "Show the league in browsers, as it is now",
                                 run_serve);
  add_folder(serve);
  ServeOptions& o = *serve.options;
  serve->add_option("--at", o.at, "where to listen (default: this host only, any free port)");
  CLI::Option* hand_in = serve->add_flag(
      "--hand-in", o.hand_in, "also take entries from teams that have a token (league token)");
  serve->add_option("--jobs", o.jobs, "number of checks at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024))
      ->needs(hand_in);
  serve->add_option("--tls", o.tls, "encrypt connections: files of the certificate and of its key")
      ->type_name("CERT KEY")
      ->expected(2);
  serve
      ->add_option("--trust-proxy", o.proxies,
                   "address of a proxy that is believed for whom it asks (X-Forwarded-For, "
                   "X-Forwarded-Proto); may be given several times")
      ->type_name("ADDR")
      ->expected(1)
      ->needs(hand_in);
  serve
      ->add_option("--team-header", o.team_header,
                   "header in which that proxy names the team of a person that it has signed on")
      ->type_name("NAME")
      ->needs(hand_in);

  Subcommand<ShowOptions> show(
      app, action, "show", "Play the recorded legs of a round on a projector, one after the other",
      run_show);
  add_folder(show);
  show->add_option("--round", show.options->round,
                   "r3, or k1 of a knockout (default: the last round that was played)");
  show->add_option("--at", show.options->at,
                   "where to listen (default: this host only, any free port)");
  show->add_option("--at-once", show.options->at_once, "number of legs side by side: 1, 2 or 4")
      ->check(CLI::IsMember({1, 2, 4}));

  LeagueSubcommand files(app, action, "export", "Write table, legs and bracket as files",
                         run_export);
  add_folder(files);
  files->add_option("-o,--output", files.options->output, "the folder for them")
      ->default_str("export")
      ->default_val("export")
      ->check(a_folder());
  files
      ->add_option("--drills", files.options->drills,
                   "marks of the teams, from mirocup drill --csv: adds grades.csv")
      ->type_name("FILE");
}

void add_hand_in(CLI::App& app, Action& action) {
  Subcommand<TokenOptions> token(
      app, action, "token", "Make a token by which a team hands in, and print it once", run_token);
  TokenOptions& o = *token.options;
  add_folder(token);
  token->add_option("TEAM", o.team, "its name; it may be new to the league");
  token->add_flag("--all", o.all, "a token for each team of the league that has none");
  token->add_flag("--staff", o.staff,
                  "a token that reads what all teams have handed in, and decides");
  token->add_flag("--tutor", o.tutor,
                  "a token that reads what the staff reads, and decides nothing");
  token->add_flag("--csv", o.csv, "lines of team, display name and token, for a mail merge");
  CLI::Option* expires =
      token->add_option("--expires", o.expires, "UTC: 2026-12-18T18:00:00Z, or the last day");
  token->add_flag("--revoke", o.revoke, "make no token; all tokens of the team become worthless")
      ->excludes(expires);

  Subcommand<CheckHandInOptions> check(app, action, "check-hand-in",
                                       "What serve --hand-in starts for each check",
                                       run_check_hand_in);
  check->group("");  // not in the help: not for people
  add_folder(check);
  check->add_option("TEAM", check.options->team)->required();
  check->add_option("ENTRY", check.options->entry)->required();
  check->add_option("--file", check.options->file)->required();
  check->add_option("--at", check.options->at)->required();
  check->add_option("--compile-seconds", check.options->compile_seconds)->required();

  Subcommand<PlayFriendlyOptions> friendly(app, action, "play-friendly",
                                           "What serve --hand-in starts for each friendly",
                                           run_play_friendly);
  friendly->group("");
  add_folder(friendly);
  friendly->add_option("TEAM", friendly.options->team)->required();
  friendly->add_option("NUMBER", friendly.options->number)->required();
  friendly->add_option("--entry", friendly.options->entry)->required();
  friendly->add_option("--opponent", friendly.options->opponent)->required();
  friendly->add_option("--opponent-entry", friendly.options->opponent_entry)->required();
}

// The subcommand of an act of the staff, with the argument DIR and a reason.
class ActSubcommand {
 public:
  ActSubcommand(CLI::App& app, Action& action, ActKind kind, const char* description)
      : command_(app, action, std::string(to_string(kind)).c_str(), description, run_act) {
    act().kind = kind;
    add_folder(command_);
  }

  void add_fixture() {
    command_->add_option("FIXTURE", act().fixture, "its id, as in r3-f1")->required();
    CLI::Option* leg = command_->add_option("--leg", act().leg, "1, 2 or 3");
    leg->check(CLI::Range(1, 3));
    command_->add_flag("--all-legs", act().has_all_legs, "all legs of the fixture")->excludes(leg);
  }

  void add_team() { command_->add_option("TEAM", act().team, "its name")->required(); }

  void add_reason() {
    command_->add_option("--reason", act().reason, "why; it is published")->required();
    command_->add_option("--by", act().by, "who decided; it is published");
    command_->add_flag("--dry-run", act().is_dry_run, "say what would change, and change nothing");
  }

  Act& act() const { return command_.options->act; }
  CLI::App* operator->() const { return command_.sub; }

 private:
  Subcommand<ActOptions> command_;
};

void add_rulings(CLI::App& app, Action& action) {
  ActSubcommand award(app, action, ActKind::award, "Give legs to a team, as by a forfeit");
  award.add_fixture();
  award.add_team();
  award.add_reason();

  ActSubcommand rule(app, action, ActKind::rule, "Decide the score of a leg, or of all legs");
  rule.add_fixture();
  rule->add_option("--score", rule.act().score, "goals of the home team and of the other")
      ->required();
  rule.add_reason();

  ActSubcommand annul(app, action, ActKind::void_,
                      "Declare legs void; they are played again with another seed");
  annul.add_fixture();
  annul->add_flag("--same-seed", annul.act().keeps_seed,
                  "with the seed that they had: the same libraries play the same leg again");
  annul.add_reason();

  ActSubcommand withdraw(app, action, ActKind::withdraw, "Take a team out of the league");
  withdraw.add_team();
  withdraw.act().results = "keep";
  withdraw->add_option("--results", withdraw.act().results, "keep its results, or annul them")
      ->check(CLI::IsMember({"keep", "annul"}))
      ->capture_default_str();
  withdraw.add_reason();

  ActSubcommand pause(app, action, ActKind::pause, "Start no legs of a team until it is resumed");
  pause.add_team();
  pause.add_reason();

  ActSubcommand resume(app, action, ActKind::resume, "Let a paused team play again");
  resume.add_team();
  resume.add_reason();

  ActSubcommand freeze(app, action, ActKind::freeze, "Take no entries from a time on");
  CLI::Option* at =
      freeze->add_option("--at", freeze.act().from,
                         "2026-11-30T18:00:00Z, …+01:00, or in the league's zone (default: now)");
  at->type_name("TIME");
  freeze->add_flag("--lift", freeze.act().is_lifted, "take entries again")->excludes(at);
  freeze.add_reason();

  ActSubcommand release(app, action, ActKind::release, "Say which rounds the pages show");
  release.act().level = "all";
  release
      ->add_option("--level", release.act().level,
                   "all: everybody; teams: each team reads its digest; hidden: neither")
      ->check(CLI::IsMember({"all", "teams", "hidden"}))
      ->capture_default_str();
  release->add_option("--through", release.act().through,
                      "the last round that the pages show, r3 or k1 (default: with all every "
                      "round, otherwise none)");
  release.add_reason();

  ActSubcommand close(app, action, ActKind::close, "End a league: no night follows, no entry");
  close.add_reason();

  ActSubcommand undo(app, action, ActKind::undo, "Take a decision back");
  undo->add_option("NUMBER", undo.act().decision, "its number in league decisions")->required();
  undo.add_reason();

  LeagueSubcommand decisions(app, action, "decisions",
                             "List what was decided: number, when, who, what, why", run_decisions);
  add_folder(decisions);
  decisions->add_flag("--json", decisions.options->json, "one JSON object on standard output");
}

void add_keeping(CLI::App& app, Action& action) {
  LeagueSubcommand verify(app, action, "verify",
                          "Simulate all records again, each with the program that played it",
                          run_verify_league);
  add_folder(verify);
  verify
      ->add_option("--jobs", verify.options->jobs,
                   "records at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
  verify->add_flag("--trust-programs", verify.options->trusts_programs,
                   "run the programs that the folder keeps, from now on: this host has not kept "
                   "them, but you know where they are from");
  verify->add_flag("--json", verify.options->json, "one JSON object on standard output");

  Subcommand<BackupOptions> backup(app, action, "backup",
                                   "Copy the league; it may be played meanwhile", run_backup);
  add_folder(backup);
  backup->add_option("TO", backup.options->to, "a new folder, or one with an earlier copy")
      ->required()
      ->check(a_folder());

  LeagueSubcommand grades(app, action, "grades", "Print what a lecturer grades by, as CSV",
                          run_grades);
  add_folder(grades);
  grades
      ->add_option("--drills", grades.options->drills,
                   "marks of the teams, from mirocup drill --csv")
      ->type_name("FILE");
  const auto add_layout = [&grades](const char* name, GradesLayout layout, const char* what) {
    GradesLayout& chosen = grades.options->layout;
    return grades->add_flag_callback(
        name, [&chosen, layout] { chosen = layout; }, what);
  };
  CLI::Option* per_member =
      add_layout("--per-member", GradesLayout::members, "a row for each member of a team");
  CLI::Option* moodle = add_layout("--moodle", GradesLayout::moodle,
                                   "a row for each student, as Moodle's grade import reads it; the "
                                   "class list needs a column mail or number");
  CLI::Option* gradescope =
      add_layout("--gradescope", GradesLayout::gradescope, "likewise, with Gradescope's columns");
  moodle->excludes(per_member)->excludes(gradescope);
  gradescope->excludes(per_member);
  grades->add_option("-o,--output", grades.options->output,
                     "a file, which only you can read (default: standard output)");

  Subcommand<TeamOptions> team(
      app, action, "team", "Make teams from a class list, and say by what names people know them",
      run_team);
  TeamOptions& o = *team.options;
  add_folder(team);
  team->add_option("TEAM", o.team, "its name in the league");
  team->add_option("--display", o.display, "any letters; \"\": its name in the league");
  team->add_option("--member", o.members, "once for each member; \"\": it has none");
  team->add_option("--colour", o.colour,
                   "of the mark beside its name on pages, as #c03a2b; \"\": none")
      ->type_name("COLOUR");
  team->add_option("--csv", o.csv,
                   "a class list: makes its teams; columns team, display, members (with ; between "
                   "them), colour, and further ones, which the grades have again")
      ->type_name("FILE");
  team->add_flag("--remove", o.is_removed, "take out a team that was a mistake");
}

void add_compare(CLI::App& app, Action& action) {
  Subcommand<CompareOptions> command(
      app, action, "compare",
      "Play teams against each other until it can be said which is better, or that they are equal",
      run_compare);
  CompareOptions& o = *command.options;
  ComparisonRun& r = o.run;
  command
      ->add_option(
          "TEAM", r.teams,
          "libraries, or names of house teams, each with :KEY=VALUE for its parameters; the "
          "first is compared with each other one")
      ->required()
      ->expected(2, 100);
  command
      ->add_option("--against", o.against,
                   "all: plays each against each, --most fixtures a pair, and prints a rated table")
      ->check(CLI::IsMember({"first", "all"}))
      ->capture_default_str();
  command->add_option("--league", o.league, "small (3 a side), middle (5), large (11)")
      ->check(CLI::IsMember({"small", "middle", "large"}))
      ->capture_default_str();
  command->add_option("--half", r.half_s, "seconds of a half")
      ->check(CLI::Range(record::min_half_s, record::max_half_s));
  command
      ->add_option("--conditions", r.conditions, "exact, hall or camera (default: as in a match)")
      ->check(CLI::IsMember({"exact", "hall", "camera"}));
  command->add_option("--seed", r.seed, "seed of the fixtures")
      ->check(CLI::Validator(system::problem_with_seed, "SEED"))
      ->capture_default_str();
  command->add_option("--jobs", r.jobs, "number of legs at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--most", o.most,
                   "fixtures of two legs after which a pair is given up (default: " +
                       std::to_string(r.max_fixtures) +
                       "; with --against all: " + std::to_string(fixtures_of_a_table) + ")")
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("--equal", r.test.equal_elo, "teams that are less Elo than this apart are equal")
      ->check(CLI::Range(1.0, 400.0))
      ->capture_default_str();
  command->add_option("--keep", o.keep,
                      "a folder for the records; the same command goes on with those in it");
  CLI::Option* json = command->add_flag("--json", o.json, "one JSON object on standard output");
  command->add_flag("--csv", o.csv, "comma-separated values: the pairs, or the rated table")
      ->excludes(json);
}

void add_tune(CLI::App& app, Action& action) {
  Subcommand<TuneOptions> command(app, action, "tune", "Find better numbers for a team", run_tune);
  TuneOptions& o = *command.options;
  TuningOptions& t = o.tuning;
  command->add_option("TEAM", o.team, "a library, or the name of a house team")->required();
  command->add_option("--param", o.parameters, "a parameter of the team, and where to look for it")
      ->required();
  command->add_option("--against", o.against, "the opponents, with commas between them")
      ->delimiter(',')
      ->required();
  command->add_option("--league", o.league, "small (3 a side), middle (5), large (11)")
      ->check(CLI::IsMember({"small", "middle", "large"}))
      ->capture_default_str();
  command->add_option("--half", o.run.half_s, "seconds of a half")
      ->check(CLI::Range(record::min_half_s, record::max_half_s));
  command
      ->add_option("--conditions", o.run.conditions,
                   "exact, hall or camera (default: as in a match)")
      ->check(CLI::IsMember({"exact", "hall", "camera"}));
  command->add_option("--seed", t.seed, "seed of the search and of its fixtures")
      ->check(CLI::Validator(system::problem_with_seed, "SEED"))
      ->capture_default_str();
  command
      ->add_option("--jobs", o.run.jobs, "number of legs at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
  command->add_option("--generations", t.generations, "generations of the search")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  command
      ->add_option("--fixtures", t.fixtures,
                   "fixtures of two legs of a candidate against each opponent; more if there is "
                   "much noise")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command
      ->add_option("--test", t.test_fixtures,
                   "fixtures of the test at the end, against each opponent")
      ->check(CLI::Range(10, 100'000))
      ->capture_default_str();
  command
      ->add_option("-o,--output", o.folder,
                   "a folder for what has been played and the picture; the same command goes on")
      ->capture_default_str();
  command->add_flag("--json", o.json, "one JSON object on standard output");
}

void add_shards(CLI::App& app, Action& action) {
  Subcommand<ShardOptions> plan(
      app, action, "plan",
      "Start the league, book the records of shards, and list the fixtures to play", run_plan);
  add_folder(plan);

  Subcommand<ShardOptions> shard(
      app, action, "run-shard",
      "Play fixtures on any machine and only write records; league start books them", run_shards);
  add_folder(shard);
  shard
      ->add_option("FIXTURE", shard.options->fixtures, "ids of fixtures, as league plan lists them")
      ->required();
}

void add_credentials(CLI::App& app, Action& action) {
  Subcommand<CredentialsOptions> command(
      app, action, "credentials",
      "Make the certificates of teams, match server and spectators for DDS Security",
      run_credentials);
  CredentialsOptions& o = *command.options;
  add_folder(command);
  command->add_option("--team", o.teams, "a team that is not in the league's file");
  command->add_option("--revoke", o.revoked, "a team whose credentials become invalid");
  command->add_option("--days", o.days, "number of days for which new credentials are valid")
      ->check(CLI::Range(1, 3650))
      ->capture_default_str();
}

constexpr const char* to_make = "Make";
constexpr const char* to_take = "Entries";
constexpr const char* to_play = "Play";
constexpr const char* to_show = "Show";
constexpr const char* to_rule = "Decide";
constexpr const char* on_clusters = "Many computers";

const system::CommandHelp help_of_commands[] = {
    {"init",
     to_make,
     {"mirocup league init spring --team alpha=alpha.so --team house=house:striker --half 120",
      "mirocup league init spring --config league.json"}},
    {"credentials", to_make, {"mirocup league credentials spring"}},
    {"compare",
     to_make,
     {"mirocup league compare new.so old.so",
      "mirocup league compare a.so b.so c.so --against all"}},
    {"tune", to_make, {"mirocup tune mine.so --param wait=0.3:0.6 --against chaser,striker"}},
    {"submit",
     to_take,
     {"mirocup league submit spring alpha alpha.so", "mirocup league submit spring --inbox inbox"}},
    {"team",
     to_take,
     {"mirocup league team spring --csv class.csv",
      "mirocup league team spring alpha --display \"Zoë & Co\" --member Zoë"}},
    {"owner", to_take, {"mirocup league owner spring alpha student7"}},
    {"token",
     to_take,
     {"mirocup league token spring alpha", "mirocup league token spring --all --csv >tokens.csv"}},
    {"start", to_play, {"mirocup league start spring --jobs 4"}},
    {"stop", to_play, {"mirocup league stop spring"}},
    {"nightly",
     to_play,
     {"mirocup league nightly spring",
      "mirocup league nightly spring --on-night ./mail --address https://league.example/"}},
    {"status", to_play, {"mirocup league status spring", "mirocup league status spring --entries"}},
    {"verify",
     to_play,
     {"mirocup league verify spring", "mirocup league verify copied --trust-programs"}},
    {"backup", to_play, {"mirocup league backup spring /backup/spring"}},
    {"serve",
     to_show,
     {"mirocup league serve spring --at 8080",
      "mirocup league serve spring --hand-in --at 0.0.0.0:8443 --tls cert.pem key.pem"}},
    {"show", to_show, {"mirocup league show spring --round r3 --at-once 2"}},
    {"publish", to_show, {"mirocup league publish spring"}},
    {"stats", to_show, {"mirocup league stats spring --csv"}},
    {"export", to_show, {"mirocup league export spring -o tables"}},
    {"grades",
     to_show,
     {"mirocup league grades spring --drills drills.csv -o grades.csv",
      "mirocup league grades spring --moodle -o moodle.csv"}},
    {"release", to_show, {"mirocup league release spring --through r3 --reason \"it is Friday\""}},
    {"award",
     to_rule,
     {"mirocup league award spring r3-f1 alpha --all-legs --reason \"beta left\""}},
    {"rule",
     to_rule,
     {"mirocup league rule spring r3-f1 --leg 1 --score 2:1 --reason \"appeal 4\""}},
    {"void", to_rule, {"mirocup league void spring r3-f1 --leg 2 --reason \"power cut\""}},
    {"freeze", to_rule, {"mirocup league freeze spring --reason \"last day\""}},
    {"close", to_rule, {"mirocup league close spring --reason \"the term is over\""}},
    {"decisions", to_rule, {"mirocup league decisions spring"}},
    {"undo", to_rule, {"mirocup league undo spring 3 --reason \"the wrong leg\""}},
    {"withdraw", to_rule, {"mirocup league withdraw spring beta --reason \"left the course\""}},
    {"pause", to_rule, {"mirocup league pause spring beta --reason \"is looked at\""}},
    {"resume", to_rule, {"mirocup league resume spring beta --reason \"repaired\""}},
    {"plan", on_clusters, {"mirocup league plan spring"}},
    {"run-shard", on_clusters, {"mirocup league run-shard spring r1-f1 r1-f2"}},
};

const system::ValueNames value_names{
    {"--config", "FILE"},       {"--team", "NAME"},
    {"--half", "SECONDS"},      {"--seed", "SEED"},
    {"--inbox", "DIR"},         {"--jobs", "NUMBER"},
    {"--dds-domain", "NUMBER"}, {"--output", "DIR"},
    {"--through", "ROUND"},     {"--round", "ROUND"},
    {"--at", "[HOST:]PORT"},    {"--leg", "NUMBER"},
    {"--reason", "TEXT"},       {"--by", "NAME"},
    {"--score", "HOME:AWAY"},   {"--expires", "TIME"},
    {"--most", "NUMBER"},       {"--equal", "ELO"},
    {"--keep", "DIR"},          {"--revoke", "TEAM"},
    {"--days", "DAYS"},         {"--display", "NAME"},
    {"--member", "NAME"},       {"--param", "KEY=LOW:HIGH"},
    {"--against", "TEAM,TEAM"}, {"--generations", "NUMBER"},
    {"--fixtures", "NUMBER"},   {"--test", "NUMBER"},
};

}  // namespace

std::optional<int> read_command_line(int argc, char** argv, Action& action) {
  CLI::App cli("Leagues of MiroSot robot soccer: a league is a folder.", "mirocup league");
  cli.require_subcommand(1);
  cli.set_version_flag("-v,--version", record::software_version());
  add_init(cli, action);
  add_submit(cli, action);
  add_owner(cli, action);
  add_running(cli, action);
  add_hand_in(cli, action);
  add_rulings(cli, action);
  add_keeping(cli, action);
  add_compare(cli, action);
  add_tune(cli, action);
  add_shards(cli, action);
  add_credentials(cli, action);
  cli.footer("mirocup league help COMMAND explains a command, with examples.");
  system::finish_help(cli, help_of_commands, value_names);
  if (const auto told =
          system::tell_about(cli, argc, argv, record::software_version(), system::house_teams()))
    return told;
  return system::parse_command_line(cli, argc, argv);
}

}  // namespace mirocup::league
