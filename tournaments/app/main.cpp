// SPDX-License-Identifier: MIT
//
// mirocup-league: many matches. A league is a folder; `mirocup league` starts this program.
#include "server/record/locations.hpp"
#include "server/record/match_record.hpp"
#include "tournaments/app/commands.hpp"

#include <iostream>

using namespace mirocup;

int main(int argc, char** argv) {
  CLI::App cli("Leagues of MiroSot robot soccer: a league is a folder.", "mirocup league");
  cli.require_subcommand(1);
  cli.set_version_flag("--version", record::software_version());
  league::Run run;
  league::add_init(cli, run);
  league::add_submit(cli, run);
  league::add_start(cli, run);
  league::add_stop(cli, run);
  league::add_status(cli, run);
  league::add_publish(cli, run);
  league::add_export(cli, run);
  league::add_serve(cli, run);
  league::add_rulings(cli, run);
  league::add_compare(cli, run);
  league::add_shards(cli, run);
  league::add_credentials(cli, run);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const bool asked_for_help = e.get_exit_code() == 0;
    cli.exit(e);
    return asked_for_help ? exit_yes : exit_code(Errc::input);
  }
  const Result<int> result = run();
  if (result) return *result;
  std::cerr << "mirocup: " << result.error().what << '\n';
  return exit_code(result.error().code);
}
