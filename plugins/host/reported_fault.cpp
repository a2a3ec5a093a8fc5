// SPDX-License-Identifier: MIT
#include "plugins/host/reported_fault.hpp"

#include "plugins/host/sandbox/filter.hpp"
#include "system/printable.hpp"

#include <array>
#include <csignal>
#include <optional>

namespace mirocup::plugins {

namespace {

using match::Fault;
using match::FaultCode;

constexpr const char* illegal_call = "the team made a system call that is not allowed";

std::optional<Fault> claimed_fault(const ExitStatus& status, const LastWords& words,
                                   bool has_played) {
  if (status.signal == SIGSYS) return Fault{FaultCode::illegal_call, illegal_call};
  if (status.signal != 0) return std::nullopt;
  if (status.exit_code == exit_faulted) {
    if (words.signal == SIGSYS) {
      return Fault{FaultCode::illegal_call, illegal_call + (": " + system_call_name(words.call))};
    }
    if (words.signal > 0 && words.signal < NSIG)
      return Fault{FaultCode::crash, "the team's process died of " + signal_text(words.signal)};
  }
  if (status.exit_code == exit_refused) {
    Fault fault{FaultCode::crash, "the team's process says " + system::in_quotes(words.text),
                system::printable(words.cause), words.line};
    if (words.load_state == LoadState::crash) return fault;
    if (has_played) return std::nullopt;
    if (words.load_state == LoadState::no_load) fault.code = FaultCode::no_load;
    if (words.load_state == LoadState::bad_abi) fault.code = FaultCode::bad_abi;
    if (fault.code != FaultCode::crash) return fault;
  }
  return std::nullopt;
}

// The process may write any number, which has no text.
template <class E, std::size_t n>
const char* text_in(const std::array<const char*, n>& texts, E value) {
  const auto number = static_cast<std::size_t>(value);
  return number < n ? texts[number] : "";
}

const char* text_of(TeamCall call) {
  return text_in(std::array{"", "create()", "decide()", "place()"}, call);
}

const char* text_of(AddressKind address) {
  constexpr std::array texts{"",
                             " at a null pointer",
                             " at the end of its stack",
                             " at an address that is not valid",
                             " where it wrote to the observation",
                             " as it returned from a function to an address that is not valid"};
  return text_in(texts, address);
}

}  // namespace

std::string text_of(TeamCall called, const AskedMoment& moment) {
  const std::string call = text_of(called);
  return (call.empty() ? ", in tick " : ", in " + call + " of tick ") +
         std::to_string(moment.tick) + " (" + std::string(to_string(moment.state)) + ")";
}

Fault fault_of(const ExitStatus& status, const LastWords& words, bool has_played,
               const std::optional<AskedMoment>& moment) {
  Fault fault =
      claimed_fault(status, words, has_played)
          .value_or(status.signal != 0
                        ? Fault{FaultCode::crash,
                                "the team's process died of " + signal_text(status.signal),
                                status.signal == SIGSEGV ? "bad_pointer" : ""}
                        : Fault{FaultCode::crash,
                                "the team's process ended itself with exit code " +
                                    std::to_string(status.exit_code),
                                "exited"});
  if (status.exit_code == exit_faulted && status.signal == 0) fault.text += text_of(words.address);
  if (has_played && moment) fault.text += text_of(words.team_call, *moment);
  if (!has_played && fault.code != FaultCode::no_load && fault.code != FaultCode::bad_abi)
    fault.text += ", while its library was loaded";
  return fault;
}

}  // namespace mirocup::plugins
