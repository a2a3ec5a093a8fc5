// SPDX-License-Identifier: MIT
#include "programs/check/entry_advice.hpp"

#include "plugins/host/function_names.hpp"

#include <algorithm>
#include <csignal>

namespace mirocup::app {

namespace {

using match::FaultCode;
using plugins::AddressKind;
using plugins::LastWords;

// What the text of an error says, and the advice. Tables are searched from the top.
struct ErrorAdvice {
  const char* part;
  const char* advice;
};

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

// Versions of strategy.h are small numbers; others are what lay in memory.
bool claims_no_version(const std::string& text) {
  constexpr std::string_view before = "built for version ";
  constexpr std::size_t most_digits = 3;
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return false;
  const std::size_t end = text.find_first_not_of("0123456789", at + before.size());
  return end != std::string::npos && end - (at + before.size()) > most_digits;
}

// Returns the name of the function that the loader misses, as it stands in the source; "" if it
// misses none of C++.
std::string missing_function(const std::string& text) {
  constexpr std::string_view before = "undefined symbol: ";
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + before.size();
  const std::size_t end = std::min(text.find_first_of(" ,\"", begin), text.size());
  const std::string symbol = text.substr(begin, end - begin);
  const std::string name = plugins::readable_name(symbol);
  return name == symbol ? "" : name + "()";
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

// The words of the C++ library are for those who know it.
constexpr ErrorAdvice library_errors[] = {
    {"map::at", "a map does not have the key: test that by find() or contains() first"},
    {"range_check", "an index of at() or substr() was not below the size: print the index"},
    {"basic_string::", "a position was beyond the end of a text: print the position"},
    {"array::at", "an index of at() was not below the size: print the index"},
    {"threw: sto", "a text that is no number was read as one: print the text"},
    {"bad optional access", "value() was asked of an empty optional: ask has_value() first"},
    {"bad_function_call", "an empty std::function was called: give it a function first"},
    {"bad variant access", "get() was asked for a type that the variant does not hold"},
    {"bad_variant_access", "get() was asked for a type that the variant does not hold"},
    {"max_size", "a vector or a text was given a size that is negative or huge"},
    {"bad_array_new_length", "an array was given a size that is negative or huge"},
    {"filesystem error", no_file}};

std::string advice_on_crash(const FaultEvidence& evidence) {
  const LastWords words = evidence.words.value_or(LastWords());
  const std::string& text = evidence.fault.text;
  if (words.team_call == plugins::TeamCall::none && words.signal == 0)
    return "a constructor of a global object ended the process; make the object a member of the "
           "team";
  if (has(evidence.requests, "thread\n") && has(text, "threw"))
    return "it asked for a thread: a team has one, so compute in decide()";
  if (has(text, "bad_alloc"))
    return "it used more than 1 GiB of memory; keep what a team needs, and free the rest";
  if (has(text, "from null is not valid") && has(evidence.requests, "variable "))
    return "getenv() returned null: a team's process has no such variable, so test the result for "
           "null, or use a parameter";
  if (has(text, "locale"))
    return "a team's process has the locale \"C\" and no other: do without other locales";
  if (has(evidence.requests, "file ") && (words.address == AddressKind::null || has(text, "threw")))
    return "it asked for a file, which no team can open: put its data into the source";
  if (has(evidence.requests, "program ") && words.address == AddressKind::null)
    return "it asked for a program, which no team can run: popen() returned null";
  if (has(evidence.requests, "connection") && has(text, "threw")) return no_file;
  if (has(text, "threw")) {
    std::string advice = "catch the exception, or mend the code that throws it";
    for (const ErrorAdvice& error : library_errors) {
      if (!has(text, error.part)) continue;
      advice = error.advice;
      break;
    }
    return advice + "; gdb stops at the throw with catch throw: " + in_a_debugger;
  }
  if (has(text, "of its command"))
    return "look at the index of wheels[]: it goes from 0 to the number of robots less 1";
  if (has(text, "freed") || has(text, " a block of "))
    return "build a test of yours with -g -fsanitize=address, which names the line";
  if (words.signal != 0) return advice_on_signal(words);
  if (has(text, "ended itself")) return no_exit;
  if (has(text, "signal 11")) return std::string(bad_index) + in_a_debugger;
  return in_a_debugger;
}

constexpr const char* methods =
    "the methods are __init__(self, setup), decide(self, now) and place(self, now, placement)";
constexpr ErrorAdvice python_errors[] = {
    {"coroutine object", "write def decide(self, now), without async"},
    {"place() left something", "write placement.robots[i] = Pose(x, y, heading)"},
    {"no known parent package", one_file},
    {"name 'quit' is not", no_exit},
    {"name 'exit' is not", no_exit},
    {"RecursionError", "look for a method that calls itself without end"},
    {".parameter() missing",
     "write self.parameter(\"name\", 0.5): 0.5 is the parameter's value in a leg that gives none"},
    {"string to float", "a text that is no number was read as one; parameters are numbers"},
    {".draw_", "a point is a pair: self.draw_line(\"layer\", 0xff0000ff, (0.0, 0.0), (0.1, 0.2))"},
    {"returned None", "each way through decide() has to end with return and the list"},
    {"decide() returned",
     "return a list with (left, right) in rad/s for each robot, as [(10.0, 10.0)] * now.robots"},
    {"defines decide(self, now)", "name the method decide, in small letters"},
    {"Team.__init__() missing", "the match makes the team: leave out your line that makes one"},
    {".decide() missing", methods},
    {".decide() takes", methods},
    {".place() missing", methods},
    {".place() takes", methods},
    {".__init__() missing", methods},
    {".__init__() takes", methods},
    {"UnboundLocalError",
     "a name that a function assigns to is local in the function: use another name, or keep the "
     "value in self"},
    {"IndexError",
     "an index goes from 0 to the length of the list less 1; the last robot has the index "
     "now.robots - 1"},
    {"module 'mirocup' has no attribute", "write \"from mirocup.team import Team\""},
    {"cannot import name", "team.py has the names of all functions (docs/python.md)"},
    {"object is not callable",
     "brackets ( ) call a function: leave them out after data, and write an index in [ ]"},
    {"Operation not permitted", "a team sends no signals and changes nothing of the system"},
    {"ended itself", no_exit},
    {"multiprocessing", no_process},
    {"Too many open files", no_process},
    {"Resource temporarily unavailable", no_process},
    {"start new thread", "a team has one thread: compute in decide()"},
    {"lost sys.stdin",
     "a team has no standard input: use a parameter, or put its data into the source"},
    {"EOFError", "a team has no standard input: use a parameter, or put its data into the source"},
    {"'NoneType' object has no attribute 'read",
     "a team has no standard input: use a parameter, or put its data into the source"},
    {"unknown encoding: idna", no_file},
    {"gaierror", no_file},
    {"PermissionError", no_file},
    {"FileNotFoundError", no_file},
    {"MemoryError", "it used more than 1 GiB of memory; keep what a team needs, and free the rest"},
    {"defines no class", "derive a class: class Mine(Team), with decide(self, now)"},
    {"defines several teams",
     "keep one class that derives from Team, and hand in the others as separate files"},
    {"has to call super()", "call super().__init__(setup) first in __init__()"},
    {"UnicodeDecodeError", "save the file as UTF-8"},
    {"set attribute",
     "named tuples are for reading: now._replace(ball_x=0.1) makes a changed copy, and in place() "
     "write placement.robots[i] = Pose(x, y, heading)"},
    {"does not support item assignment",
     "observation and setup are for reading: now._replace(ball_x=0.1) makes a changed copy"},
    {"SystemExit", no_exit}};

// A team in Python: its log has the traceback.
std::string advice_on_python(const FaultEvidence& evidence) {
  const std::string& text = evidence.fault.text;
  const bool is_loaded = evidence.fault.code == FaultCode::crash;
  if (is_loaded || evidence.fault.code == FaultCode::no_load) {
    for (const ErrorAdvice& error : python_errors) {
      if (has(text, error.part)) return error.advice;
    }
    if (has(text, "No module named")) {
      return is_loaded ? "import the module at the top of the file: no file can be opened while "
                         "the team plays"
                       : one_file;
    }
  }
  switch (evidence.fault.code) {
    case FaultCode::no_load:
      if (has(text, "SyntaxError"))
        return "mend that line; the log shows it, and the version of Python of this host";
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
  const std::string& text = evidence.fault.text;
  switch (evidence.fault.code) {
    case FaultCode::no_load:
      if (has(text, "undefined symbol: __ubsan_"))
        return "it was built with -fsanitize=undefined by clang++: build it without that option";
      if (const std::string name = missing_function(text); !name.empty()) {
        return "it declares " + name +
               " and does not define it: write the definition, or link the source or the library "
               "that has it";
      }
      if (has(text, "undefined symbol"))
        return "the library calls a function that is missing: link the source or the library that "
               "defines it";
      if (has(text, "returned null")) return "create() has to return the team";
      if (has(text, "failed to map segment") || has(text, "cannot allocate memory"))
        return "its tables need more than the 1 GiB of memory that a team has: make them smaller";
      return "link into the team's library what it uses, or use libraries that the system has";
    case FaultCode::bad_abi:
      if (has(text, "for version 0 of"))
        return "set abi_version to MIROCUP_ABI_VERSION, and size to sizeof(mirocup_strategy)";
      if (claims_no_version(text)) {
        return "no strategy.h has that version: mirocup_entry() may return the address of a local "
               "variable; make that variable static";
      }
      if (has(text, "returned null"))
        return "mirocup_entry() has to return a pointer to a static mirocup_strategy";
      if (has(text, "incomplete"))
        return "set size, create and decide of the mirocup_strategy that mirocup_entry() returns";
      return "build it again against the strategy.h of this version, and export mirocup_entry()";
    case FaultCode::start_timeout:
      return "do less in create() and in static constructors";
    case FaultCode::crash:
      return advice_on_crash(evidence);
    case FaultCode::hang:
      if (has(text, "slept")) return "do not sleep or wait in decide()";
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
