// SPDX-License-Identifier: MIT
//
// mirocup match: plays one leg and writes its record.
#include "plugins/host/sandbox/probe.hpp"
#include "programs/check/entry_advice.hpp"
#include "programs/mirocup/commands.hpp"
#include "programs/mirocup/output_folder.hpp"
#include "record/conditions_json.hpp"
#include "record/pitch_json.hpp"
#include "record/rules_json.hpp"
#include "record/situation_json.hpp"
#include "record/team_parameters_json.hpp"
#include "record/thoughts_file.hpp"
#include "server/dds/domain.hpp"
#include "server/session.hpp"
#include "system/number_of.hpp"

#include <filesystem>
#include <limits>

namespace mirocup::app {

namespace {

struct MatchOptions {
  match::ByTeam<std::string> teams;
  match::ByTeam<std::string> names;  // in the record; "": the team's own name
  std::string league;                // "": small, or that of the situation
  std::string rules = "mirosot";
  std::string stage = "group";
  std::uint64_t seed = 1;
  std::string speed;  // "": real time if it is watched, otherwise "max"
  std::optional<std::string>
      watch;               // address of the live page: PORT, HOST:PORT, or "" for any port
  std::string start_path;  // of a situation; "": the leg starts with its kick-off
  std::string from_path;   // of the record to play on from; "": none
  std::optional<std::uint32_t> tick;  // of that record
  std::optional<double> half_s;
  std::vector<std::string> rule_changes;       // KEY=VALUE
  std::string conditions;                      // a preset; "": those of the pitch, or the default
  std::string pitch;                           // --pitch; "": mirosot
  std::vector<std::string> condition_changes;  // KEY=VALUE
  std::vector<std::string> parameters;         // of both teams, KEY=VALUE
  match::ByTeam<std::vector<std::string>> own_parameters;  // of one team; they win
  std::string record_path;
  server::SessionTerms session;
  bool hash = false;  // print the state hash, too
  bool prints_firewall = false;
  bool json = false;
  std::string answer;  // file for the port of the live page, and for an error
};

Result<void> read_start(const MatchOptions& options, match::Setup& setup) {
  if (options.start_path.empty()) return {};
  MIROCUP_TRY(const auto text,
              system::Disk().read_named(options.start_path, system::size_limit::note));
  MIROCUP_TRY(const auto situation, record::parse_situation(text, options.start_path));
  const std::string league(to_string(situation.league));
  if (!options.league.empty() && options.league != league)
    return fail(Errc::input, options.start_path + ": it is a situation of the " + league +
                                 " league, not of --league " + options.league);
  setup.league = situation.league;
  setup.start = situation.start;
  return {};
}

Result<match::Setup> setup_of(const MatchOptions& options) {
  match::Setup setup;
  if (!options.league.empty()) setup.league = *from_string<RobotLeague>(options.league);
  MIROCUP_TRY_VOID(read_start(options, setup));
  MIROCUP_TRY(auto rules, record::rules_with_changes({{"preset", options.rules}},
                                                     options.rule_changes, setup.league));
  setup.rules = rules;
  setup.stage = *from_string<referee::Stage>(options.stage);
  setup.seed = options.seed;
  setup.control_period = match::control_period_of(setup.rules.preset);
  if (options.half_s) setup.rules.half_s = *options.half_s;
  MIROCUP_TRY(const auto pitch,
              record::pitch_of_option(options.pitch.empty() ? "mirosot" : options.pitch));
  match::set_pitch(setup, pitch);
  if (pitch.conditions && options.conditions.empty() && options.condition_changes.empty()) {
    setup.conditions = *pitch.conditions;
    return setup;
  }
  MIROCUP_TRY(
      const auto conditions,
      record::conditions_with_changes(
          options.conditions.empty() ? match::default_preset
                                     : *from_string<match::ConditionsPreset>(options.conditions),
          options.condition_changes));
  setup.conditions = conditions;
  return setup;
}

// Reads the record to play on from, if there is one.
Result<std::optional<record::MatchRecord>> read_past(const MatchOptions& options) {
  if (options.from_path.empty()) return std::nullopt;
  system::Disk disk;
  MIROCUP_TRY(auto past, record::load(disk, options.from_path));
  const std::size_t ticks = past.recording.ticks.size();
  if (*options.tick >= ticks)
    return fail(Errc::input, options.from_path + ": its leg has " + std::to_string(ticks) +
                                 " ticks, so --tick is at most " + std::to_string(ticks - 1));
  return past;
}

Result<std::optional<double>> factor_of(const MatchOptions& options) {
  const std::string& speed = options.speed;
  // VSSS programs live by the wall clock unless they are told otherwise.
  const bool any_firasim =
      options.teams[0].rfind("firasim:", 0) == 0 || options.teams[1].rfind("firasim:", 0) == 0;
  const bool by_the_clock =
      options.watch.has_value() || (any_firasim && !options.session.network.lockstep);
  if (speed.empty() && by_the_clock) return std::optional<double>(1.0);
  if (speed.empty() || speed == "max") return std::optional<double>();
  const auto factor = system::number_of<double>(speed);
  if (!factor || *factor <= 0.0 || *factor > 1e6)
    return fail(Errc::input, "--speed " + speed + ": \"max\" or a number above 0 is expected");
  return factor;
}

// Gives the teams their parameters, which a team on the network gets from its own program.
Result<void> give_parameters(const MatchOptions& options,
                             match::ByTeam<server::TeamChoice>& choices) {
  MIROCUP_TRY(const auto shared,
              record::parameters_with_changes({}, options.parameters, "--param"));
  bool is_for_a_library = shared.empty();
  for (const Team team : both_teams) {
    const std::string option = "--" + std::string(to_string(team)) + "-param";
    const auto& own = options.own_parameters[index_of(team)];
    record::TeamInfo& info = choices[index_of(team)].info;
    if (record::is_on_network(info.kind)) {
      if (own.empty()) continue;
      return fail(Errc::input, option + " " + own[0] + ": " + info.name +
                                   " plays over the network; give the parameter to mirocup join");
    }
    MIROCUP_TRY(info.parameters, record::parameters_with_changes(shared, own, option));
    is_for_a_library = true;
  }
  if (is_for_a_library) return {};
  return fail(Errc::input,
              "--param " + options.parameters[0] +
                  ": both teams play over the network; give the parameter to mirocup join");
}

Result<match::ByTeam<server::TeamChoice>> choose_teams(const MatchOptions& options) {
  match::ByTeam<server::TeamChoice> choices;
  for (const Team team : both_teams) {
    MIROCUP_TRY(choices[index_of(team)], server::choose_team(options.teams[index_of(team)]));
    const std::string& name = options.names[index_of(team)];
    if (!name.empty()) choices[index_of(team)].info.name = name;
  }
  MIROCUP_TRY_VOID(give_parameters(options, choices));
  return choices;
}

// True if logs and thoughts can stand beside the record.
bool has_folder(const MatchOptions& options) {
  return !options.record_path.empty() && !system::is_written_in_place(options.record_path);
}

std::string log_path(const MatchOptions& options, Team team) {
  return options.record_path + "." + std::string(to_string(team)) + ".log";
}

server::SessionTerms session_terms(const MatchOptions& options) {
  server::SessionTerms terms = options.session;
  for (const Team team : both_teams) {
    terms.keeps_name[index_of(team)] = !options.names[index_of(team)].empty();
    if (has_folder(options)) terms.logs[index_of(team)] = log_path(options, team);
  }
  return terms;
}

// Without --thoughts, those of an earlier leg in the same place are removed: they are of no use.
Result<void> write_thoughts(const MatchOptions& options, server::Session& session, Team team) {
  const std::string path = record::thoughts_path(options.record_path, team);
  if (!session.terms.thoughts) {
    std::error_code none;
    std::filesystem::remove(path, none);
    return {};
  }
  record::ThoughtsWriter& writer = session.thoughts[index_of(team)];
  if (writer.left_out() > 0) {
    std::cerr << "mirocup: warning: " << writer.left_out() << " shapes of the " << to_string(team)
              << " team's thoughts were left out, see \"Thoughts\" in strategy.h\n";
  }
  return system::Disk().write(path, writer.packed(), system::Readers::owner);
}

Result<void> write_record(const MatchOptions& options, server::Session& session) {
  if (options.record_path.empty()) return {};
  system::Disk disk;
  MIROCUP_TRY_VOID(record::save(disk, options.record_path, server::record_of(session)));
  if (!has_folder(options)) return {};
  for (const Team team : both_teams) {
    MIROCUP_TRY_VOID(write_thoughts(options, session, team));
    const std::string text = session.seats[index_of(team)].output();
    if (text.empty()) continue;
    MIROCUP_TRY_VOID(disk.write(log_path(options, team), text));
  }
  return {};
}

// A name with a slip in it would otherwise have no effect, silently.
record::Json warn_of_unknown_parameters(const server::Session& session) {
  record::Json unknown = record::Json::array();
  if (session.leg.tick() == 0) return unknown;  // a team that never played asked for nothing
  const auto blue = session.seats[0].unknown_parameters();
  const auto yellow = session.seats[1].unknown_parameters();
  const auto is_known_to = [](const server::TeamSeat& seat, const match::TeamParameters& unasked,
                              const std::string& name) {
    return seat.info().parameters.count(name) != 0 && unasked.count(name) == 0;
  };
  match::TeamParameters all = blue;
  all.insert(yellow.begin(), yellow.end());
  for (const auto& entry : all) {
    const std::string& name = entry.first;
    if (is_known_to(session.seats[0], blue, name) || is_known_to(session.seats[1], yellow, name))
      continue;
    std::cerr << "mirocup: warning: no team asked for the parameter " << name << '\n';
    unknown.push_back(name);
  }
  return unknown;
}

// Says what to do about a fault of a team whose author may be here.
void advise(const MatchOptions& options, const server::Session& session,
            const match::TeamFault& f) {
  const server::TeamSeat& seat = session.seats[index_of(f.team)];
  if (seat.info().kind != record::TeamKind::plugin) return;
  const std::string& team = options.teams[index_of(f.team)];
  FaultEvidence evidence{.fault = f.fault, .words = {}, .is_python = team.ends_with(".py")};
  if (const plugins::ProcessController* process = seat.process()) {
    evidence.words = process->exit_report();
    evidence.requests = process->requests();
  }
  std::cerr << "do: " << advice_on(evidence) << "; mirocup check " << system::printable(team)
            << " says more\n";
}

void report(const MatchOptions& options, const server::Session& session) {
  if (options.json) {
    print_json(record::to_json(server::record_of(session)));
    return;
  }
  const match::Outcome& r = session.leg.outcome();
  std::cout << system::printable(session.seats[0].info().name) << " (blue) " << r.score[0] << " : "
            << r.score[1] << " " << system::printable(session.seats[1].info().name) << " (yellow), "
            << to_string(r.kind) << " after " << session.leg.tick() << " ticks";
  if (options.hash) std::cout << ", state hash " << to_hex(session.leg.state_hash());
  std::cout << '\n';
  for (const match::TeamFault& f : r.faults) {
    std::cout << to_string(f.team) << ": " << to_string(f.fault.code) << ": "
              << system::printable(f.fault.text) << '\n';
    advise(options, session, f);
  }
  if (!r.why_void.empty()) std::cout << "void: " << system::printable(r.why_void) << '\n';
}

void show_backtraces(const server::Session& session) {
  for (const Team team : both_teams) {
    const plugins::ProcessController* process = session.seats[index_of(team)].process();
    if (process == nullptr || process->backtrace().empty()) continue;
    std::cerr << "mirocup: the " << to_string(team) << " team crashed in\n" << process->backtrace();
  }
}

// A team finds more of a host in T1, for example its processes.
void tell_weaker_isolation(const MatchOptions& options, const server::Session& session) {
  if (!options.session.isolation.empty() || session.isolation != "T1") return;
  std::cerr << "mirocup: teams play in tier T1, not T2: " << plugins::why_no_t2() << '\n';
}

// A leg that cannot be written should not be played first.
Result<void> check_output(const MatchOptions& options) {
  if (options.record_path.empty()) return {};
  if (std::error_code none; std::filesystem::is_directory(options.record_path, none)) {
    return fail(Errc::unavailable, options.record_path + " cannot be written: it is a folder");
  }
  return expect_writable_folder_of(options.record_path);
}

Result<int> run_match(const MatchOptions& options, const record::WriteAnswer& answer) {
  if (options.prints_firewall) {
    std::cout << dds::firewall_rules(options.session.network.dds_domain);
    return exit_yes;
  }
  MIROCUP_TRY(const auto past, read_past(options));
  MIROCUP_TRY(const auto setup,
              past ? Result<match::Setup>(past->recording.setup) : setup_of(options));
  MIROCUP_TRY(const auto factor, factor_of(options));
  MIROCUP_TRY_VOID(check_output(options));

  server::Session session(session_terms(options), setup, factor);
  if (past) MIROCUP_TRY_VOID(server::play_past(session, *past, *options.tick, options.from_path));
  MIROCUP_TRY(const auto teams, choose_teams(options));
  MIROCUP_TRY_VOID(server::seat_teams(session, teams));
  if (options.watch) {
    MIROCUP_TRY_VOID(server::open_live_page(session, *options.watch));
    MIROCUP_TRY_VOID(answer({{"port", session.live->port()}}));
  }
  tell_weaker_isolation(options, session);  // last, so that an error stands alone
  MIROCUP_TRY_VOID(server::play(session));
  if (auto written = write_record(options, session); !written) {
    report(options, session);  // the score is known, if nothing else
    return tl::unexpected(written.error());
  }
  if (session.live) session.live->close(session.leg);
  const record::Json unknown = warn_of_unknown_parameters(session);
  if (!unknown.empty()) MIROCUP_TRY_VOID(answer({{"unknown_parameters", unknown}}));
  report(options, session);
  show_backtraces(session);
  const bool is_void = session.leg.outcome().kind == match::OutcomeKind::void_;
  return is_void ? exit_code(Errc::host) : exit_yes;
}

void add_firasim(const system::Command& command, server::NetworkTerms& o) {
  const char* group = "Teams that speak the protocol of FIRASim and VSSReferee";
  const auto add = [&](const char* option, std::string& value, const char* description) {
    command.option(option, value, description).in_group(group);
  };
  add("--firasim-vision ADDR:PORT[,...]", o.firasim.vision,
      "Where vision is sent to: groups or single addresses (default: 224.0.0.1:10002)");
  add("--firasim-command [ADDR:]PORT", o.firasim.command,
      "Where commands are received (default: 20011)");
  add("--firasim-referee ADDR:PORT[,...]", o.firasim.referee,
      "Where the referee's calls are sent to (default: 224.5.23.2:10003)");
  add("--firasim-placement ADDR:PORT", o.firasim.placement,
      "Where placements are received (default: 224.5.23.2:10004)");
  command
      .option("--firasim-instance K|auto", o.firasim_instance,
              "Number K of this match on this host; if K is above 0, its ports are 10002+K, "
              "20011+K, 40000+K and 50000+K; auto: the first free number from 1000 on")
      .between_or(0, 9999, "auto")
      .in_group(group);
  add("--blue-program COMMAND", o.programs[0],
      "Shell command that starts the blue team's program; the environment variables "
      "MIROCUP_COLOUR and others tell it colour and addresses (docs/firasim.md)");
  add("--yellow-program COMMAND", o.programs[1],
      "Shell command that starts the yellow team's program");
  command
      .flag("--lockstep", o.lockstep,
            "Wait in each tick until the firasim teams have commanded all their robots; --speed "
            "max has the same effect")
      .in_group(group);
}

}  // namespace

void add_match(system::Commands& commands) {
  const auto [command, o] =
      commands.add(answering<run_match, MatchOptions>, "match", for_teams, "Play one leg",
                   {"mirocup match --blue mine.so --yellow striker --seed 7 --record leg.json",
                    "mirocup match --blue mine.py --yellow chaser --watch",
                    "mirocup match --blue mine.so --yellow mine.so --blue-param wait=0.5"});
  server::NetworkTerms& network = o.session.network;
  command
      .option("--blue TEAM", o.teams[0],
              "Blue team: a library (.so), a file of Python (.py), the name of a house team, "
              "dds:NAME, or firasim:NAME for a program that speaks FIRASim's protocol")
      .required();
  command.option("--yellow TEAM", o.teams[1], "Yellow team, named in the same way").required();
  command.option("--blue-name NAME", o.names[0], "Name of the blue team in the record");
  command.option("--yellow-name NAME", o.names[1], "Name of the yellow team in the record");
  const system::Option start =
      command.option("--start SITUATION.json", o.start_path,
                     "Start in this situation, a file of schema mirocup/situation/1");
  const system::Option from = command
                                  .option("--from RECORD", o.from_path,
                                          "Continue this record from --tick on, with its league, "
                                          "rules, stage, seed and conditions")
                                  .excludes(start);
  const system::Option tick =
      command.option("--tick TICK", o.tick, "Tick of the record at which to continue")
          .between(0, std::numeric_limits<int>::max())
          .needs(from);
  from.needs(tick);
  command
      .option("--league", o.league,
              "Field and number of robots: small (3 a side), middle (5), large (11); default: "
              "small, or that of the situation")
      .one_of(system::names_of<RobotLeague>())
      .excludes(from);
  command.option("--rules", o.rules, "Preset of the rules")
      .one_of(system::names_of<referee::Preset>())
      .shows_default()
      .excludes(from);
  command.option("--stage", o.stage, "group: a draw stands; knockout: a winner is found")
      .one_of(system::names_of<referee::Stage>())
      .shows_default()
      .excludes(from);
  command.option("--seed SEED", o.seed, "Seed of the toss and of the teams' random numbers")
      .is_a_seed()
      .shows_default()
      .excludes(from);
  command.option(
      "--speed FACTOR", o.speed,
      "Speed of the match: max, or a factor of real time (default: 1 with --watch or with "
      "a firasim team without --lockstep, otherwise max)");
  command.option_or_flag(
      "--watch [PORT]", o.watch,
      "Show the match in browsers at [HOST:]PORT (default: this host only, any free port)");
  command.option("--half SECONDS", o.half_s, "Length of a half in seconds")
      .between(record::min_half_s, record::max_half_s)
      .excludes(from);
  command
      .option("--rule KEY=VALUE", o.rule_changes,
              "Change a parameter of the rules; may be given several times")
      .excludes(from);
  command
      .option("--conditions", o.conditions,
              "Disturbances of the leg: exact (none), hall (placing by hand, wheels and floor) or "
              "camera (those of hall, of a camera and of a radio); default: those of the pitch, if "
              "it has any, otherwise " +
                  std::string(to_string(match::default_preset)))
      .one_of(system::names_of<match::ConditionsPreset>())
      .excludes(from);
  command
      .option("--pitch NAME|FILE", o.pitch,
              "Robots, ball and floor: mirosot (default), vsss, simurosot, or a file "
              "(mirocup/pitch/1), for example of mirocup identify")
      .excludes(from);
  command
      .option("--condition KEY=VALUE", o.condition_changes,
              "Change a value of the conditions; may be given several times")
      .excludes(from);
  add_parameters(command, "--param", o.parameters, "both teams");
  add_parameters(command, "--blue-param", o.own_parameters[0], "the blue team");
  add_parameters(command, "--yellow-param", o.own_parameters[1], "the yellow team");
  const system::Option record =
      command.option("--record FILE", o.record_path, "File to write the match record to");
  command
      .flag("--thoughts", o.session.thoughts,
            "Keep the shapes that the teams draw, beside the record, for mirocup replay")
      .needs(record);
  const system::Option trusted =
      command.flag("--trusted", o.session.trusted,
                   "Run the teams in this process, without protection from them");
  command
      .option("--isolation", o.session.isolation,
              "Tier of the sandbox: T2 (namespaces) or T1 (filtered system calls); if this system "
              "does not allow the tier, the match is not played (default: the strongest tier that "
              "it allows)")
      .one_of({"T1", "T2"})
      .excludes(trusted);
  command.option("--match ID", network.match_id, "ID of the match, by which DDS teams join it")
      .shows_default();
  command
      .option("--interface NAME", network.interface,
              "Network interface for teams on the network; lo: this host only")
      .shows_default();
  add_dds_domain(command, network.dds_domain);
  command.flag("--nat", network.nat,
               "DDS teams may be behind routers that translate addresses (NAT); answer to the "
               "address that their packets come from");
  command.flag("--open", network.is_open, "With --nat: let teams join without credentials");
  command.flag("--print-firewall", o.prints_firewall,
               "Play nothing, and print nftables rules that limit what each address may send to "
               "the ports of --dds-domain");
  command
      .option("--join-within SECONDS", network.join_within,
              "Seconds that a team on the network has to join the match")
      .between(0.0, longest_wait_s)
      .shows_default();
  command
      .option("--away-limit SECONDS", network.away_limit,
              "Seconds that a DDS team may be absent in total, or a firasim team may be silent "
              "(default: 10; 30 for a firasim team with --lockstep or --speed max)")
      .between(0.0, longest_wait_s);
  command.option("--credentials DIR", network.credentials,
                 "Folder with the server's credentials; then only teams of the league can join");
  command.flag("--hash", o.hash, "Also print the state hash of the leg");
  add_firasim(command, network);
  command.flag("--json", o.json, "Print the record as one JSON object");
  add_answer(command, o.answer);
}

}  // namespace mirocup::app
