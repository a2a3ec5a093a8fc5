// SPDX-License-Identifier: MIT
//
// One source for all subcommands, because CLI11 takes long to compile wherever it is included.
#include "programs/mirocup/command_line.hpp"

#include "programs/mirocup/commands.hpp"
#include "record/match_record.hpp"
#include "record/rules_json.hpp"
#include "server/dds/domain.hpp"
#include "system/command_help.hpp"
#include "system/command_line.hpp"
#include "system/locations.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace mirocup::app {

namespace {

// A subcommand of the command line. Parsing it fills `options` and sets `run`.
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

void add_dds_domain(CLI::App& command, int& domain) {
  command.add_option("--dds-domain", domain, "DDS domain of the match; each has ports of its own")
      ->check(CLI::Range(dds::default_domain, dds::last_domain))
      ->capture_default_str();
}

void add_parameters(CLI::App& command, const char* option, std::vector<std::string>& changes,
                    const char* whose) {
  command
      .add_option(option, changes,
                  "Set a parameter of " + std::string(whose) +
                      ", a number that the strategy asks for by name; may be given several times")
      ->type_name("KEY=VALUE");
}

void add_firasim(CLI::App& command, MatchOptions& o) {
  const char* group = "Teams that speak the protocol of FIRASim and VSSReferee";
  const auto add = [&](const char* option, std::string& value, const char* type,
                       const char* description) {
    command.add_option(option, value, description)->type_name(type)->group(group);
  };
  add("--firasim-vision", o.firasim_vision, "ADDR:PORT[,...]",
      "Where vision is sent to: groups or single addresses (default: 224.0.0.1:10002)");
  add("--firasim-command", o.firasim_command, "[ADDR:]PORT",
      "Where commands are received (default: 20011)");
  add("--firasim-referee", o.firasim_referee, "ADDR:PORT[,...]",
      "Where the referee's calls are sent to (default: 224.5.23.2:10003)");
  add("--firasim-placement", o.firasim_placement, "ADDR:PORT",
      "Where placements are received (default: 224.5.23.2:10004)");
  command
      .add_option("--firasim-instance", o.firasim_instance,
                  "Number of this match on this host; above 0 each has ports of its own: 10002+K, "
                  "20011+K, 40000+K, 50000+K; auto: the first from 1000 on that is free")
      ->check(CLI::Range(0, 9999) | CLI::IsMember({"auto"}))
      ->type_name("K|auto")
      ->group(group);
  add("--blue-program", o.programs[0], "COMMAND",
      "Start the blue team by this command of the shell, which finds its colour and addresses in "
      "MIROCUP_COLOUR, MIROCUP_INSTANCE and others (docs/firasim.md)");
  add("--yellow-program", o.programs[1], "COMMAND", "Start the yellow team in the same way");
  command
      .add_flag("--lockstep", o.lockstep,
                "Wait in each tick until these teams have commanded all their robots (--speed max "
                "does, too)")
      ->group(group);
}

void add_match(CLI::App& app, Run& run) {
  Subcommand<MatchOptions> command(app, run, "match", "Play one leg", run_match);
  MatchOptions& o = *command.options;
  command
      ->add_option("--blue", o.teams[0],
                   "Blue team: a library (.so), a file of Python (.py), the name of a house team, "
                   "dds:NAME, or firasim:NAME for a program that speaks FIRASim's protocol")
      ->type_name("TEAM")
      ->required();
  command->add_option("--yellow", o.teams[1], "Yellow team, named in the same way")
      ->type_name("TEAM")
      ->required();
  command->add_option("--blue-name", o.names[0], "Name of the blue team in the record")
      ->type_name("NAME");
  command->add_option("--yellow-name", o.names[1], "Name of the yellow team in the record")
      ->type_name("NAME");
  CLI::Option* start =
      command
          ->add_option("--start", o.start_path,
                       "Start in this situation, a file of schema mirocup/situation/1")
          ->type_name("SITUATION.json");
  CLI::Option* from =
      command
          ->add_option("--from", o.from_path,
                       "Play on from a tick of this record, with its league, rules, stage, seed "
                       "and conditions")
          ->type_name("RECORD")
          ->excludes(start);
  CLI::Option* tick =
      command->add_option("--tick", o.tick, "Tick of the record from which to play on")
          ->check(CLI::NonNegativeNumber)
          ->needs(from);
  from->needs(tick);
  command
      ->add_option("--league", o.league,
                   "Field and number of robots: small (3 a side), middle (5), large (11); default: "
                   "small, or that of the situation")
      ->check(one_of<League>())
      ->excludes(from);
  command->add_option("--rules", o.rules, "Preset of the rules")
      ->check(one_of<referee::Preset>())
      ->capture_default_str()
      ->excludes(from);
  command->add_option("--stage", o.stage, "group: a draw stands; knockout: a winner is found")
      ->check(one_of<referee::Stage>())
      ->capture_default_str()
      ->excludes(from);
  command->add_option("--seed", o.seed, "Seed of the toss and of the teams' random numbers")
      ->check(CLI::Validator(system::problem_with_seed, "SEED"))
      ->capture_default_str()
      ->excludes(from);
  command
      ->add_option("--speed", o.speed,
                   "max, or a factor of real time (default: 1 with --watch, otherwise max)")
      ->type_name("FACTOR");
  command
      ->add_option_function<std::string>(
          "--watch", [&o](const std::string& where) { o.watch = where; },
          "Show the match in browsers at [HOST:]PORT; without a host at this host only, without a "
          "port "
          "at any free one")
      ->expected(0, 1)
      ->type_name("[PORT]");
  command->add_flag("--calls", o.calls, "Print each goal and call of the referee, too");
  command->add_option("--half", o.half_s, "Length of a half in seconds")
      ->check(CLI::Range(record::min_half_s, record::max_half_s))
      ->excludes(from);
  command
      ->add_option("--rule", o.rule_changes,
                   "Change a parameter of the rules; may be given several times")
      ->type_name("KEY=VALUE")
      ->excludes(from);
  command
      ->add_option("--conditions", o.conditions,
                   "What disturbs the leg: nothing (exact), placing by hand, wheels and floor "
                   "(hall), also a camera and a radio (camera); default: those of the pitch, if it "
                   "has any, or " +
                       std::string(to_string(match::default_preset)))
      ->check(one_of<match::ConditionsPreset>())
      ->excludes(from);
  command
      ->add_option("--pitch", o.pitch,
                   "Robots, ball and floor: mirosot (default), vsss, simurosot, or a file "
                   "(mirocup/pitch/1), for example of mirocup identify")
      ->type_name("NAME|FILE")
      ->excludes(from);
  command
      ->add_option("--condition", o.condition_changes,
                   "Change a value of the conditions; may be given several times")
      ->type_name("KEY=VALUE")
      ->excludes(from);
  add_parameters(*command.sub, "--param", o.parameters, "both teams");
  add_parameters(*command.sub, "--blue-param", o.own_parameters[0], "the blue team");
  add_parameters(*command.sub, "--yellow-param", o.own_parameters[1], "the yellow team");
  CLI::Option* record =
      command->add_option("--record", o.record_path, "File to write the match record to")
          ->type_name("FILE");
  command
      ->add_flag("--thoughts", o.thoughts,
                 "Keep what the teams draw, beside the record, for mirocup replay")
      ->needs(record);
  command->add_flag("--trusted", o.trusted,
                    "Run the teams in this process, without protection from them");
  command
      ->add_option("--isolation", o.isolation,
                   "Tier of the sandbox: T2 (namespaces) or T1 (filtered system calls); the match "
                   "is not played "
                   "if this system does not allow it (default: the strongest that it allows)")
      ->check(CLI::IsMember({"T1", "T2"}))
      ->excludes("--trusted");
  command->add_option("--match", o.match_id, "ID of the match, by which DDS teams join it")
      ->capture_default_str();
  command
      ->add_option("--interface", o.interface,
                   "Network interface for teams on the network; lo: this host only")
      ->capture_default_str();
  add_dds_domain(*command.sub, o.dds_domain);
  command
      ->add_option("--join-within", o.join_within, "Seconds that a DDS team has to join the match")
      ->capture_default_str();
  command->add_option(
      "--away-limit", o.away_limit,
      "Seconds that a DDS team may be absent from the match in total, and that a firasim "
      "team may say nothing; 10 without it, and 30 with --lockstep");
  command
      ->add_option("--credentials", o.credentials,
                   "Folder with the server's credentials; then only teams of the league can join")
      ->type_name("DIR");
  command->add_flag("--hash", o.hash, "Print the state hash of the leg, too");
  add_firasim(*command.sub, o);
  command->add_flag("--json", o.json, "Print the record as one JSON object");
}

void add_drill(CLI::App& app, Run& run) {
  Subcommand<DrillOptions> command(
      app, run, "drill", "Try situations many times and give marks, or list them", run_drill);
  DrillOptions& o = *command.options;
  command
      ->add_option("DRILL", o.drill,
                   "list, all, the name of a drill, or the path of an own one or of a folder")
      ->required();
  command
      ->add_option("TEAM", o.teams,
                   "Teams to be tested: paths of libraries or names of house teams; NAME=TEAM: the "
                   "name in the report")
      ->type_name("");
  command->add_option("--tries", o.tries, "Tries of each drill (default: as the drill says)")
      ->check(CLI::Range(1, 10000));
  command->add_option("--seed", o.seed, "Seed of the first try; the next one has the next seed")
      ->capture_default_str();
  command->add_option("--jobs", o.jobs, "Tries at once (default: one for each processor)")
      ->check(CLI::Range(1, 1024));
  add_parameters(*command.sub, "--param", o.parameters, "the teams");
  command
      ->add_option("--replay", o.replay_folder,
                   "Folder to write a record and a page of each failed try to")
      ->type_name("DIR");
  command
      ->add_option("--at-least", o.at_least,
                   "Score that each team shall reach: exit code 1 if one does not")
      ->check(CLI::Range(0.0, 100.0));
  CLI::Option* csv = command->add_flag("--csv", o.csv, "Print a line of CSV for each drill");
  command->add_flag("--json", o.json, "Print one JSON object")->excludes(csv);
}

void add_check(CLI::App& app, Run& run) {
  Subcommand<CheckOptions> command(
      app, run, "check", "Check whether a library would be accepted as an entry", run_check);
  CheckOptions& o = *command.options;
  command->add_option("FILE", o.path, "Library of the team (.so), or its file of Python (.py)")
      ->required();
  command
      ->add_option("--league", o.league,
                   "Field and number of robots: small (3 a side), middle (5), large (11)")
      ->check(CLI::IsMember({"small", "middle", "large"}))
      ->capture_default_str();
  command->add_option("--rules", o.rules, "Preset of the rules")
      ->check(one_of<referee::Preset>())
      ->capture_default_str();
  command
      ->add_option(
          "--half", o.half_s,
          "Seconds of a half in the league that it is for, which says how much time it has "
          "(default: as in the rules)")
      ->check(CLI::Range(record::min_half_s, record::max_half_s));
  add_parameters(*command.sub, "--param", o.parameters, "the team");
  command
      ->add_option("--record", o.record_path,
                   "Record of its leg against striker to write, for mirocup replay")
      ->type_name("FILE.json");
  command->add_flag("--json", o.json, "Print the report as one JSON object");
  command->add_flag("--steps", o.steps,
                    "Print \"step 3 of 10: entry\" on standard error before each check");
}

void add_compile(CLI::App& app, Run& run) {
  Subcommand<CompileOptions> command(
      app, run, "compile", "Compile a team's source as a league does: in a sandbox, fixed options",
      run_compile);
  CompileOptions& o = *command.options;
  command
      ->add_option(
          "SOURCE", o.path,
          "One file of C++20, or of C17 if its name ends in .c, or an archive of a project "
          "(.tar.gz, .tar, .zip)")
      ->required();
  command->add_option("-o,--output", o.output, "Library to write")
      ->type_name("FILE.so")
      ->required();
  command->add_option("--language", o.language, "Of the source, whatever its name")
      ->check(CLI::IsMember({"c", "c++", "project"}));
  command
      ->add_option("--seconds", o.seconds,
                   "Processor time that it may take, all compilers together (default: 60)")
      ->check(CLI::Range(1.0, 600.0));
  command->add_flag("--json", o.json, "Print the answer as one JSON object");
}

void add_hand_in(CLI::App& app, Run& run) {
  Subcommand<HandInOptions> command(
      app, run, "hand-in", "Hand a library in to a league in the network, and wait for the answer",
      run_hand_in);
  HandInOptions& o = *command.options;
  command->add_option("URL", o.url, "Address of the league, as https://league.example:8443")
      ->required();
  CLI::Option* file = command->add_option(
      "FILE", o.path,
      "Library of the team, its source, its file of Python, or an archive of its project");
  command
      ->add_option("--pin", o.pin,
                   "Send no file: let this accepted entry play, or \"latest\" again")
      ->type_name("N")
      ->excludes(file);
  command->add_option("--token-file", o.token_file, "File with the token of the team")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--ca", o.authority,
                   "File with the certificate that signs for the server (default: those of the "
                   "system)")
      ->type_name("FILE");
  command->add_flag("--json", o.json, "Print the answer as one JSON object");
}

void add_join(CLI::App& app, Run& run) {
  Subcommand<JoinOptions> command(app, run, "join", "Let a team play in a match on the network",
                                  run_join);
  JoinOptions& o = *command.options;
  command->add_option("--match", o.match_id, "ID of the match")->required();
  command->add_option("--team", o.team, "Colour of the team")
      ->required()
      ->check(CLI::IsMember({"blue", "yellow"}));
  command->add_option("--name", o.name, "Name of the team, as the match expects it (dds:NAME)")
      ->required();
  command->add_option("--server", o.server, "Host on which the match runs")->capture_default_str();
  add_dds_domain(*command.sub, o.dds_domain);
  command->add_option("--join-within", o.join_within, "Seconds to wait for the match")
      ->capture_default_str();
  command->add_option("--patience", o.join_within, "The older name of --join-within")->group("");
  command
      ->add_option("--credentials", o.credentials,
                   "Folder with the team's credentials, for a match that asks for them")
      ->type_name("DIR");
  add_parameters(*command.sub, "--param", o.parameters, "the team");
  command->add_option("FILE", o.library, "Library or file in Python of the team")->required();
}

void add_new(CLI::App& app, Run& run) {
  Subcommand<NewOptions> command(app, run, "new", "Make a folder with a team that builds as it is",
                                 run_new);
  command->add_option("DIR", command.options->folder, "Folder to make; must be new or empty")
      ->required();
  command->add_option("--language", command.options->language, "Language of the team")
      ->check(CLI::IsMember({"c++", "c", "python"}))
      ->capture_default_str();
  command
      ->add_option("--from-simurosot", command.options->simurosot,
                   "Folder with the sources of a team that was written for SimuroSot or Simuro5v5; "
                   "they are copied")
      ->type_name("OLD");
}

void add_export(CLI::App& app, Run& run) {
  Subcommand<ExportOptions> command(app, run, "export",
                                    "Write a learned network as the source of a team", run_export);
  ExportOptions& o = *command.options;
  command->add_option("POLICY", o.policy, "The network, an .npz of schema mirocup/policy/1")
      ->required();
  command->add_option("-o,--output", o.output, "File to write the source to")
      ->type_name("FILE.cpp")
      ->required();
}

void add_verify(CLI::App& app, Run& run) {
  Subcommand<VerifyOptions> command(
      app, run, "verify", "Simulate a record again from its commands and compare everything",
      run_verify);
  VerifyOptions& o = *command.options;
  command->add_option("RECORD", o.path, "Match record")->required();
  command->add_flag("--json", o.json, "Print the answer as one JSON object");
}

void add_rerun(CLI::App& app, Run& run) {
  Subcommand<RerunOptions> command(
      app, run, "rerun", "Let the teams of a record play again and compare their commands",
      run_rerun);
  RerunOptions& o = *command.options;
  command->add_option("RECORD", o.record, "Match record")->required();
  command->add_option("--entries", o.entries,
                      "Folder with the teams' libraries, which are found by their sha256 (default: "
                      "the entries of the league that the record belongs to)");
  command->add_flag("--json", o.json, "Print the answer as one JSON object");
}

void add_replay(CLI::App& app, Run& run) {
  Subcommand<ReplayOptions> command(
      app, run, "replay",
      "Make a page that shows a record in a browser, a picture of one moment, or a video",
      run_replay);
  ReplayOptions& o = *command.options;
  command->add_option("RECORD", o.record, "Match record")->required();
  command
      ->add_option("-o,--output", o.output,
                   "File to write to (default: beside the record, with the ending .html, .svg or "
                   ".webm)")
      ->type_name("FILE");
  CLI::Option* at =
      command->add_option("--at", o.at, "Moment of the picture in seconds since the match began");
  at->check(CLI::Range(0.0, 1e6));
  CLI::Option* svg = command->add_flag("--svg", o.svg, "Draw a still picture of the moment --at");
  command
      ->add_option("--clip", o.clip,
                   "FROM:TO in seconds since the match began: a video (.webm, .mp4 or .gif)")
      ->excludes(at)
      ->excludes(svg);
  command->add_flag("--open", o.open, "Open the page in a browser");
  command->add_flag("--no-times", o.no_times,
                    "Leave out times that a clock measured, so that the page is the same on "
                    "every machine");
  command->add_flag("--public", o.public_page,
                    "Leave out what only the teams may see: their thoughts and logs");
  command
      ->add_option("--statistics", o.statistics,
                   "File to write the statistics of the leg to, as JSON")
      ->type_name("FILE");
}

void add_stats(CLI::App& app, Run& run) {
  Subcommand<StatsOptions> command(
      app, run, "stats",
      "Print the football statistics of legs: shots, passes, possession, fouls, goals by kind",
      run_stats);
  StatsOptions& o = *command.options;
  command->add_option("RECORD", o.paths, "Match records, or the folder of one league")->required();
  command->add_flag("--goals", o.goals,
                    "How goals fell, where the ball was lost before, which laws were broken");
  command->add_option("--team", o.team, "Only the legs of this team, named as in the records")
      ->type_name("NAME");
  CLI::Option* csv = command->add_flag("--csv", o.csv, "Comma-separated values");
  command->add_flag("--json", o.json, "Everything as one JSON object")->excludes(csv);
}

void add_record_as_seen(CLI::App& app, Run& run) {
  Subcommand<RecordAsSeenOptions> command(
      app, run, "record-as-seen",
      "Write what a camera would have seen of a played match, as a recording", run_record_as_seen);
  RecordAsSeenOptions& o = *command.options;
  command->add_option("RECORD", o.record, "Match record, written by --record")->required();
  command->add_option("-o", o.output, "The recording (mirocup/recording/1)")
      ->type_name("FILE")
      ->required();
  command->add_option("--noise-mm", o.noise_mm, "Standard deviation of a position, mm")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  command->add_option("--noise-deg", o.noise_deg, "Standard deviation of a heading, degrees")
      ->check(CLI::Range(0.0, 90.0))
      ->capture_default_str();
  command->add_option("--gaps", o.gaps, "Share of bodies that a picture misses")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command->add_option("--outliers", o.outliers, "Share of bodies that are seen anywhere")
      ->check(CLI::Range(0.0, 0.5))
      ->capture_default_str();
  command->add_option("--seed", o.seed, "Seed of the noise")
      ->check(CLI::Validator(system::problem_with_seed, "SEED"))
      ->capture_default_str();
}

void add_identify(CLI::App& app, Run& run) {
  Subcommand<IdentifyOptions> command(
      app, run, "identify",
      "Find the numbers of a pitch from recordings: floor, walls, motors, camera", run_identify);
  IdentifyOptions& o = *command.options;
  command
      ->add_option("RECORDING", o.recordings,
                   "Recordings (mirocup/recording/1, or .csv) of one pitch")
      ->required();
  command->add_option("-o", o.output, "The pitch (mirocup/pitch/1)")->type_name("FILE")->required();
  command
      ->add_option("--pitch", o.pitch,
                   "What is known: sizes and masses, and what recordings do not tell")
      ->type_name("NAME|FILE")
      ->capture_default_str();
  command->add_option("--page", o.page, "A page with the intervals")->type_name("FILE");
  command->add_flag("--json", o.json, "Print the pitch as one JSON object");
}

void add_validate(CLI::App& app, Run& run) {
  Subcommand<ValidateOptions> command(
      app, run, "validate",
      "Say how far the simulator is from recordings, 1 to 30 pictures ahead, beside yardsticks; "
      "exits with 1 where it is worse than one",
      run_validate);
  ValidateOptions& o = *command.options;
  command->add_option("RECORDING", o.recordings, "Recordings (mirocup/recording/1, or .csv)")
      ->required();
  command->add_option("--pitch", o.pitch, "The pitch to simulate with")
      ->type_name("NAME|FILE")
      ->capture_default_str();
  command->add_option("-o,--page", o.page, "A page with pictures")->type_name("FILE");
  command
      ->add_option("--against", o.against,
                   "Another engine as a further yardstick, where mirocup-bench is built with it: "
                   "box2d, chipmunk or ode")
      ->type_name("ENGINE");
  command->add_flag("--json", o.json, "Print one JSON object");
}

void add_scene(CLI::App& app, Run& run) {
  Subcommand<SceneOptions> command(
      app, run, "scene", "Simulate a scene: bodies and wheel commands, without teams and laws",
      run_scene);
  SceneOptions& o = *command.options;
  command->add_option("FILE", o.path, "Scene, a file of schema mirocup/scene/1")->required();
  command->add_option("--accuracy", o.accuracy, "Accuracy of lasting contacts (default: standard)")
      ->check(CLI::IsMember({"coarse", "standard", "reference"}));
  command
      ->add_option("-o,--output", o.out, "File to write the result to (default: standard output)")
      ->type_name("FILE");
  command->add_flag("--json", o.json, "Accepted for uniformity: the result is always JSON");
}

void add_referee(CLI::App& app, Run& run) {
  Subcommand<RefereeOptions> command(
      app, run, "referee",
      "Judge recorded situations, or judge a played match with other parameters", run_referee);
  RefereeOptions& o = *command.options;
  CLI::Option* trace =
      command->add_option("TRACE", o.trace_path, "File of situations, one JSON object a line");
  CLI::Option* record =
      command->add_option("--record", o.record_path, "Match record to judge again")
          ->excludes(trace);
  command
      ->add_option("--rule", o.rule_changes,
                   "Change a parameter of the record's rules; may be given several times")
      ->type_name("KEY=VALUE")
      ->needs(record);
  command->add_flag("--json", o.json, "Print the answer as one JSON object");
}

void add_completion(CLI::App& app, Run& run) {
  Subcommand<CompletionOptions> command(app, run, "completion",
                                        "Print the script by which a shell completes what is typed",
                                        run_completion);
  command->add_option("SHELL", command.options->shell, "The shell that reads it")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

// Commands of other programs, which are started before this command line is read.
void add_league(CLI::App& app) {
  app.add_subcommand("league", "Make, play and show leagues: mirocup help league");
}
void add_tune(CLI::App& app) {
  app.add_subcommand("tune", "Find better numbers for a team: mirocup tune --help");
}
void add_bench(CLI::App& app) {
  app.add_subcommand("bench", "Compare speed and error with other engines: mirocup help bench");
}

constexpr const char* for_teams = "A team";
constexpr const char* after_a_leg = "After a leg";
constexpr const char* for_leagues = "Leagues";
constexpr const char* for_engineers = "Referee, pitches and physics";
constexpr const char* for_shells = "Shells";

const system::CommandHelp help_of_commands[] = {
    {"new",
     for_teams,
     {"mirocup new mine && cd mine && cmake --workflow --preset team",
      "mirocup new mine --language python"}},
    {"match",
     for_teams,
     {"mirocup match --blue mine.so --yellow striker --seed 7 --record leg.json",
      "mirocup match --blue mine.py --yellow chaser --watch",
      "mirocup match --blue mine.so --yellow mine.so --blue-param wait=0.5"}},
    {"check", for_teams, {"mirocup check mine.so", "mirocup check mine.py --league large"}},
    {"drill",
     for_teams,
     {"mirocup drill list", "mirocup drill shoot-open-goal mine.so --replay failed",
      "mirocup drill all mine.so striker --csv"}},
    {"compile", for_teams, {"mirocup compile mine.cpp -o mine.so"}},
    {"export", for_teams, {"mirocup export policy.npz -o learned.cpp"}},
    {"tune",
     for_teams,
     {"mirocup tune mine.so --param wait=0.3:0.6 --against chaser,striker -o tuned"}},
    {"hand-in",
     for_teams,
     {"mirocup hand-in https://league.example:8443 mine.so --token-file token"}},
    {"join",
     for_teams,
     {"mirocup join --match 7 --team blue --name ours mine.so",
      "mirocup join --match 7 --team yellow --name theirs their.so --server 10.0.0.5"}},
    {"replay",
     after_a_leg,
     {"mirocup replay leg.json --open", "mirocup replay leg.json --clip 12:18 -o goal.gif",
      "mirocup replay leg.json --at 12.5 --svg -o moment.svg"}},
    {"stats", after_a_leg, {"mirocup stats leg.json --goals", "mirocup stats spring --csv"}},
    {"verify", after_a_leg, {"mirocup verify leg.json"}},
    {"rerun", after_a_leg, {"mirocup rerun leg.json --entries teams"}},
    {"league",
     for_leagues,
     {"mirocup league init spring --team alpha=alpha.so --team house=house:striker",
      "mirocup league start spring"}},
    {"referee",
     for_engineers,
     {"mirocup referee trace.jsonl", "mirocup referee --record leg.json --rule stalemate_s=5"}},
    {"record-as-seen", for_engineers, {"mirocup record-as-seen leg.json -o seen.jsonl"}},
    {"identify", for_engineers, {"mirocup identify seen.jsonl -o ours.json --page ours.html"}},
    {"validate",
     for_engineers,
     {"mirocup validate seen.jsonl --pitch ours.json -o validation.html"}},
    {"scene", for_engineers, {"mirocup scene scene.json --accuracy reference -o result.json"}},
    {"bench", for_engineers, {"mirocup bench --quick"}},
    {"completion",
     for_shells,
     {"mirocup completion bash >~/.local/share/bash-completion/completions/mirocup",
      "mirocup completion fish >~/.config/fish/completions/mirocup.fish"}},
};

const system::ValueNames value_names{
    {"--seed", "SEED"},          {"--half", "SECONDS"},      {"--tick", "TICK"},
    {"--match", "ID"},           {"--interface", "NAME"},    {"--join-within", "SECONDS"},
    {"--away-limit", "SECONDS"}, {"--dds-domain", "NUMBER"}, {"--tries", "NUMBER"},
    {"--jobs", "NUMBER"},        {"--at-least", "MARKS"},    {"--name", "NAME"},
    {"--server", "HOST"},        {"--entries", "DIR"},       {"--at", "SECONDS"},
    {"--clip", "FROM:TO"},       {"--noise-mm", "MM"},       {"--noise-deg", "DEGREES"},
    {"--gaps", "SHARE"},         {"--outliers", "SHARE"},    {"--record", "RECORD"},
};

}  // namespace

std::optional<int> read_command_line(int argc, char** argv, Run& run) {
  CLI::App cli("A tournament platform for MiroSot robot soccer.", "mirocup");
  cli.require_subcommand(1);
  cli.set_version_flag("-v,--version", record::software_version());
  cli.footer("mirocup help COMMAND explains a command, with examples.");
  add_match(cli, run);
  add_drill(cli, run);
  add_check(cli, run);
  add_compile(cli, run);
  add_hand_in(cli, run);
  add_join(cli, run);
  add_new(cli, run);
  add_export(cli, run);
  add_verify(cli, run);
  add_rerun(cli, run);
  add_replay(cli, run);
  add_stats(cli, run);
  add_league(cli);
  add_record_as_seen(cli, run);
  add_identify(cli, run);
  add_validate(cli, run);
  add_scene(cli, run);
  add_referee(cli, run);
  add_tune(cli);
  add_bench(cli);
  add_completion(cli, run);
  system::finish_help(cli, help_of_commands, value_names);
  if (const auto told =
          system::tell_about(cli, argc, argv, record::software_version(), system::house_teams()))
    return told;
  return system::parse_command_line(cli, argc, argv);
}

}  // namespace mirocup::app
