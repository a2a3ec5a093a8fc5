// SPDX-License-Identifier: MIT
//
// mirocup: one match, its records, its teams. One file per subcommand.
#include "server/app/commands.hpp"
#include "server/record/match_record.hpp"

#include <iostream>
#include <string_view>

using namespace mirocup;

int main(int argc, char** argv) {
  const auto report = [](const Result<int>& result) {
    if (result) return *result;
    std::cerr << "mirocup: " << result.error().what << '\n';
    return exit_code(result.error().code);
  };
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "league") return report(app::run_program("mirocup-league", argc, argv));
  if (command == "bench") return report(app::run_program("mirocup-bench", argc, argv));

  CLI::App cli("A tournament platform for MiroSot robot soccer.", "mirocup");
  cli.require_subcommand(1);
  cli.set_version_flag("--version", record::software_version());
  cli.footer(
      "mirocup league ... runs tournaments: see mirocup league --help.\n"
      "mirocup bench ... compares speed and error with other engines: see mirocup bench --help.");
  app::Run run;
  app::add_match(cli, run);
  app::add_check(cli, run);
  app::add_join(cli, run);
  app::add_new(cli, run);
  app::add_verify(cli, run);
  app::add_rerun(cli, run);
  app::add_replay(cli, run);
  app::add_scene(cli, run);
  app::add_referee(cli, run);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const bool asked_for_help = e.get_exit_code() == 0;
    cli.exit(e);
    return asked_for_help ? exit_yes : exit_code(Errc::input);
  }
  return report(run());
}
