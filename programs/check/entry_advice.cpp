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

// The keys of the kinds of addresses, in their order.
constexpr const char* key_of_address[] = {"crash bad_pointer", "null_pointer", "full_stack",
                                          "crash bad_pointer", "observation",  "lost_stack"};
static_assert(std::size(key_of_address) == static_cast<std::size_t>(AddressKind::lost) + 1);

// Returns the key of the remedy for a crash, "" if its cause has one of its own.
std::string key_of_crash(const FaultEvidence& evidence) {
  const LastWords words = evidence.words.value_or(LastWords());
  const std::string& cause = evidence.fault.cause;
  const bool threw = cause.starts_with("exception");
  const bool is_null = words.address == AddressKind::null;
  const auto asked_for = [&evidence](std::string_view what) {
    return evidence.requests.find(what) != std::string::npos;
  };
  if (words.team_call == plugins::TeamCall::none && words.signal == 0) return "global";
  if (asked_for("thread\n") && threw) return "thread";
  if (cause == "exception std::bad_alloc") return "";
  if (cause == "exception std::logic_error" && asked_for("variable ")) return "variable";
  if (asked_for("file ") && (is_null || threw)) return "file";
  if (asked_for("program ") && is_null) return "program";
  if (asked_for("connection") && threw) return "connection";
  if (threw) return sentence("thrown " + cause).empty() ? "thrown" : "thrown " + cause;
  if (cause == "command" || cause == "memory" || words.signal == 0) return "";
  const char* const signal = sigabbrev_np(words.signal);  // null for a signal without a name
  const std::string of_signal = std::string("signal ") + (signal != nullptr ? signal : "");
  return sentence(of_signal).empty() ? key_of_address[static_cast<std::size_t>(words.address)]
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
  const std::string& cause = evidence.fault.cause;
  const std::string code(to_string(evidence.fault.code));
  std::vector<std::string> keys{code + ' ' + cause, code};
  if (evidence.fault.code == match::FaultCode::crash)
    keys.insert(keys.begin(), key_of_crash(evidence));
  if (evidence.is_python)
    keys.insert(keys.begin(),
                {"python " + cause, "python " + code + ' ' + cause, "python " + code});
  for (const std::string& key : keys) {
    const std::string known = sentence(key);
    if (!known.empty()) return known + (key.starts_with("thrown") ? sentence("throw") : "");
  }
  return "see strategy.h";
}

}  // namespace mirocup::app
