// SPDX-License-Identifier: MIT
//
// Runs the programs as their users do: with arguments, for an exit code and text.
#pragma once

#include "tests/support/contains.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace mirocup::test_support {

struct Outcome {
  int exit_code = 0;  // 128 + signal if a signal ended it
  std::string out;
  std::string err;
};

// A program that runs while the test does something else. Its standard output and error go to
// files.
class Running {
 public:
  explicit Running(const std::vector<std::string>& arguments);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();  // kills the program if it still runs

  int pid() const { return pid_; }
  void signal(int number) const;
  // Waits until the program ends, without a limit.
  Outcome wait();
  // Returns the standard output and error up to now.
  std::string out() const;
  std::string err() const;

 private:
  int pid_ = -1;
  std::string out_, err_;  // files
};

// Runs a program and waits until it ends.
Outcome run(const std::vector<std::string>& arguments);

// The same of build/mirocup with these arguments.
Outcome run_mirocup(std::vector<std::string> arguments);

// Expects this exit code and a part of the standard error, and says what the program wrote if not.
inline Outcome expect_exit(int code, Outcome outcome, const std::string& said = "",
                           const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (outcome.exit_code != code || !contains(outcome.err, said)) {
    ADD_FAILURE_AT(file, line) << "expected: exit code " << code << ", and on standard error \""
                               << said << "\"\nfound: exit code " << outcome.exit_code << '\n'
                               << outcome.out << outcome.err;
  }
  return outcome;
}

// Waits until a condition holds that depends on another process. Returns false after two
// minutes, so that a test fails with a message instead of running into its own time limit.
bool wait_until(const std::function<bool()>& holds);

// Returns why this machine cannot isolate a team as T2, for example a container that allows no
// namespaces; "" if it can. A test skips what needs T2 and says this reason.
const std::string& why_no_t2();

// Returns the path build/NAME of the build that the tests belong to.
std::string program(const std::string& name);

// Every user may search this folder, also where the build and the folder of temporary files belong
// to a home that others may not enter.
inline constexpr const char* place_for_all = "/tmp";

// Returns program(name) if every user can reach and read it and its path has no blank, at which
// LD_PRELOAD ends a path; otherwise the path of such a copy. The copies of a process lie in one
// folder, as they do in the build.
std::string program_for_all(const std::string& name);

// Returns the words that run `mirocup` as the system's user `nobody`; only root may do that. The
// program finds the house teams idle and chaser.
std::vector<std::string> mirocup_of_nobody();

std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& bytes);
nlohmann::ordered_json read_json(const std::string& path);

}  // namespace mirocup::test_support
