// SPDX-License-Identifier: MIT
//
// The seam between the match and whoever steers a team: a plugin in its own process, a program
// across the network, a recording.
#pragma once

#include "core/match/command.hpp"
#include "core/match/observation.hpp"

#include <array>
#include <string>
#include <string_view>
#include <variant>

namespace mirocup::match {

// How a team can lose the leg by itself.
enum class FaultCode {
  no_load,
  bad_abi,
  start_timeout,
  crash,
  hang,
  budget,
  illegal_call,
  bad_command,
  disconnected,
};

struct Fault {
  FaultCode code = FaultCode::crash;
  std::string text;  // a sentence for the team
};

// The machine failed, not the team: the leg is void.
struct HostFailure {
  std::string text;
};

// No answer in time (only where time counts): the last command goes on for a while.
struct Late {};

using Answer = std::variant<Command, Late, Fault, HostFailure>;

class Controller {
 public:
  virtual ~Controller() = default;

  // Hands over an observation. Does not wait.
  virtual void post(const Observation& observation) = 0;

  // The answer to the last posted observation; waits for it as long as the controller's own limits
  // say.
  virtual Answer collect() = 0;
};

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 9> enum_names<match::FaultCode>{
    "no_load", "bad_abi",      "start_timeout", "crash",       "hang",
    "budget",  "illegal_call", "bad_command",   "disconnected"};

}  // namespace mirocup
