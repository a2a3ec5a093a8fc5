// SPDX-License-Identifier: MIT
#include "server/team_program.hpp"

#include "system/child_process.hpp"

#include <cerrno>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace mirocup::server {

namespace {

// How long a program may take to end by itself, s, and how often it is looked after.
constexpr double exit_patience = 0.2;
constexpr double interval = 0.01;

// Exit code of a shell where the file is no program; where there is none, it is system::not_found.
constexpr int not_executable = 126;

}  // namespace

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
           .log = log}));
  return TeamProgram(pid, command, log);
}

TeamProgram::TeamProgram(TeamProgram&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)),
      status_(other.status_),
      command_(std::move(other.command_)),
      log_(std::move(other.log_)) {}

TeamProgram::~TeamProgram() {
  if (pid_ == 0) return;
  kill(-pid_, SIGKILL);  // it leads a process group
  kill(pid_, SIGKILL);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool TeamProgram::has_ended() {
  if (pid_ == 0) return true;
  if (waitpid(pid_, &status_, WNOHANG) != pid_) return false;
  kill(-pid_, SIGKILL);  // what it has started
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
