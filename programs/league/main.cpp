// SPDX-License-Identifier: MIT
//
// mirocup-league: plays leagues, each in a folder. `mirocup league` starts this program.
#include "programs/league/command_line.hpp"
#include "system/begin.hpp"
#include "system/printable.hpp"
#include "system/standard_output.hpp"

#include <iostream>

using namespace mirocup;

namespace {

Result<int> run(int argc, char** argv) {
  MIROCUP_TRY_VOID(system::begin());
  const auto chosen = league::read_command_line(argc, argv);
  if (const int* done = std::get_if<int>(&chosen)) return *done;
  return std::get<system::Run>(chosen)();
}

}  // namespace

int main(int argc, char** argv) {
  const Result<int> result = run(argc, argv);
  if (result) return system::after_standard_output(*result);
  std::cerr << "mirocup: " << system::printable(result.error().what) << '\n';
  return exit_code(result.error().code);
}
