// SPDX-License-Identifier: MIT
//
// The network side of a match: the topics for teams that play over DDS, the sockets for teams that
// speak the protocol of FIRASim, and the programs that the match starts for such teams.
#pragma once

#include "core/field/team.hpp"
#include "core/match/controller.hpp"
#include "server/dds/match_server.hpp"
#include "server/firasim/server.hpp"
#include "server/seats.hpp"
#include "system/interrupt.hpp"

#include <memory>
#include <optional>
#include <string>
#include <sys/types.h>

namespace mirocup::server {

// The program of a team that speaks FIRASim's protocol, if the match starts the program: a shell
// command of the host, which gets the team's colour and addresses in environment variables. The
// program has all rights of this process.

class TeamProgram {
 public:
  // `instance` is the argument of firasim::addresses_of() that gave `addresses`. The program's
  // output goes to the file `log`. Errc::unavailable if no process can be started.
  static Result<TeamProgram> start(const std::string& command, Team team, int instance,
                                   const firasim::Addresses& addresses, const std::string& log);
  TeamProgram(TeamProgram&& other) noexcept;
  TeamProgram& operator=(TeamProgram&&) = delete;
  ~TeamProgram();  // kills the program and all processes that it has started

  // If the program has ended, returns why the team can no longer send: a fault of the team, or of
  // the host if the command does not exist. `when` is the end of that sentence: "before it sent
  // anything".
  std::optional<match::Answer> why_gone(const std::string& when);

  // Gives the program a moment to end by itself, after the referee's HALT.
  void let_end();

 private:
  TeamProgram(pid_t pid, std::string command, std::string log)
      : pid_(pid), command_(std::move(command)), log_(std::move(log)) {}
  bool has_ended();

  pid_t pid_ = 0;  // 0: the end of the process has been collected
  int status_ = 0;
  std::string command_, log_;
};

struct NetworkTerms {
  std::string match_id = "1";  // ID by which DDS teams join
  std::string interface = "lo";
  int dds_domain = 0;
  bool nat = false;           // DDS teams may be behind routers that translate addresses
  bool is_open = false;       // with `nat`: anybody may join
  std::string credentials;    // folder; "": anybody may join
  double join_within = 60.0;  // time that a team has to join, s
  // Allowed absence of a team, s; empty: the default of the team's protocol.
  std::optional<double> away_limit;
  // Each address that is not "" replaces that address of `firasim_instance`.
  firasim::Addresses firasim{"", "", "", "", ""};
  std::string firasim_instance = "0";  // a number, or "auto"
  // Shell commands that start FIRASim teams; "": a person starts the team.
  match::ByTeam<std::string> programs;
  // True: the match waits for FIRASim teams, also in real time.
  bool lockstep = false;
};

// The part of the match that a seat uses. All members must outlive the seat.
struct SeatTerms {
  const match::Leg& leg;
  double period;  // wall time of a tick, s; 0: as fast as possible
  system::Interrupt& interrupt;
  std::string log;  // file for the output of the team's program
};

class Network {
 public:
  explicit Network(const NetworkTerms& terms) : terms_(terms) {}
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  // Opens the DDS topics and FIRASim sockets that these teams need; opens nothing if both teams are
  // libraries. Errc::input if a program is given for a team that needs no program;
  // Errc::unavailable if a port or an interface is not available.
  Result<void> open(const match::ByTeam<TeamChoice>& teams);
  bool is_open() const { return dds_ != nullptr || firasim_ != nullptr; }

  // Makes the seat of a team on DDS or FIRASim, and starts the team's program if the terms give a
  // command.
  Result<TeamSeat> take_seat(const TeamChoice& choice, Team team, const SeatTerms& terms);

  // Announces the match to DDS teams and spectators, and publishes its first state. Teams answer
  // that state before the match begins. `speed`: factor of real time; 0: as fast as possible.
  void announce(const match::Leg& leg, const match::ByTeam<std::string>& names, double speed);
  // Publishes the tick that begins, and never waits.
  void publish(const match::Leg& leg);
  // To be called while the match waits for something else: receives what has come, and sends the
  // state again, because a team that gets none takes the connection for broken.
  void stand_by();
  // Publishes the end of the match, and gives the programs a moment to end by themselves.
  void close(const match::Leg& leg);

 private:
  Result<void> open_firasim();
  dds::JoinTerms dds_terms(const SeatTerms& terms) const;
  firasim::Terms firasim_terms(Team team, const SeatTerms& terms);

  NetworkTerms terms_;
  std::unique_ptr<dds::MatchServer> dds_;     // null unless a team plays over DDS
  std::unique_ptr<firasim::Server> firasim_;  // null unless a team uses FIRASim
  firasim::Addresses firasim_addresses_;
  int firasim_instance_ = 0;
  bool has_two_firasim_ = false;                        // true: both teams use FIRASim
  match::ByTeam<std::optional<TeamProgram>> programs_;  // the programs that this match has started
};

}  // namespace mirocup::server
