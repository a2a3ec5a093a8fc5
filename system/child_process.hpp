// SPDX-License-Identifier: MIT
//
// Starts programs: as child processes, or in the place of this one. ProcessSet
// (system/process_set.hpp) waits for several children.
//
// The kernel kills a child when the thread that started the child ends, so also when this process
// ends. A child inherits only the descriptors of standard input, output and error, and no blocked
// signals.
#pragma once

#include "core/base/error.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mirocup::system {

// The exit code of a child that could not become its program.
inline constexpr int not_found = 127;

// The limits of a program that mirocup does not vouch for. The program and all processes of its
// group are killed when it ends, or when its time is over.
struct ChildLimits {
  double seconds = std::numeric_limits<double>::infinity();  // wall time
  // The size of its output, and of each other file that it or its children write. SIGXFSZ ends a
  // process that writes more.
  std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
};

// The program of a child process, and its surroundings.
struct ChildOptions {
  std::vector<std::string> arguments;  // [0]: the program, a path or a name on the PATH
  int cpu = -1;                        // the only processor that the child may use; -1: any
  // The file for its output and errors: a regular file of this user, or a device. A child with a
  // log has no input and a separate process group, so that an interrupt at the terminal reaches
  // this process alone. "": the child has the input, output, errors and process group of this
  // process.
  std::string log = {};
  std::uint64_t max_bytes = ChildLimits().bytes;  // as in ChildLimits
};

// Starts a child and returns its process id. The caller must wait for it. If the program does not
// exist, the child ends with the code not_found. Errc::unavailable if the process cannot be started
// or the log cannot be written.
Result<pid_t> start_child(const ChildOptions& options);

// Starts a child and waits for its end. Returns its exit code, or 128 + the number of the signal
// that ended it.
Result<int> run_child(const ChildOptions& options);

// What a program has answered.
struct Answer {
  int code = 0;        // as run_child() returns it
  std::string output;  // its output and errors, in the order in which it wrote them
};

// Asks a program a question: runs it as a child with a log in memory, and waits for its end. A
// process that the program leaves behind does not delay the answer. Errc::unavailable if the
// program cannot be started, or has not ended in time.
Result<Answer> ask(const std::vector<std::string>& arguments, const ChildLimits& limits);

// True if a child has ended, for whose status nobody has waited yet.
bool has_ended(pid_t pid);

// Kills a child that leads a process group, such as one with a log, and all processes of its group.
// The child may have ended, but nobody may have waited for it. Returns its status, as waitpid()
// does.
int end_group(pid_t leader);

// Runs the program arguments[0], a path, in the place of this process. Returns only if the program
// cannot be run, with the reason.
Error become_program(std::vector<std::string> arguments);

// Runs another program of the same build or installation in the place of this process, with
// arguments after its name. Returns only if the program cannot be run: Errc::unavailable; if it is
// missing, with the command that builds it, in which CMake gets `options`: "-D MIROCUP_LABS=ON".
Error become_sibling_program(const std::string& name, std::vector<std::string> arguments,
                             const std::string& options = "");

}  // namespace mirocup::system
