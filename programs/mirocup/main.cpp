// SPDX-License-Identifier: MIT
//
// mirocup: one match, its records, its teams. One file per subcommand.
#include "programs/mirocup/command_line.hpp"
#include "programs/mirocup/commands.hpp"
#include "system/begin.hpp"
#include "system/printable.hpp"
#include "system/standard_output.hpp"

#include <iostream>
#include <string_view>
#include <vector>

using namespace mirocup;

namespace {

int report(const Result<int>& result) {
  if (result) return *result;
  std::cerr << "mirocup: " << system::printable(result.error().what) << '\n';
  return exit_code(result.error().code);
}

int run(int argc, char** argv) {
  if (const auto begun = system::begin(); !begun) return report(tl::unexpected(begun.error()));
  const std::string_view command = argc > 1 ? argv[1] : "";
  // `complete league WORD…` asks the other program.
  if (command == "complete" && argc > 3 && std::string_view(argv[2]) == "league") {
    std::vector<char*> words{argv[0], argv[2], argv[1]};
    words.insert(words.end(), argv + 3, argv + argc);
    return report(app::become_sibling_program("mirocup-league", static_cast<int>(words.size()),
                                              words.data()));
  }
  if (command == "league") return report(app::become_sibling_program("mirocup-league", argc, argv));
  // The subcommand itself is one of that program.
  if (command == "tune")
    return report(app::become_sibling_program("mirocup-league", argc, argv, 1));
  if (command == "bench") return report(app::become_sibling_program("mirocup-bench", argc, argv));

  const auto chosen = app::read_command_line(argc, argv);
  if (const int* done = std::get_if<int>(&chosen)) return *done;
  return report(std::get<system::Run>(chosen)());
}

}  // namespace

int main(int argc, char** argv) {
  // `mirocup help league start` is `mirocup league start --help`, also for a command of another
  // program.
  if (argc > 2 && std::string_view(argv[1]) == "help") {
    char help[] = "--help";
    std::vector<char*> asked{argv[0]};
    asked.insert(asked.end(), argv + 2, argv + argc);
    asked.insert(asked.end(), {help, nullptr});
    return system::after_standard_output(run(argc, asked.data()));
  }
  return system::after_standard_output(run(argc, argv));
}
