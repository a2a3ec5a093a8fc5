// SPDX-License-Identifier: MIT
//
// mirocup: one match, its records, its teams. One file per subcommand.
#include "server/app/command_line.hpp"
#include "server/app/commands.hpp"
#include "system/printable.hpp"

#include <iostream>
#include <string_view>

using namespace mirocup;

int main(int argc, char** argv) {
  const auto report = [](const Result<int>& result) {
    if (result) return *result;
    std::cerr << "mirocup: " << system::printable(result.error().what) << '\n';
    return exit_code(result.error().code);
  };
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "league") return report(app::become_sibling_program("mirocup-league", argc, argv));
  if (command == "bench") return report(app::become_sibling_program("mirocup-bench", argc, argv));

  app::Run run;
  if (const auto done = app::read_command_line(argc, argv, run)) return *done;
  return report(run());
}
