// SPDX-License-Identifier: MIT
//
// CLI11 is included in this source alone, because it takes long to compile.
#include "tournaments/app/command_line.hpp"

#include "server/record/match_record.hpp"
#include "tournaments/app/commands.hpp"
#include "tournaments/format/format.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace mirocup::league {

namespace {

// A subcommand, the object that receives its options, and the function that runs with them.
template <class Options>
struct Subcommand {
  Subcommand(CLI::App& app, Action& action, const char* name, const char* description,
             Result<int> (*command)(const Options&))
      : sub(app.add_subcommand(name, description)), options(std::make_shared<Options>()) {
    sub->callback([options = options, command, &action] {
      action = [options, command] { return command(*options); };
    });
  }
  CLI::App* operator->() const { return sub; }

  CLI::App* sub;
  std::shared_ptr<Options> options;
};

// The first argument of all but compare.
template <class Options>
void add_folder(const Subcommand<Options>& command) {
  command->add_option("DIR", command.options->folder, "the league's folder")->required();
}

using LeagueSubcommand = Subcommand<LeagueOptions>;

void add_init(CLI::App& app, Action& action) {
  LeagueSubcommand command(app, action, "init", "Make a league", run_init);
  LeagueOptions& o = *command.options;
  add_folder(command);
  command->add_option("--config", o.config, "a league.json to start from");
  command->add_option("--team", o.teams, "NAME=house:TEAM or NAME=FILE.so, once for each team")
      ->excludes("--config");
  std::vector<std::string> formats;
  for (const auto name : enum_names<FormatKind>) formats.emplace_back(name);
  command->add_option("--format", o.format, "who meets whom (default: double_round_robin)")
      ->check(CLI::IsMember(formats))
      ->excludes("--config");
  command->add_option("--half", o.half_s, "seconds of a half")->excludes("--config");
  command->add_option("--seed", o.seed, "of everything that is drawn")->excludes("--config");
}

void add_submit(CLI::App& app, Action& action) {
  Subcommand<SubmitOptions> command(app, action, "submit",
                                    "Hand in an entry: check it, keep it, let it play", run_submit);
  SubmitOptions& o = *command.options;
  add_folder(command);
  CLI::Option* team = command->add_option("TEAM", o.team, "its name");
  CLI::Option* file = command->add_option("FILE.so", o.file, "its library");
  command->add_option("--inbox", o.inbox, "take TEAM.so of this folder, each that is new")
      ->excludes(team)
      ->excludes(file);
  command->add_flag("--json", o.json, "one JSON object for each entry on standard output");
}

// Playing and showing a league.
void add_running(CLI::App& app, Action& action) {
  LeagueSubcommand start(app, action, "start", "Play the league, or go on with it", run_start);
  add_folder(start);
  start
      ->add_option("--engine", start.options->engine,
                   "who plays: this host, or the nodes of the Slurm cluster that it belongs to")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  start->add_flag("--watch", start.options->watched,
                  "legs of this host can be watched through league serve while they are played");
  start
      ->add_option("--jobs", start.options->jobs,
                   "legs, and then pages, at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));

  LeagueSubcommand stop(app, action, "stop", "Let a league that is being played stop", run_stop);
  add_folder(stop);
  stop->add_flag("--now", stop.options->now, "do not play the present legs to their end");

  LeagueSubcommand status(app, action, "status", "Say how the league stands", run_status);
  add_folder(status);
  status->add_flag("--json", status.options->json, "one JSON object on standard output");

  LeagueSubcommand pages(app, action, "publish", "Make the pages", run_publish);
  add_folder(pages);
  CLI::Option* output =
      pages->add_option("-o,--output", pages.options->output, "a folder for these rounds alone");
  output->needs(pages
                    ->add_option("--through", pages.options->through,
                                 "show nothing after this round: r3, or k1 of a knockout")
                    ->needs(output));

  Subcommand<ServeOptions> serve(app, action, "serve", "Show the league in browsers, as it is now",
                                 run_serve);
  add_folder(serve);
  serve->add_option("--at", serve.options->at,
                    "[HOST:]PORT (default: this host only, any port that is free)");

  LeagueSubcommand files(app, action, "export", "Write table, legs and bracket as files",
                         run_export);
  add_folder(files);
  files->add_option("-o,--output", files.options->output, "the folder for them")
      ->default_str("export")
      ->default_val("export");
}

// The subcommand of a decision by a person; its arguments are DIR first and the reason last.
class RulingSubcommand {
 public:
  RulingSubcommand(CLI::App& app, Action& action, const char* name, const char* description,
                   Result<int> (*command)(const RulingOptions&))
      : command_(app, action, name, description, command) {
    add_folder(command_);
  }

  void add_fixture() {
    command_->add_option("FIXTURE", options().fixture, "its id, as in r3-f1")->required();
    command_->add_option("--leg", options().leg, "1, 2 or 3 (default: all)")
        ->check(CLI::Range(1, 3));
  }

  void add_team() { command_->add_option("TEAM", options().team, "its name")->required(); }

  void add_reason(bool is_needed) {
    CLI::Option* reason =
        command_->add_option("--reason", options().reason, "why; it is published");
    if (is_needed) reason->required();
    command_->add_option("--by", options().by, "who decided; it is published");
  }

  RulingOptions& options() const { return *command_.options; }
  CLI::App* operator->() const { return command_.sub; }

 private:
  Subcommand<RulingOptions> command_;
};

void add_rulings(CLI::App& app, Action& action) {
  RulingSubcommand award(app, action, "award", "Give a fixture or a leg to a team, as by a forfeit",
                         run_award);
  award.add_fixture();
  award.add_team();
  award.add_reason(true);

  RulingSubcommand rule(app, action, "rule", "Decide the score of a fixture's legs or of one",
                        run_rule);
  rule.add_fixture();
  rule->add_option("--score", rule.options().score, "HOME:AWAY")->required();
  rule.add_reason(true);

  RulingSubcommand annul(app, action, "void",
                         "Let legs count for nothing and be played again with the same seed",
                         run_void);
  annul.add_fixture();
  annul.add_reason(true);

  RulingSubcommand withdraw(app, action, "withdraw", "Take a team out of the league", run_withdraw);
  withdraw.add_team();
  withdraw->add_option("--results", withdraw.options().results, "keep what it played, or annul it")
      ->check(CLI::IsMember({"keep", "annul"}))
      ->capture_default_str();
  withdraw.add_reason(true);

  RulingSubcommand pause(app, action, "pause", "Play no legs of a team for now", run_pause);
  pause.add_team();
  pause.add_reason(true);

  RulingSubcommand resume(app, action, "resume", "Let a paused team play again", run_resume);
  resume.add_team();
  resume.add_reason(false);
}

void add_compare(CLI::App& app, Action& action) {
  Subcommand<CompareOptions> command(
      app, action, "compare", "Play two entries until it can be said which is better", run_compare);
  CompareOptions& o = *command.options;
  ComparisonRun& r = o.run;
  command->add_option("A", r.teams[0], "a library, or the name of a house team")->required();
  command->add_option("B", r.teams[1], "the other")->required();
  command->add_option("--league", o.league, "small (3 a side), middle (5), large (11)")
      ->check(CLI::IsMember({"small", "middle", "large"}))
      ->capture_default_str();
  command->add_option("--half", r.half_s, "seconds of a half")->check(CLI::Range(0.1, 36000.0));
  command->add_option("--seed", r.seed, "of the fixtures")->capture_default_str();
  command->add_option("--jobs", r.jobs, "legs at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
  command->add_option("--most", r.max_fixtures, "fixtures of two legs, before it gives up")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command
      ->add_option("--share", r.test.share,
                   "of the fixtures that are not level, that the better one wins at least")
      ->check(CLI::Range(0.51, 0.99))
      ->capture_default_str();
  command->add_flag("--json", o.json, "one JSON object on standard output");
}

void add_shards(CLI::App& app, Action& action) {
  Subcommand<ShardOptions> plan(
      app, action, "plan",
      "Start the league, book what shards have played, and list what can be played now", run_plan);
  add_folder(plan);

  Subcommand<ShardOptions> shard(
      app, action, "run-shard",
      "Play fixtures into records only, on any machine; league start books them", run_shards);
  add_folder(shard);
  shard->add_option("FIXTURE", shard.options->fixtures, "ids, as league plan lists them")
      ->required();
}

void add_credentials(CLI::App& app, Action& action) {
  Subcommand<CredentialsOptions> command(
      app, action, "credentials",
      "Make what teams, match server and spectators are known by on the network", run_credentials);
  CredentialsOptions& o = *command.options;
  add_folder(command);
  command->add_option("--team", o.teams, "a team that is not in the league's file");
  command->add_option("--revoke", o.revoked, "a team whose credentials shall not count any more");
  command->add_option("--days", o.days, "that new credentials are valid")
      ->check(CLI::Range(1, 3650))
      ->capture_default_str();
}

}  // namespace

std::optional<int> read_command_line(int argc, char** argv, Action& action) {
  CLI::App cli("Leagues of MiroSot robot soccer: a league is a folder.", "mirocup league");
  cli.require_subcommand(1);
  cli.set_version_flag("--version", record::software_version());
  add_init(cli, action);
  add_submit(cli, action);
  add_running(cli, action);
  add_rulings(cli, action);
  add_compare(cli, action);
  add_shards(cli, action);
  add_credentials(cli, action);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const bool asked_for_help = e.get_exit_code() == 0;
    cli.exit(e);
    return asked_for_help ? exit_yes : exit_code(Errc::input);
  }
  return {};
}

}  // namespace mirocup::league
