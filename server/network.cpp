// SPDX-License-Identifier: MIT
#include "server/network.hpp"

#include "system/child_process.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <iostream>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace mirocup::server {

namespace {

// The share of a tick in which a team on the network must answer in real time. The rest is for the
// simulation, so that a late team does not delay the next tick.
constexpr double answer_share = 0.9;

// A team that has not answered for this many ticks, and for at least this time, is absent.
constexpr double ticks_to_notice = 9.0;
constexpr double min_notice = 0.1;  // s

// How long a team on the network may be absent, s. A firasim team in lock-step has longer, because
// the machine may be slow and no viewer waits.
constexpr double away_limit = 10.0;
constexpr double lockstep_away_limit = 30.0;

// The clock of a half stands at restarts. They take far less than half as much time again.
constexpr double share_for_restarts = 1.5;

// The numbers of matches on this host that find ports of their own (firasim_instance "auto").
constexpr int first_free_instance = 1000;
constexpr int most_instances = 1000;

// The most bytes that a program may print for a leg, and write into each file.
constexpr std::uint64_t max_program_output = std::uint64_t{1} << 30;

// How long a match that waits for something else may wait for a packet, s: not at all, but above 0,
// as MatchServer::listen() needs it to send the state again.
constexpr double no_longer = 1e-9;

void tell(const std::string& text) {
  std::cerr << "mirocup: " << system::printable(text) << '\n';
}

// Wall seconds after which a leg is over, if its teams are there. In lockstep it is played faster.
double longest_play(const match::Setup& setup, double period) {
  const referee::Rules& r = setup.rules;
  double play = 2.0 * r.half_s;
  if (setup.stage == referee::Stage::knockout) {
    play += std::max(r.golden_goal_s, 2.0 * r.extra_halves_s) +
            2.0 * r.shoot_out_most_rounds * r.attempt_s;
  }
  const double speed = period > 0.0 ? setup.control_period / period : 1.0;
  return share_for_restarts * play / speed;
}

// How long a program may take to end by itself, s, and how often it is looked after.
constexpr double exit_patience = 0.2;
constexpr double interval = 0.01;

// Exit code of a shell where the file is no program; where there is none, it is system::not_found.
constexpr int not_executable = 126;

}  // namespace

Result<void> Network::open(const match::ByTeam<TeamChoice>& teams) {
  const auto any = [&](record::TeamKind kind) {
    return teams[0].info.kind == kind || teams[1].info.kind == kind;
  };
  has_two_firasim_ = teams[0].info.kind == record::TeamKind::firasim &&
                     teams[1].info.kind == record::TeamKind::firasim;
  if (any(record::TeamKind::dds)) {
    if (terms_.nat && terms_.credentials.empty() && !terms_.is_open) {
      return fail(Errc::input,
                  "--nat: without --credentials anybody on the internet could join, read and forge "
                  "this match: make credentials by mirocup league credentials, or say --open");
    }
    MIROCUP_TRY(dds_, dds::MatchServer::open(
                          terms_.match_id, terms_.interface, terms_.credentials, terms_.dds_domain,
                          terms_.nat ? dds::Reply::to_source : dds::Reply::to_listed));
    if (terms_.interface == "lo") {
      tell("match " + terms_.match_id +
           " can be joined from this computer only; --interface opens it to others");
    }
  }
  for (const Team team : both_teams) {
    const bool is_firasim = teams[index_of(team)].info.kind == record::TeamKind::firasim;
    if (terms_.programs[index_of(team)].empty() || is_firasim) continue;
    return fail(Errc::input, "--" + std::string(to_string(team)) +
                                 "-program: the team is not firasim:NAME, so it needs no program");
  }
  return any(record::TeamKind::firasim) ? open_firasim() : Result<void>();
}

Result<void> Network::open_firasim() {
  const bool takes_a_free_one = terms_.firasim_instance == "auto";
  const int first = takes_a_free_one ? first_free_instance : std::stoi(terms_.firasim_instance);
  const int last = takes_a_free_one ? first + most_instances - 1 : first;
  firasim::Addresses changes = terms_.firasim;
  changes.interface = terms_.interface;
  std::optional<Error> why_not;
  for (int instance = first; instance <= last; ++instance) {
    MIROCUP_TRY(const auto addresses, firasim::addresses_of(instance, changes));
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

Result<TeamSeat> Network::take_seat(const TeamChoice& choice, Team team, const SeatTerms& terms) {
  if (choice.info.kind == record::TeamKind::dds) {
    return TeamSeat::take_on_network(choice, terms.leg.briefing(team), *dds_, dds_terms(terms));
  }
  const std::string& command = terms_.programs[index_of(team)];
  if (!command.empty()) {
    MIROCUP_TRY(auto program, TeamProgram::start(command, team, firasim_instance_,
                                                 firasim_addresses_, terms.log));
    programs_[index_of(team)].emplace(std::move(program));
  }
  return TeamSeat::take_at_firasim(choice, terms.leg, team, *firasim_, firasim_terms(team, terms));
}

dds::JoinTerms Network::dds_terms(const SeatTerms& terms) const {
  dds::JoinTerms join;
  join.to_join = terms_.join_within;
  join.first_tick = terms.leg.tick();
  join.away = terms_.away_limit.value_or(away_limit);
  join.longest =
      terms_.join_within + 2.0 * join.away + longest_play(terms.leg.setup(), terms.period);
  join.interrupted = [&interrupt = terms.interrupt] { return interrupt.is_asked_for(); };
  join.tell = tell;
  if (terms.period > 0.0) {
    join.tick = answer_share * terms.period;
    join.notice = std::max(min_notice, ticks_to_notice * terms.period);
  }
  return join;
}

firasim::Terms Network::firasim_terms(Team team, const SeatTerms& terms) {
  firasim::Terms join;
  join.to_join = terms_.join_within;
  const bool is_lockstep = terms.period == 0.0 || terms_.lockstep;
  join.away = terms_.away_limit.value_or(is_lockstep ? lockstep_away_limit : away_limit);
  join.interrupted = [this, &interrupt = terms.interrupt] {
    stand_by();  // the other team may play over DDS
    return interrupt.is_asked_for();
  };
  join.why_gone = [this, team](const std::string& when) -> std::optional<match::Answer> {
    auto& program = programs_[index_of(team)];
    return program ? program->why_gone(when) : std::nullopt;
  };
  join.tell = tell;
  if (!is_lockstep) join.tick = answer_share * terms.period;
  join.longest =
      2.0 * join.away + longest_play(terms.leg.setup(), terms.leg.setup().control_period);
  // Nobody else is to be expected where the match has started the program, or uses free ports.
  join.has_any_port = !has_two_firasim_ && (!terms_.programs[index_of(team)].empty() ||
                                            terms_.firasim_instance == "auto");
  return join;
}

void Network::announce(const match::Leg& leg, const match::ByTeam<std::string>& names,
                       double speed) {
  if (!dds_) return;
  dds_->announce(leg.briefing(Team::blue), names, speed);
  dds_->publish(leg);
}

void Network::publish(const match::Leg& leg) {
  if (dds_) dds_->publish(leg);
  if (firasim_) firasim_->publish(leg);
}

void Network::stand_by() {
  if (dds_) dds_->listen(no_longer);
}

void Network::close(const match::Leg& leg) {
  if (dds_) dds_->close(leg);
  if (firasim_) firasim_->close(leg);
  for (auto& program : programs_) {
    if (program) program->let_end();
  }
}

Result<TeamProgram> TeamProgram::start(const std::string& command, Team team, int instance,
                                       const firasim::Addresses& addresses,
                                       const std::string& log) {
  const std::string host = addresses.command.find(':') == std::string::npos ? "127.0.0.1:" : "";
  MIROCUP_TRY(
      const auto pid,
      system::start_child(
          {.arguments = {"/usr/bin/env", "MIROCUP_COLOUR=" + std::string(to_string(team)),
                         std::string("MIROCUP_YELLOW=") + (team == Team::yellow ? "true" : "false"),
                         "MIROCUP_INSTANCE=" + std::to_string(instance),
                         "MIROCUP_VISION=" + addresses.vision,
                         "MIROCUP_COMMAND=" + host + addresses.command,
                         "MIROCUP_REFEREE=" + addresses.referee,
                         "MIROCUP_PLACEMENT=" + addresses.placement, "/bin/sh", "-c", command},
           .log = log,
           .max_bytes = max_program_output}));
  return TeamProgram(pid, command, log);
}

TeamProgram::TeamProgram(TeamProgram&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)),
      status_(other.status_),
      command_(std::move(other.command_)),
      log_(std::move(other.log_)) {}

TeamProgram::~TeamProgram() {
  if (pid_ != 0) system::end_group(pid_);
}

bool TeamProgram::has_ended() {
  if (pid_ == 0) return true;
  if (!system::has_ended(pid_)) return false;
  status_ = system::end_group(pid_);
  pid_ = 0;
  return true;
}

std::optional<match::Answer> TeamProgram::why_gone(const std::string& when) {
  if (!has_ended()) return std::nullopt;
  const std::string said = log_ == "/dev/null" ? "" : "; what it printed is in " + log_;
  const std::string what = "the team's program, " + command_ + ", ";
  if (WIFSIGNALED(status_)) {
    return match::Fault{
        match::FaultCode::crash,
        what + "was ended by signal " + std::to_string(WTERMSIG(status_)) + " " + when + said};
  }
  const int code = WEXITSTATUS(status_);
  if (code == system::not_found || code == not_executable) {
    return match::HostFailure{what + "cannot be started" + said};
  }
  return match::Fault{match::FaultCode::crash,
                      what + "ended with code " + std::to_string(code) + " " + when + said};
}

void TeamProgram::let_end() {
  for (double waited = 0.0; waited < exit_patience && !has_ended(); waited += interval)
    usleep(static_cast<useconds_t>(1e6 * interval));
}

}  // namespace mirocup::server
