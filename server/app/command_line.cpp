// SPDX-License-Identifier: MIT
//
// In one source, for CLI11 takes long to compile wherever it is included.
#include "server/app/command_line.hpp"

#include "server/app/commands.hpp"
#include "server/record/match_record.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace mirocup::app {

namespace {

// A subcommand, the object that its options are written to, and what runs with it.
template <class Options>
struct Subcommand {
  Subcommand(CLI::App& app, Run& run, const char* name, const char* description,
             Result<int> (*command)(const Options&))
      : sub(app.add_subcommand(name, description)), options(std::make_shared<Options>()) {
    sub->callback([options = options, command, &run] {
      run = [options, command] { return command(*options); };
    });
  }
  CLI::App* operator->() const { return sub; }

  CLI::App* sub;
  std::shared_ptr<Options> options;
};

template <class E>
CLI::Validator one_of() {
  std::vector<std::string> names;
  for (const auto name : enum_names<E>) names.emplace_back(name);
  return CLI::IsMember(names);
}

void add_match(CLI::App& app, Run& run) {
  Subcommand<MatchOptions> command(app, run, "match", "Play one leg", run_match);
  MatchOptions& o = *command.options;
  command->add_option("--blue", o.teams[0], "a library, a house team's name, or dds:NAME")
      ->required();
  command->add_option("--yellow", o.teams[1], "the same for the other team")->required();
  command->add_option("--blue-name", o.names[0], "what the record calls the blue team");
  command->add_option("--yellow-name", o.names[1], "what the record calls the yellow team");
  command->add_option("--league", o.league, "small (3 a side), middle (5), large (11)")
      ->check(one_of<League>())
      ->capture_default_str();
  command->add_option("--rules", o.rules, "rules preset")
      ->check(one_of<referee::Preset>())
      ->capture_default_str();
  command->add_option("--stage", o.stage, "may a draw stand?")
      ->check(one_of<referee::Stage>())
      ->capture_default_str();
  command->add_option("--seed", o.seed, "of the toss and of the teams' random numbers")
      ->capture_default_str();
  command->add_option("--speed", o.speed,
                      "max, or a factor: 1 is real time (default: 1 with --watch, else max)");
  command
      ->add_option_function<std::string>(
          "--watch", [&o](const std::string& where) { o.watch = where; },
          "show the match in browsers; [HOST:]PORT, without it any port of this host only")
      ->expected(0, 1)
      ->type_name("[PORT]");
  command->add_option("--half", o.half_s, "seconds of a half")->check(CLI::Range(0.1, 36000.0));
  command->add_option("--rule", o.rule_changes,
                      "KEY=VALUE: another value for a parameter of the rules");
  command->add_option("--record", o.record_path, "where to write the match record");
  command->add_flag("--trusted", o.trusted, "run the teams in this process, without protection");
  command
      ->add_option("--isolation", o.isolation,
                   "T2 or T1: play in exactly this tier of the sandbox, or not at all")
      ->check(CLI::IsMember({"T1", "T2"}))
      ->excludes("--trusted");
  command->add_option("--match", o.match_id, "ID that DDS teams join")->capture_default_str();
  command
      ->add_option("--interface", o.interface,
                   "network interface for DDS teams; lo: this host only")
      ->capture_default_str();
  command->add_option("--join-within", o.join_within, "seconds that a DDS team has to join")
      ->capture_default_str();
  command
      ->add_option("--away-limit", o.away_limit,
                   "seconds that a DDS team may be away from the match in all")
      ->capture_default_str();
  command->add_option("--credentials", o.credentials,
                      "folder with the server's credentials: only teams of the league can join");
  command->add_flag("--json", o.json, "the record on standard output");
}

void add_check(CLI::App& app, Run& run) {
  Subcommand<CheckOptions> command(app, run, "check", "Would this library be accepted as an entry?",
                                   run_check);
  CheckOptions& o = *command.options;
  command->add_option("FILE.so", o.path, "the team's library")->required();
  command->add_option("--league", o.league, "small (3 a side), middle (5), large (11)")
      ->check(CLI::IsMember({"small", "middle", "large"}))
      ->capture_default_str();
  command->add_flag("--json", o.json, "the report as one object on standard output");
}

void add_join(CLI::App& app, Run& run) {
  Subcommand<JoinOptions> command(app, run, "join", "Play a library in a match on the network",
                                  run_join);
  JoinOptions& o = *command.options;
  command->add_option("--match", o.match_id, "ID of the match")->required();
  command->add_option("--team", o.team, "the colour to play")
      ->required()
      ->check(CLI::IsMember({"blue", "yellow"}));
  command->add_option("--name", o.name, "the name that the match knows the team by")->required();
  command->add_option("--server", o.server, "host that the match runs on")->capture_default_str();
  command->add_option("--patience", o.join_within, "seconds to wait for the match")
      ->capture_default_str();
  command->add_option("--credentials", o.credentials,
                      "folder with the team's credentials, for a match that asks for them");
  command->add_option("FILE.so", o.library, "the team's library")->required();
}

void add_new(CLI::App& app, Run& run) {
  Subcommand<NewOptions> command(app, run, "new", "Start a team of your own", run_new);
  command->add_option("DIR", command.options->folder, "the folder to make")->required();
}

void add_verify(CLI::App& app, Run& run) {
  Subcommand<VerifyOptions> command(app, run, "verify",
                                    "Play a record again from its commands and compare everything",
                                    run_verify);
  VerifyOptions& o = *command.options;
  command->add_option("RECORD", o.path, "a match record")->required();
  command->add_flag("--json", o.json, "one JSON object on standard output");
}

void add_rerun(CLI::App& app, Run& run) {
  Subcommand<RerunOptions> command(
      app, run, "rerun", "Play a record's teams again and compare their commands", run_rerun);
  RerunOptions& o = *command.options;
  command->add_option("RECORD", o.record, "a match record")->required();
  command->add_option("--entries", o.entries,
                      "folder with the teams' libraries, found by their sha256 (default: the "
                      "entries of the league that the record lies in)");
  command->add_flag("--json", o.json, "one JSON object on standard output");
}

void add_replay(CLI::App& app, Run& run) {
  Subcommand<ReplayOptions> command(app, run, "replay",
                                    "Make a page that shows a record in a browser", run_replay);
  ReplayOptions& o = *command.options;
  command->add_option("RECORD", o.record, "a match record")->required();
  command->add_option("-o,--output", o.output, "the page, or the picture")->required();
  command->add_option("--at", o.at, "a moment, in seconds since the match began")
      ->check(CLI::Range(0.0, 1e6));
  command->add_flag("--svg", o.svg, "a still picture of that moment");
  command->add_flag("--no-times", o.no_times,
                    "leave out what a clock measured: the page is the same whoever played the leg");
}

void add_scene(CLI::App& app, Run& run) {
  Subcommand<SceneOptions> command(app, run, "scene", "Run a scene of the physics alone",
                                   run_scene);
  SceneOptions& o = *command.options;
  command->add_option("FILE", o.path, "a scene, mirocup/scene/1")->required();
  command->add_option("--accuracy", o.accuracy, "of lasting contacts")
      ->check(CLI::IsMember({"coarse", "standard", "reference"}));
  command->add_option("-o", o.out, "where the result goes (default: standard output)");
  command->add_flag("--json", o.json, "the result is JSON with and without it");
}

void add_referee(CLI::App& app, Run& run) {
  Subcommand<RefereeOptions> command(
      app, run, "referee", "Judge recorded situations, or a played match with other parameters",
      run_referee);
  RefereeOptions& o = *command.options;
  CLI::Option* trace =
      command->add_option("TRACE", o.trace_path, "situations, one line of JSON each");
  CLI::Option* record =
      command->add_option("--record", o.record_path, "a match record to judge again")
          ->excludes(trace);
  command
      ->add_option("--rule", o.rule_changes,
                   "KEY=VALUE: another value for a parameter of the record's rules")
      ->needs(record);
  command->add_flag("--json", o.json, "one JSON object on standard output");
}

}  // namespace

std::optional<int> read_command_line(int argc, char** argv, Run& run) {
  CLI::App cli("A tournament platform for MiroSot robot soccer.", "mirocup");
  cli.require_subcommand(1);
  cli.set_version_flag("--version", record::software_version());
  cli.footer(
      "mirocup league ... runs tournaments: see mirocup league --help.\n"
      "mirocup bench ... compares speed and error with other engines: see mirocup bench --help.");
  add_match(cli, run);
  add_check(cli, run);
  add_join(cli, run);
  add_new(cli, run);
  add_verify(cli, run);
  add_rerun(cli, run);
  add_replay(cli, run);
  add_scene(cli, run);
  add_referee(cli, run);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const bool asked_for_help = e.get_exit_code() == 0;
    cli.exit(e);
    return asked_for_help ? exit_yes : exit_code(Errc::input);
  }
  return {};
}

}  // namespace mirocup::app
