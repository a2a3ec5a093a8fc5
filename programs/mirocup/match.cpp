// SPDX-License-Identifier: MIT
//
// mirocup match: plays one leg and writes its record.
#include "core/match/call_text.hpp"
#include "core/replay/recorded.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "programs/mirocup/commands.hpp"
#include "programs/mirocup/output_folder.hpp"
#include "record/conditions_json.hpp"
#include "record/json_reader.hpp"
#include "record/pitch_json.hpp"
#include "record/rules_json.hpp"
#include "record/situation_json.hpp"
#include "record/team_parameters_json.hpp"
#include "record/thoughts_file.hpp"
#include "server/pace/pacer.hpp"
#include "server/seats.hpp"
#include "server/team_program.hpp"
#include "system/interrupt.hpp"
#include "system/printable.hpp"
#include "web/live_server.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <unistd.h>

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
  bool calls = false;                 // print them
  std::optional<double> half_s;
  std::vector<std::string> rule_changes;       // KEY=VALUE
  std::string conditions;                      // a preset; "": those of the pitch, or the default
  std::string pitch;                           // --pitch; "": mirosot
  std::vector<std::string> condition_changes;  // KEY=VALUE
  std::vector<std::string> parameters;         // of both teams, KEY=VALUE
  match::ByTeam<std::vector<std::string>> own_parameters;  // of one team; they win
  std::string record_path;
  bool thoughts = false;  // keep what the teams draw
  bool trusted = false;
  std::string isolation;  // "": the strongest that this system allows
  std::string match_id = "1";
  std::string interface = "lo";
  int dds_domain = 0;
  double join_within = 60.0;         // s that a DDS team has to join
  std::optional<double> away_limit;  // s that a team on the network may be absent
  std::string credentials;
  bool hash = false;  // print the state hash, too
  // Addresses of firasim teams; "": those of the instance.
  std::string firasim_vision, firasim_command, firasim_referee, firasim_placement;
  std::string firasim_instance = "0";   // a number, or "auto"
  match::ByTeam<std::string> programs;  // commands that start firasim teams; "": people do
  bool lockstep = false;  // firasim teams are waited for even where real time is asked for
  bool json = false;
};

// The share of a tick in which a team on the network must answer in real time. The rest is for the
// simulation, so that a late team does not delay the next tick.
constexpr double answer_share = 0.9;

// A team that has not answered for this many ticks, and for at least this time, is absent.
constexpr double ticks_to_notice = 9.0;
constexpr double min_notice = 0.1;  // s

// How long a team on the network may be absent, and one that a match in lock-step waits for, s: the
// machine may be slow, and no viewer waits.
constexpr double away_limit = 10.0;
constexpr double lockstep_away_limit = 30.0;

// The clock of a half stands at restarts. They take far less than half as much time again.
constexpr double share_for_restarts = 1.5;

Result<void> read_start(const MatchOptions& options, match::Setup& setup) {
  if (options.start_path.empty()) return {};
  MIROCUP_TRY(const auto text,
              system::Disk().read(options.start_path, {.max_size = system::size_limit::note,
                                                       .links = system::Links::followed}));
  MIROCUP_TRY(const auto situation, record::parse_situation(text, options.start_path));
  const std::string league(to_string(situation.league));
  if (!options.league.empty() && options.league != league) {
    return fail(Errc::input, options.start_path + ": it is a situation of the " + league +
                                 " league, not of --league " + options.league);
  }
  setup.league = situation.league;
  setup.start = situation.start;
  return {};
}

Result<match::Setup> setup_of(const MatchOptions& options) {
  match::Setup setup;
  if (!options.league.empty()) setup.league = *from_string<League>(options.league);
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
  if (*options.tick >= ticks) {
    return fail(Errc::input, options.from_path + ": its leg has " + std::to_string(ticks) +
                                 " ticks, so --tick is at most " + std::to_string(ticks - 1));
  }
  return past;
}

Result<std::optional<double>> factor_of(const MatchOptions& options) {
  const std::string& speed = options.speed;
  // VSSS programs live by the wall clock unless they are told otherwise.
  const bool any_firasim =
      options.teams[0].rfind("firasim:", 0) == 0 || options.teams[1].rfind("firasim:", 0) == 0;
  const bool by_the_clock = options.watch.has_value() || (any_firasim && !options.lockstep);
  if (speed.empty() && by_the_clock) return std::optional<double>(1.0);
  if (speed.empty() || speed == "max") return std::optional<double>();
  char* end = nullptr;
  const double factor = std::strtod(speed.c_str(), &end);
  if (end == speed.c_str() || *end != '\0' || !(factor > 0.0) || factor > 1e6) {
    return fail(Errc::input, "--speed " + speed + ": \"max\" or a number above 0 is expected");
  }
  return std::optional<double>(factor);
}

// Gives the teams their parameters, which a team on the network gets from its own program.
Result<void> give_parameters(const MatchOptions& options,
                             std::vector<server::TeamChoice>& choices) {
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
                                   " plays over the network; give it to mirocup join");
    }
    MIROCUP_TRY(info.parameters, record::parameters_with_changes(shared, own, option));
    is_for_a_library = true;
  }
  if (is_for_a_library) return {};
  return fail(Errc::input, "--param " + options.parameters[0] +
                               ": both teams play over the network; give it to mirocup join");
}

// The numbers of matches on this host that find ports of their own (--firasim-instance auto).
constexpr int first_free_instance = 1000;
constexpr int most_instances = 1000;

// At full speed a match polls for an interrupt only this often, because polling is a system call.
constexpr std::uint32_t ticks_between_polls = 16;

// One leg and everything around it: teams, network, live page, record. run_match() calls the steps
// in the order in which they are declared.
class Session {
 public:
  Session(const MatchOptions& options, const match::Setup& setup, std::optional<double> factor)
      : options_(options),
        match_(setup),
        speed_(factor.value_or(0.0)),
        pacer_(clock_, setup.control_period, factor) {}

  Result<void> play_past(const record::MatchRecord& past, std::uint32_t until);
  Result<void> seat_teams();
  Result<void> open_live_page();
  Result<void> play();
  Result<void> write_record();
  void end_live_page() {
    if (live_) live_->close(match_);
  }
  void warn_of_unknown_parameters() const;
  void print_calls() const;
  void report() const;
  void show_backtraces() const;
  bool is_void() const { return match_.outcome().kind == match::OutcomeKind::void_; }

 private:
  Result<server::TeamSeat> take_seat(const server::TeamChoice& choice, Team team);
  void use_own_names();
  dds::JoinTerms patience(Team team);
  firasim::Terms firasim_terms(Team team);
  Result<void> start_program(Team team);
  Result<void> open_firasim();
  Result<void> open_network(const std::vector<server::TeamChoice>& choices);
  Result<plugins::ProcessTerms> process_terms() const;
  void keep_thoughts(std::uint32_t tick);
  Result<void> write_thoughts(Team team);
  void warn_of_dropped_thoughts(Team team) const;
  // True if logs and thoughts can stand beside the record.
  bool has_folder() const {
    return !options_.record_path.empty() && !system::is_written_in_place(options_.record_path);
  }
  std::string log_path(Team team) const {
    return options_.record_path + "." + std::string(to_string(team)) + ".log";
  }
  double longest_play() const;
  record::MatchRecord record() const;

  const MatchOptions& options_;
  system::Interrupt interrupt_;
  system::Disk disk_;
  pace::SteadyWallClock clock_;
  match::Leg match_;
  double speed_;  // factor of real time; 0: lockstep
  replay::StateTrace trace_;
  match::ByTeam<record::ThoughtsWriter> thoughts_;
  pace::Pacer pacer_;
  std::unique_ptr<dds::MatchServer> network_;  // null unless a team plays over it
  std::unique_ptr<firasim::Server> firasim_;   // likewise
  firasim::Addresses firasim_addresses_;
  int firasim_instance_ = 0;
  match::ByTeam<std::optional<server::TeamProgram>> programs_;  // those that this match has started
  std::unique_ptr<web::LiveServer> live_;                       // null unless the leg is watched
  std::shared_ptr<plugins::Doorbell> bell_ = std::make_shared<plugins::Doorbell>();
  std::shared_ptr<plugins::MemoryWitness> memory_ = std::make_shared<plugins::MemoryWitness>();
  std::vector<server::TeamSeat> seats_;  // blue, yellow
  std::string isolation_ = "network";
  std::optional<record::PlayedOnFrom> from_;
};

// Plays the ticks before `until` as they are recorded. So nothing is lost of what the leg
// remembers: counts of the laws, the disturbances, what the camera saw, commands on their way.
Result<void> Session::play_past(const record::MatchRecord& past, std::uint32_t until) {
  const replay::Recording& recording = past.recording;
  while (match_.tick() < until) {
    const std::uint32_t tick = match_.tick();
    match_.advance(replay::recorded_answers(recording, tick));
    trace_.add(match_);
    if (match_.log().back().hash == recording.ticks[tick].hash && !match_.is_over()) continue;
    if (record::has_other_behaviour(past)) {
      return tl::unexpected(record::behaviour_mismatch(options_.from_path, past, tick));
    }
    return fail(Errc::damaged, options_.from_path + ": played again, it differs from tick " +
                                   std::to_string(tick) + " on; see mirocup verify");
  }
  from_ = record::PlayedOnFrom{.tick = until,
                               .state_hash = recording.state_hash,
                               .teams = {past.teams[0].name, past.teams[1].name}};
  return {};
}

Result<void> Session::seat_teams() {
  std::vector<server::TeamChoice> choices;
  for (const Team team : both_teams) {
    MIROCUP_TRY(auto choice, server::choose_team(options_.teams[index_of(team)]));
    const std::string& name = options_.names[index_of(team)];
    if (!name.empty()) choice.info.name = name;
    choices.push_back(std::move(choice));
  }
  if (auto given = give_parameters(options_, choices); !given) return given;
  if (auto opened = open_network(choices); !opened) return opened;
  if (!network_ && !firasim_ && pacer_.period() == 0.0) server::stay_on_this_core();
  for (const Team team : both_teams) {
    MIROCUP_TRY(auto seat, take_seat(choices[index_of(team)], team));
    seats_.push_back(std::move(seat));
  }
  if (network_) {
    network_->announce(match_.briefing(Team::blue), {seats_[0].info().name, seats_[1].info().name},
                       speed_);
  }
  if (network_) network_->publish(match_);  // teams answer it before the match begins
  server::wait_until_ready(seats_, match_, interrupt_);
  use_own_names();
  return {};
}

// A library that is called team.so is told from another one by the name that it exports, unless
// both export the same, as two versions of a team do.
void Session::use_own_names() {
  const auto name_of = [this](Team team) {
    const server::TeamSeat& seat = seats_[index_of(team)];
    const bool is_asked =
        seat.info().kind == record::TeamKind::plugin && options_.names[index_of(team)].empty();
    const std::string own = is_asked ? seat.own_name() : std::string();
    return own.empty() ? seat.info().name : own;
  };
  const std::string blue = name_of(Team::blue);
  const std::string yellow = name_of(Team::yellow);
  if (blue == yellow) return;
  seats_[0].rename(blue);
  seats_[1].rename(yellow);
}

Result<void> Session::open_network(const std::vector<server::TeamChoice>& choices) {
  const auto any = [&](record::TeamKind kind) {
    return choices[0].info.kind == kind || choices[1].info.kind == kind;
  };
  if (any(record::TeamKind::dds)) {
    MIROCUP_TRY(network_, dds::MatchServer::open(options_.match_id, options_.interface,
                                                 options_.credentials, options_.dds_domain));
  }
  for (const Team team : both_teams) {
    const bool is_firasim = choices[index_of(team)].info.kind == record::TeamKind::firasim;
    if (options_.programs[index_of(team)].empty() || is_firasim) continue;
    return fail(Errc::input, "--" + std::string(to_string(team)) +
                                 "-program: the team is not firasim:NAME, so it needs no program");
  }
  return any(record::TeamKind::firasim) ? open_firasim() : Result<void>();
}

Result<void> Session::open_firasim() {
  const bool takes_a_free_one = options_.firasim_instance == "auto";
  const int first = takes_a_free_one ? first_free_instance : std::stoi(options_.firasim_instance);
  const int last = takes_a_free_one ? first + most_instances - 1 : first;
  std::optional<Error> why_not;
  for (int instance = first; instance <= last; ++instance) {
    MIROCUP_TRY(const auto addresses,
                firasim::addresses_of(instance, {.vision = options_.firasim_vision,
                                                 .referee = options_.firasim_referee,
                                                 .command = options_.firasim_command,
                                                 .placement = options_.firasim_placement,
                                                 .interface = options_.interface}));
    auto server = firasim::Server::open(addresses);
    if (server) {
      firasim_ = std::move(*server);
      firasim_addresses_ = addresses;
      firasim_instance_ = instance;
      return {};
    }
    if (!why_not) why_not = server.error();
    if (server.error().code != Errc::unavailable) break;  // other ports do not help
  }
  return tl::unexpected(*why_not);
}

Result<void> Session::start_program(Team team) {
  const std::string& command = options_.programs[index_of(team)];
  if (command.empty()) return {};
  const std::string log = has_folder() ? log_path(team) : "/dev/null";
  MIROCUP_TRY(auto program, server::TeamProgram::start(command, team, firasim_instance_,
                                                       firasim_addresses_, log));
  programs_[index_of(team)].emplace(std::move(program));
  return {};
}

Result<server::TeamSeat> Session::take_seat(const server::TeamChoice& choice, Team team) {
  const match::Briefing briefing = match_.briefing(team);
  if (choice.info.kind == record::TeamKind::dds) {
    return server::TeamSeat::take_on_network(choice, briefing, *network_, patience(team));
  }
  if (choice.info.kind == record::TeamKind::firasim) {
    MIROCUP_TRY_VOID(start_program(team));
    return server::TeamSeat::take_at_firasim(choice, match_, team, *firasim_, firasim_terms(team));
  }
  if (options_.trusted) {
    isolation_ = to_string(plugins::Isolation::none);
    return server::TeamSeat::take_trusted(choice, briefing, options_.thoughts);
  }
  MIROCUP_TRY(const auto terms, process_terms());
  isolation_ = to_string(terms.isolation);
  return server::TeamSeat::take_in_process(choice, briefing, terms);
}

Result<plugins::ProcessTerms> Session::process_terms() const {
  plugins::ProcessTerms terms;
  terms.bell = bell_;
  terms.memory = memory_;
  terms.keeps_thoughts = options_.thoughts;
  // Tests of teams that are never ready need not wait as long as a league does.
  if (const char* limit = std::getenv("MIROCUP_START_LIMIT")) {
    terms.budget.start_cpu = std::max(1, std::atoi(limit));
    terms.budget.start_wall = 3.0 * terms.budget.start_cpu;
  }
  MIROCUP_TRY(const auto strongest, plugins::strongest_isolation());
  const auto wanted = from_string<plugins::Isolation>(options_.isolation);
  terms.isolation = wanted.value_or(strongest);
  if (terms.isolation > strongest) {
    return fail(Errc::unavailable, "--isolation " + options_.isolation + ": this system allows " +
                                       std::string(to_string(strongest)) +
                                       " only (namespaces are not allowed here)");
  }
  if (pacer_.period() > 0.0) {
    terms.deadline.emplace();
    terms.deadline->tick = pacer_.period();
  }
  return terms;
}

dds::JoinTerms Session::patience(Team team) {
  dds::JoinTerms patience;
  patience.to_join = options_.join_within;
  patience.first_tick = match_.tick();
  patience.away = options_.away_limit.value_or(away_limit);
  patience.longest = options_.join_within + 2.0 * patience.away + longest_play();
  patience.interrupted = [this] { return interrupt_.is_asked_for(); };
  patience.tell = [](const std::string& text) {
    std::cerr << "mirocup: " << system::printable(text) << '\n';
  };
  if (pacer_.period() > 0.0) {
    patience.tick = answer_share * pacer_.period();
    patience.notice = std::max(min_notice, ticks_to_notice * pacer_.period());
  }
  if (options_.thoughts) {
    record::ThoughtsWriter& writer = thoughts_[index_of(team)];
    patience.thoughts = {.add = [&writer](auto tick, auto& shape) { writer.add(tick, shape); },
                         .leave_out = [&writer](auto n) { writer.count_left_out(n); }};
  }
  return patience;
}

firasim::Terms Session::firasim_terms(Team team) {
  firasim::Terms terms;
  terms.to_join = options_.join_within;
  const bool is_lockstep = pacer_.period() == 0.0 || options_.lockstep;
  terms.away = options_.away_limit.value_or(is_lockstep ? lockstep_away_limit : away_limit);
  terms.interrupted = [this] { return interrupt_.is_asked_for(); };
  terms.why_gone = [this, team](const std::string& when) -> std::optional<match::Answer> {
    auto& program = programs_[index_of(team)];
    return program ? program->why_gone(when) : std::nullopt;
  };
  terms.tell = [](const std::string& text) {
    std::cerr << "mirocup: " << system::printable(text) << '\n';
  };
  if (!is_lockstep) terms.tick = answer_share * pacer_.period();
  return terms;
}

// Wall seconds after which a leg is over, if its teams are there. In lockstep it is played faster.
double Session::longest_play() const {
  const match::Setup& setup = match_.setup();
  const referee::Rules& r = setup.rules;
  double play = 2.0 * r.half_s;
  if (setup.stage == referee::Stage::knockout) {
    play += std::max(r.golden_goal_s, 2.0 * r.extra_halves_s) +
            2.0 * r.shoot_out_most_rounds * r.attempt_s;
  }
  const double speed = pacer_.period() > 0.0 ? setup.control_period / pacer_.period() : 1.0;
  return share_for_restarts * play / speed;
}

Result<void> Session::open_live_page() {
  if (!options_.watch) return {};
  MIROCUP_TRY(const auto address,
              web::parse_address(options_.watch->empty() ? "0" : *options_.watch, "--watch"));
  const match::Setup& setup = match_.setup();
  MIROCUP_TRY(live_,
              web::LiveServer::open(address, match_, {seats_[0].info().name, seats_[1].info().name},
                                    std::string(to_string(setup.league)) + " league, rules " +
                                        std::string(to_string(setup.rules.preset)) + ", seed " +
                                        std::to_string(setup.seed)));
  std::cerr << "mirocup: watch at " << live_->url() << '\n';
  return {};
}

Result<void> Session::play() {
  while (!match_.is_over()) {
    const bool polls_now = pacer_.period() > 0.0 || match_.tick() % ticks_between_polls == 0;
    if (polls_now && interrupt_.is_asked_for())
      return fail(Errc::interrupted, "interrupted; nothing was decided");
    pacer_.wait_for(match_.tick());
    if (network_) network_->publish(match_);
    const std::uint32_t tick = match_.tick();
    if (firasim_) firasim_->publish(match_);
    match_.advance(seats_[0].controller(), seats_[1].controller());
    if (options_.thoughts) keep_thoughts(tick);
    trace_.add(match_);
    if (live_) live_->publish(match_);
  }
  if (network_) network_->close(match_);
  if (firasim_) firasim_->close(match_);
  for (auto& program : programs_) {
    if (program) program->let_end();
  }
  if (is_void() && interrupt_.is_asked_for()) {
    return fail(Errc::interrupted, "interrupted; nothing was decided");
  }
  return {};
}

// Keeps what the teams drew in their answers to a tick.
void Session::keep_thoughts(std::uint32_t tick) {
  for (const Team team : both_teams) {
    const plugins::ThoughtsPage* page = seats_[index_of(team)].thoughts();
    if (page == nullptr) continue;
    record::ThoughtsWriter& writer = thoughts_[index_of(team)];
    plugins::ThoughtReader reader(*page);
    while (const auto thought = reader.next()) writer.add(tick, *thought);
    writer.count_left_out(page->left_out);
  }
}

record::MatchRecord Session::record() const {
  record::MatchRecord record;
  record.software = record::this_software();
  record.isolation = isolation_;
  for (const Team team : both_teams) {
    const int i = index_of(team);
    record.teams[i] = seats_[i].info();
    record.budget[i] = seats_[i].budget_report();
    record.budget[i].late_ticks = match_.late_ticks()[i];
    record.budget[i].bad_commands = match_.bad_values()[i];
    record.network[i] = seats_[i].network_report();
  }
  if (pacer_.period() > 0.0) record.pace = {pacer_.period(), pacer_.lateness()};
  record.from = from_;
  record.recording = replay::record(match_, trace_);
  return record;
}

Result<void> Session::write_record() {
  if (options_.record_path.empty()) return {};
  if (auto saved = record::save(disk_, options_.record_path, record()); !saved) return saved;
  if (!has_folder()) return {};
  for (const Team team : both_teams) {
    if (auto written = write_thoughts(team); !written) return written;
    const std::string text = seats_[index_of(team)].output();
    if (text.empty()) continue;
    if (auto written = disk_.write(log_path(team), text); !written) return written;
  }
  return {};
}

void Session::warn_of_dropped_thoughts(Team team) const {
  const dds::ThoughtCounts* counts = seats_[index_of(team)].thoughts_sent();
  if (counts == nullptr || counts->late + counts->foreign + counts->malformed == 0) return;
  std::cerr << "mirocup: warning: samples of the " << to_string(team)
            << " team's thoughts were dropped: " << counts->late << " too late, " << counts->foreign
            << " of other processes, " << counts->malformed << " malformed\n";
}

// Without --thoughts, those of an earlier leg in the same place are removed: they are of no use.
Result<void> Session::write_thoughts(Team team) {
  const std::string path = record::thoughts_path(options_.record_path, team);
  if (!options_.thoughts) {
    std::error_code none;
    std::filesystem::remove(path, none);
    return {};
  }
  warn_of_dropped_thoughts(team);
  record::ThoughtsWriter& writer = thoughts_[index_of(team)];
  if (writer.left_out() > 0) {
    std::cerr << "mirocup: warning: " << writer.left_out() << " shapes of the " << to_string(team)
              << " team's thoughts were left out, see \"Thoughts\" in strategy.h\n";
  }
  return disk_.write(path, writer.packed(), system::Readers::owner);
}

// A name with a slip in it would otherwise have no effect, silently.
void Session::warn_of_unknown_parameters() const {
  if (match_.tick() == 0) return;  // a team that never played asked for nothing
  const auto blue = seats_[0].unknown_parameters();
  const auto yellow = seats_[1].unknown_parameters();
  const auto is_known_to = [](const server::TeamSeat& seat, const match::TeamParameters& unknown,
                              const std::string& name) {
    return seat.info().parameters.count(name) != 0 && unknown.count(name) == 0;
  };
  match::TeamParameters all = blue;
  all.insert(yellow.begin(), yellow.end());
  for (const auto& entry : all) {
    const std::string& name = entry.first;
    if (is_known_to(seats_[0], blue, name) || is_known_to(seats_[1], yellow, name)) continue;
    std::cerr << "mirocup: warning: no team asked for the parameter " << name << '\n';
  }
}

void Session::print_calls() const {
  const match::ByTeam<std::string> names{seats_[0].info().name, seats_[1].info().name};
  match::ByTeam<int> score{};
  for (const match::LoggedDecision& call : match_.decisions()) {
    if (call.decision.verdict == referee::Verdict::GOAL && call.team) {
      ++score[index_of(*call.team)];
    }
    char clock[32];
    const int seconds = static_cast<int>(call.decision.clock);
    std::snprintf(clock, sizeof clock, "%2d:%02d  ", seconds / 60, seconds % 60);
    std::cout << clock << system::printable(match::call_text(call, names, score)) << '\n';
  }
}

void Session::report() const {
  if (options_.json) {
    std::cout << record::json_text(record::to_json(record())) << '\n';
    return;
  }
  if (options_.calls) print_calls();
  const match::Outcome& r = match_.outcome();
  std::cout << system::printable(seats_[0].info().name) << " (blue) " << r.score[0] << " : "
            << r.score[1] << " " << system::printable(seats_[1].info().name) << " (yellow), "
            << to_string(r.kind) << " after " << match_.tick() << " ticks";
  if (options_.hash) std::cout << ", state hash " << to_hex(match_.state_hash());
  std::cout << '\n';
  for (const match::TeamFault& f : r.faults) {
    std::cout << to_string(f.team) << ": " << to_string(f.fault.code) << ": "
              << system::printable(f.fault.text) << '\n';
  }
  if (!r.why_void.empty()) std::cout << "void: " << system::printable(r.why_void) << '\n';
}

void Session::show_backtraces() const {
  for (const Team team : both_teams) {
    const plugins::ProcessController* process = seats_[index_of(team)].process();
    if (process == nullptr || process->backtrace().empty()) continue;
    std::cerr << "mirocup: the " << to_string(team) << " team crashed in\n" << process->backtrace();
  }
}

// A leg that cannot be written should not be played first.
Result<void> check_output(const MatchOptions& options) {
  if (options.record_path.empty()) return {};
  if (std::error_code none; std::filesystem::is_directory(options.record_path, none)) {
    return fail(Errc::unavailable, options.record_path + " cannot be written: it is a folder");
  }
  return expect_writable_folder_of(options.record_path);
}

Result<int> run_match(const MatchOptions& options) {
  MIROCUP_TRY(const auto past, read_past(options));
  MIROCUP_TRY(const auto setup,
              past ? Result<match::Setup>(past->recording.setup) : setup_of(options));
  MIROCUP_TRY(const auto factor, factor_of(options));
  MIROCUP_TRY_VOID(check_output(options));

  Session session(options, setup, factor);
  if (past) {
    MIROCUP_TRY_VOID(session.play_past(*past, *options.tick));
  }
  MIROCUP_TRY_VOID(session.seat_teams());
  MIROCUP_TRY_VOID(session.open_live_page());
  MIROCUP_TRY_VOID(session.play());
  if (auto written = session.write_record(); !written) {
    session.report();  // the score is known, if nothing else
    return tl::unexpected(written.error());
  }
  session.end_live_page();
  session.warn_of_unknown_parameters();
  session.report();
  session.show_backtraces();
  return session.is_void() ? exit_code(Errc::host) : exit_yes;
}

void add_firasim(const system::Command& command, MatchOptions& o) {
  const char* group = "Teams that speak the protocol of FIRASim and VSSReferee";
  const auto add = [&](const char* option, std::string& value, const char* type,
                       const char* description) {
    command.option(option, value, description).named(type).in_group(group);
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
      .option("--firasim-instance", o.firasim_instance,
              "Number of this match on this host; above 0 each has ports of its own: 10002+K, "
              "20011+K, 40000+K, 50000+K; auto: the first from 1000 on that is free")
      .between_or(0, 9999, "auto")
      .named("K|auto")
      .in_group(group);
  add("--blue-program", o.programs[0], "COMMAND",
      "Start the blue team by this command of the shell, which finds its colour and addresses in "
      "MIROCUP_COLOUR, MIROCUP_INSTANCE and others (docs/firasim.md)");
  add("--yellow-program", o.programs[1], "COMMAND", "Start the yellow team in the same way");
  command
      .flag("--lockstep", o.lockstep,
            "Wait in each tick until these teams have commanded all their robots (--speed max "
            "does, too)")
      .in_group(group);
}

}  // namespace

void add_match(system::Commands& commands) {
  const auto [command, o] = commands.add<MatchOptions>(
      {"match",
       for_teams,
       "Play one leg",
       {"mirocup match --blue mine.so --yellow striker --seed 7 --record leg.json",
        "mirocup match --blue mine.py --yellow chaser --watch",
        "mirocup match --blue mine.so --yellow mine.so --blue-param wait=0.5"}},
      run_match);
  command
      .option("--blue", o.teams[0],
              "Blue team: a library (.so), a file of Python (.py), the name of a house team, "
              "dds:NAME, or firasim:NAME for a program that speaks FIRASim's protocol")
      .named("TEAM")
      .required();
  command.option("--yellow", o.teams[1], "Yellow team, named in the same way")
      .named("TEAM")
      .required();
  command.option("--blue-name", o.names[0], "Name of the blue team in the record").named("NAME");
  command.option("--yellow-name", o.names[1], "Name of the yellow team in the record")
      .named("NAME");
  const system::Option start =
      command
          .option("--start", o.start_path,
                  "Start in this situation, a file of schema mirocup/situation/1")
          .named("SITUATION.json");
  const system::Option from =
      command
          .option("--from", o.from_path,
                  "Play on from a tick of this record, with its league, rules, stage, seed "
                  "and conditions")
          .named("RECORD")
          .excludes(start);
  const system::Option tick =
      command.option("--tick", o.tick, "Tick of the record from which to play on")
          .at_least_0()
          .needs(from);
  from.needs(tick);
  command
      .option("--league", o.league,
              "Field and number of robots: small (3 a side), middle (5), large (11); default: "
              "small, or that of the situation")
      .one_of(system::names_of<League>())
      .excludes(from);
  command.option("--rules", o.rules, "Preset of the rules")
      .one_of(system::names_of<referee::Preset>())
      .shows_default()
      .excludes(from);
  command.option("--stage", o.stage, "group: a draw stands; knockout: a winner is found")
      .one_of(system::names_of<referee::Stage>())
      .shows_default()
      .excludes(from);
  command.option("--seed", o.seed, "Seed of the toss and of the teams' random numbers")
      .is_a_seed()
      .shows_default()
      .excludes(from);
  command
      .option("--speed", o.speed,
              "max, or a factor of real time (default: 1 with --watch, otherwise max)")
      .named("FACTOR");
  command
      .option_or_flag(
          "--watch", o.watch,
          "Show the match in browsers at [HOST:]PORT; without a host at this host only, without a "
          "port "
          "at any free one")
      .named("[PORT]");
  command.flag("--calls", o.calls, "Print each goal and call of the referee, too");
  command.option("--half", o.half_s, "Length of a half in seconds")
      .between(record::min_half_s, record::max_half_s)
      .excludes(from);
  command
      .option("--rule", o.rule_changes,
              "Change a parameter of the rules; may be given several times")
      .named("KEY=VALUE")
      .excludes(from);
  command
      .option("--conditions", o.conditions,
              "What disturbs the leg: nothing (exact), placing by hand, wheels and floor "
              "(hall), also a camera and a radio (camera); default: those of the pitch, if it "
              "has any, or " +
                  std::string(to_string(match::default_preset)))
      .one_of(system::names_of<match::ConditionsPreset>())
      .excludes(from);
  command
      .option("--pitch", o.pitch,
              "Robots, ball and floor: mirosot (default), vsss, simurosot, or a file "
              "(mirocup/pitch/1), for example of mirocup identify")
      .named("NAME|FILE")
      .excludes(from);
  command
      .option("--condition", o.condition_changes,
              "Change a value of the conditions; may be given several times")
      .named("KEY=VALUE")
      .excludes(from);
  add_parameters(command, "--param", o.parameters, "both teams");
  add_parameters(command, "--blue-param", o.own_parameters[0], "the blue team");
  add_parameters(command, "--yellow-param", o.own_parameters[1], "the yellow team");
  const system::Option record =
      command.option("--record", o.record_path, "File to write the match record to").named("FILE");
  command
      .flag("--thoughts", o.thoughts,
            "Keep what the teams draw, beside the record, for mirocup replay")
      .needs(record);
  const system::Option trusted = command.flag(
      "--trusted", o.trusted, "Run the teams in this process, without protection from them");
  command
      .option("--isolation", o.isolation,
              "Tier of the sandbox: T2 (namespaces) or T1 (filtered system calls); the match "
              "is not played "
              "if this system does not allow it (default: the strongest that it allows)")
      .one_of({"T1", "T2"})
      .excludes(trusted);
  command.option("--match", o.match_id, "ID of the match, by which DDS teams join it")
      .shows_default();
  command
      .option("--interface", o.interface,
              "Network interface for teams on the network; lo: this host only")
      .shows_default();
  add_dds_domain(command, o.dds_domain);
  command.option("--join-within", o.join_within, "Seconds that a DDS team has to join the match")
      .shows_default();
  command.option(
      "--away-limit", o.away_limit,
      "Seconds that a DDS team may be absent from the match in total, and that a firasim "
      "team may say nothing; 10 without it, and 30 with --lockstep");
  command
      .option("--credentials", o.credentials,
              "Folder with the server's credentials; then only teams of the league can join")
      .named("DIR");
  command.flag("--hash", o.hash, "Print the state hash of the leg, too");
  add_firasim(command, o);
  command.flag("--json", o.json, "Print the record as one JSON object");
}

}  // namespace mirocup::app
