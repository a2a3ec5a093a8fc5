// SPDX-License-Identifier: MIT
//
// Runs the programs as their users do: arguments in, exit code and text out.
#pragma once

#include "tests/support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace mirocup::test_support {

struct Outcome {
  int exit_code = 0;  // 128 + signal if it died of one
  std::string out;
  std::string err;
};

// A program that runs while the test does something else.
class Running {
 public:
  explicit Running(const std::vector<std::string>& arguments);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();  // kills it

  int pid() const { return pid_; }
  void signal(int number) const;
  Outcome wait();
  // What it has written to standard error so far.
  std::string err() const;

 private:
  int pid_ = -1;
  std::string out_, err_;  // files
};

Outcome run(const std::vector<std::string>& arguments);

// build/NAME of the build that the tests belong to.
std::string program(const std::string& name);

std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& bytes);
nlohmann::ordered_json read_json(const std::string& path);

}  // namespace mirocup::test_support
