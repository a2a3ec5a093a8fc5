// SPDX-License-Identifier: MIT
//
// The program of a team that speaks FIRASim's protocol, if the match starts the program: a shell
// command of the host, which gets the team's colour and addresses in environment variables. The
// program has all rights of this process.
#pragma once

#include "core/field/team.hpp"
#include "core/match/controller.hpp"
#include "server/firasim/server.hpp"

#include <optional>
#include <string>
#include <sys/types.h>

namespace mirocup::server {

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

}  // namespace mirocup::server
