// SPDX-License-Identifier: MIT
//
// The interface between a leg and the source of a team's commands: a plugin in its own process, a
// program on the network, or a recording.
#pragma once

#include "core/match/command.hpp"
#include "core/match/observation.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace mirocup::match {

// The faults by which a team loses the leg.
enum class FaultCode {
  no_load,
  bad_abi,
  start_timeout,
  crash,
  hang,
  budget,
  illegal_call,
  bad_command,  // reserved: no controller reports it, bad values are clamped and counted
  disconnected,
};

struct Fault {
  FaultCode code = FaultCode::crash;
  std::string text;  // a sentence for the team
  // A word for programs, which read nothing in the sentence: "slept", "exited", the name of a type
  // of Python's exceptions, or "exception " and the type of one of C++. "": not known.
  std::string cause = {};
  int line = 0;  // of a team's file in Python; 0: not known
};

// A failure of the machine, not of the team: the leg is void.
struct HostFailure {
  std::string text;
};

// The answer did not come in time, which happens only where real time counts. The leg drives
// `older`. If `older` is empty, the leg repeats the last command for a few ticks, then stops the
// robots.
struct Late {
  // A command that answers an earlier tick and came after the last command was driven. Its
  // placement has no effect, because it was meant for another tick.
  std::optional<Command> older = std::nullopt;
};

using Answer = std::variant<Command, Late, Fault, HostFailure>;

// Steers one team. A leg calls post() and collect() in turn, once a tick, from one thread; both
// teams are asked before either answer is collected.
class Controller {
 public:
  virtual ~Controller() = default;

  // Hands an observation to the team, without waiting.
  virtual void post(const Observation& observation) = 0;

  // Returns the answer to the observation posted last. Waits for it, as long as the controller's
  // own limits allow.
  virtual Answer collect() = 0;
};

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 9> enum_names<match::FaultCode>{
    "no_load", "bad_abi",      "start_timeout", "crash",       "hang",
    "budget",  "illegal_call", "bad_command",   "disconnected"};

}  // namespace mirocup
