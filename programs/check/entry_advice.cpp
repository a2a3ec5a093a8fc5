// SPDX-License-Identifier: MIT
#include "programs/check/entry_advice.hpp"

#include <csignal>
#include <span>
#include <string_view>

namespace mirocup::app {

namespace {

using match::FaultCode;
using plugins::AddressKind;
using plugins::LastWords;

struct CauseAdvice {
  std::string_view cause;
  const char* advice;
};

// Returns the advice on a cause; null if the table has none.
const char* advice_in(std::span<const CauseAdvice> table, std::string_view cause) {
  for (const CauseAdvice& row : table) {
    if (row.cause == cause) return row.advice;
  }
  return nullptr;
}

constexpr const char* in_a_debugger =
    "build it with -g and run gdb --args mirocup match --trusted --blue FILE.so --yellow striker";

constexpr const char* no_exit = "return instead of calling exit()";
constexpr const char* bad_index = "an index or a pointer was out of bounds: ";
constexpr const char* one_file =
    "a team is one file: put its own modules into it, and use Python's library or a module that "
    "the host has installed";
constexpr const char* no_process = "a team starts no processes: compute in decide()";
constexpr const char* no_file =
    "a team opens no file and no connection: put its data into the source";

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

std::string advice_on_signal(const LastWords& words) {
  switch (words.signal) {
    case SIGILL:
      return "it was built for a newer processor than this one (leave out -march=native), or "
             "clang++ compiled a function that can end without its return: heed the warnings of "
             "-Wall";
    case SIGFPE:
      return std::string("an integer was divided by zero: ") + in_a_debugger;
    case SIGABRT:
      return "an assert(), abort(), std::terminate() or an exception of a global object ended the "
             "process; the log's last line may say which";
    default:
      break;
  }
  switch (words.address) {
    case AddressKind::null:
      return std::string("a pointer was null, or a vector had no elements: ") + in_a_debugger;
    case AddressKind::end_of_stack:
      return "the stack of 8 MiB was full: look for a recursion without end, and keep large arrays "
             "as members of the team";
    case AddressKind::observation:
      return "the observation is for reading: copy what you change";
    case AddressKind::lost:
      return "the stack was overwritten: look in functions for a text or an array that is too "
             "small for what is written to it; a test that is built with -g -fsanitize=address "
             "names the line";
    default:
      return std::string(bad_index) + in_a_debugger;
  }
}

// Exceptions that the team did not catch.
constexpr CauseAdvice exceptions[] = {
    {"exception std::out_of_range",
     "an index of at() or substr() was not below the size, or a map does not have the key: print "
     "the index or the key"},
    {"exception std::invalid_argument", "a text that is no number was read as one: print the text"},
    {"exception std::length_error",
     "an array, a vector or a text was given a size that is negative or huge"},
    {"exception std::logic_error",
     "a text was made of a null pointer: test the pointer for null first"},
    {"exception std::bad_optional_access",
     "value() was asked of an empty optional: ask has_value() first"},
    {"exception std::bad_function_call",
     "an empty std::function was called: give it a function first"},
    {"exception std::bad_variant_access",
     "get() was asked for a type that the variant does not hold"},
    {"exception std::system_error",
     "a system call failed: a team has one thread, no clock to wait for, and no files"},
    {"exception std::filesystem::__cxx11::filesystem_error", no_file}};

std::string advice_on_crash(const FaultEvidence& evidence) {
  const LastWords words = evidence.words.value_or(LastWords());
  const std::string& cause = evidence.fault.cause;
  const bool threw = cause.starts_with("exception");
  if (words.team_call == plugins::TeamCall::none && words.signal == 0)
    return "a constructor of a global object ended the process; make the object a member of the "
           "team";
  if (has(evidence.requests, "thread\n") && threw)
    return "it asked for a thread: a team has one, so compute in decide()";
  if (cause == "exception std::bad_alloc")
    return "it used more than 1 GiB of memory; keep what a team needs, and free the rest";
  if (cause == "exception std::logic_error" && has(evidence.requests, "variable "))
    return "getenv() returned null: a team's process has no such variable, so test the result for "
           "null, or use a parameter";
  if (has(evidence.requests, "file ") && (words.address == AddressKind::null || threw))
    return "it asked for a file, which no team can open: put its data into the source";
  if (has(evidence.requests, "program ") && words.address == AddressKind::null)
    return "it asked for a program, which no team can run: popen() returned null";
  if (has(evidence.requests, "connection") && threw) return no_file;
  if (threw) {
    const char* known = advice_in(exceptions, cause);
    return std::string(known != nullptr ? known : "catch the exception, or mend its cause") +
           "; gdb stops at the throw with catch throw: " + in_a_debugger;
  }
  if (cause == "command")
    return "look at the index of wheels[]: it goes from 0 to the number of robots less 1";
  if (cause == "memory")
    return "build a test of yours with -g -fsanitize=address, which names the line";
  if (words.signal != 0) return advice_on_signal(words);
  if (cause == "exited") return no_exit;
  if (cause == "bad_pointer") return std::string(bad_index) + in_a_debugger;
  return in_a_debugger;
}

constexpr const char* methods =
    "the methods are __init__(self, setup), decide(self, now) and place(self, now, placement)";
constexpr CauseAdvice python_errors[] = {
    {"relative_import", one_file},
    {"SystemExit", no_exit},
    {"exited", no_exit},
    {"RecursionError", "look for a method that calls itself without end"},
    {"no_default",
     "write self.parameter(\"name\", 0.5): 0.5 is the parameter's value in a leg that gives none"},
    {"bad_point",
     "a point is a pair: self.draw_line(\"layer\", 0xff0000ff, (0.0, 0.0), (0.1, 0.2))"},
    {"signature", methods},
    {"UnboundLocalError",
     "a name that a function assigns to is local in the function: use another name, or keep the "
     "value in self"},
    {"IndexError",
     "an index goes from 0 to the length of the list less 1; the last robot has the index "
     "now.robots - 1"},
    {"import_package", "write \"from mirocup.team import Team\""},
    {"ImportError", "team.py has the names of all functions (docs/python.md)"},
    {"PermissionError", no_file},
    {"gaierror", no_file},
    {"process", no_process},
    {"thread", "a team has one thread: compute in decide()"},
    {"EOFError", "a team has no standard input: use a parameter, or put its data into the source"},
    {"FileNotFoundError", no_file},
    {"MemoryError", "it used more than 1 GiB of memory; keep what a team needs, and free the rest"},
    {"UnicodeDecodeError", "save the file as UTF-8"},
    {"SyntaxError", "mend that line; the log shows it, and the version of Python of this host"},
    {"read_only",
     "observation and setup are for reading: now._replace(ball_x=0.1) makes a changed copy, and in "
     "place() write placement.robots[i] = Pose(x, y, heading)"}};

// A team in Python: its log has the traceback.
std::string advice_on_python(const FaultEvidence& evidence) {
  const bool is_loaded = evidence.fault.code == FaultCode::crash;
  if (is_loaded || evidence.fault.code == FaultCode::no_load) {
    if (const char* known = advice_in(python_errors, evidence.fault.cause)) return known;
    if (evidence.fault.cause == "ModuleNotFoundError")
      return is_loaded ? "import the module at the top of the file: no file can be opened while "
                         "the team plays"
                       : one_file;
  }
  switch (evidence.fault.code) {
    case FaultCode::no_load:
      return "mend that line; the log shows it";
    case FaultCode::crash:
      return "mend it: the log has the traceback, and mirocup match --trusted stops at "
             "breakpoint()";
    case FaultCode::start_timeout:
      return "do less at the top of the file and in __init__()";
    case FaultCode::budget:
      return advice_on_time_in_python;
    case FaultCode::illegal_call:
      return "files, network, processes and signals are not for a team, nor for a module that it "
             "imports: do without them";
    default:
      return "";
  }
}

}  // namespace

std::string advice_on(const FaultEvidence& evidence) {
  if (evidence.is_python) {
    if (std::string advice = advice_on_python(evidence); !advice.empty()) return advice;
  }
  const std::string& cause = evidence.fault.cause;
  switch (evidence.fault.code) {
    case FaultCode::no_load:
      if (cause == "no_team") return "create() has to return the team";
      if (cause == "large_tables")
        return "its tables need more than the 1 GiB of memory that a team has: make them smaller";
      return "define each function that the library declares and calls, link into it what it uses, "
             "or use libraries that the system has";
    case FaultCode::bad_abi:
      if (cause == "no_version")
        return "set abi_version to MIROCUP_ABI_VERSION, and size to sizeof(mirocup_strategy)";
      if (cause == "wild_version") {
        return "no strategy.h has that version: mirocup_entry() may return the address of a local "
               "variable; make that variable static";
      }
      if (cause == "no_strategy")
        return "mirocup_entry() has to return a pointer to a static mirocup_strategy";
      if (cause == "incomplete")
        return "set size, create and decide of the mirocup_strategy that mirocup_entry() returns";
      return "build it again against the strategy.h of this version, and export mirocup_entry()";
    case FaultCode::start_timeout:
      return "do less in create() and in static constructors";
    case FaultCode::crash:
      return advice_on_crash(evidence);
    case FaultCode::hang:
      if (cause == "slept") return "do not sleep or wait in decide()";
      return "look for a loop that does not end, a recursion, or a handler of signals";
    case FaultCode::budget:
      return advice_on_time;
    case FaultCode::illegal_call:
      return "a strategy computes; files, network, processes and threads are not for it";
    default:
      return "see strategy.h";
  }
}

}  // namespace mirocup::app
