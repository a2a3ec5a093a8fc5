// SPDX-License-Identifier: MIT
#include "programs/check/entry_advice.hpp"

#include "system/text.hpp"

#include <cstring>

namespace mirocup::app {

namespace {

using plugins::AddressKind;
using plugins::LastWords;

constexpr std::string_view in_a_debugger =
    "build it with -g and run gdb --args mirocup match --trusted --blue FILE.so --yellow striker";

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

// The keys of the kinds of addresses, in their order.
constexpr const char* key_of_address[] = {"crash bad_pointer", "null_pointer", "full_stack",
                                          "crash bad_pointer", "observation",  "lost_stack"};
static_assert(std::size(key_of_address) == static_cast<std::size_t>(AddressKind::lost) + 1);

std::string advice_on_crash(const FaultEvidence& evidence) {
  const LastWords words = evidence.words.value_or(LastWords());
  const std::string& cause = evidence.fault.cause;
  const bool threw = cause.starts_with("exception");
  const bool is_null = words.address == AddressKind::null;
  if (words.team_call == plugins::TeamCall::none && words.signal == 0) return sentence("global");
  if (has(evidence.requests, "thread\n") && threw) return sentence("thread");
  if (cause == "exception std::bad_alloc") return sentence("crash " + cause);
  if (cause == "exception std::logic_error" && has(evidence.requests, "variable "))
    return sentence("variable");
  if (has(evidence.requests, "file ") && (is_null || threw)) return sentence("file");
  if (has(evidence.requests, "program ") && is_null) return sentence("program");
  if (has(evidence.requests, "connection") && threw) return sentence("connection");
  if (threw) {
    const std::string known = sentence("thrown " + cause);
    return (known.empty() ? sentence("thrown") : known) +
           "; gdb stops at the throw with catch throw: " + std::string(in_a_debugger);
  }
  if (cause == "command" || cause == "memory" || words.signal == 0) return "";
  const char* const signal = sigabbrev_np(words.signal);  // null for a signal without a name
  const std::string of_signal =
      sentence(std::string("signal ") + (signal != nullptr ? signal : ""));
  return of_signal.empty() ? sentence(key_of_address[static_cast<std::size_t>(words.address)])
                           : of_signal;
}

}  // namespace

std::string sentence(const std::string& key, const std::string& first, const std::string& second) {
  const std::string_view table = advice_file("advice.txt");
  const std::string begin = '\n' + key + ": ";
  const std::size_t at = table.find(begin);
  if (at == std::string_view::npos) return "";
  std::string text(table.substr(at + begin.size()));
  text.resize(text.find('\n'));
  text = system::replaced(std::move(text), "{debug}", in_a_debugger);
  return system::replaced(system::replaced(std::move(text), "{1}", first), "{2}", second);
}

std::string advice_on(const FaultEvidence& evidence) {
  using match::FaultCode;
  const FaultCode code = evidence.fault.code;
  const std::string of_code(to_string(code));
  const std::string of_cause = of_code + ' ' + evidence.fault.cause;
  const bool is_error = code == FaultCode::crash || code == FaultCode::no_load;
  std::string found;
  if (evidence.is_python && is_error) found = sentence("python " + evidence.fault.cause);
  if (evidence.is_python && found.empty()) found = sentence("python " + of_cause);
  if (evidence.is_python && found.empty()) found = sentence("python " + of_code);
  if (found.empty() && code == FaultCode::crash) found = advice_on_crash(evidence);
  if (found.empty()) found = sentence(of_cause);
  if (found.empty()) found = sentence(of_code);
  return found.empty() ? "see strategy.h" : found;
}

}  // namespace mirocup::app
