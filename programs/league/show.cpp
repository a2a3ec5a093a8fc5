// SPDX-License-Identifier: MIT
//
// The subcommand show.
#include "programs/league/commands.hpp"
#include "programs/league/shown_round.hpp"
#include "system/process_set.hpp"

#include <iostream>
#include <random>

namespace mirocup::league {

namespace {

struct ShowOptions {
  std::string folder;
  std::string round;     // its key, as in "r3"; "": the last one of which a leg was played
  std::string at = "0";  // [HOST:]PORT
  int at_once = 1;       // legs side by side
};

constexpr double poll_s = 3600.0;  // s

// 128 bits of the system, as text for an address.
std::string secret() {
  std::random_device random;
  std::string text;
  constexpr std::string_view digits = "0123456789abcdef";
  for (int i = 0; i < 4; ++i) {
    unsigned bits = random();
    for (int digit = 0; digit < 8; ++digit, bits >>= 4) text += digits[bits & 15u];
  }
  return text;
}

Result<int> run_show(const ShowOptions& options) {
  MIROCUP_TRY(const auto address, web::parse_address(options.at, "--at"));
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  system::ProcessSet interrupts;  // must exist before the first thread starts
  const std::string key = secret();
  MIROCUP_TRY(auto round, ShownRound::of(disk, store, options.round, key, options.at_once));
  MIROCUP_TRY(const auto server,
              web::SiteServer::open(
                  address, "--at",
                  {.page = [&](const std::string& path) { return round.page(path); },
                   .news = [&](std::uint64_t& seen) { return round.news(seen); },
                   .match = [](const std::string&) { return std::nullopt; },
                   .control = [&](const std::string& body) { return round.control(body); }}));
  const std::string url = server->url();
  std::cout << url << '\n' << url << "remote#" << key << std::endl;
  while (!interrupts.is_asked_to_stop_within(poll_s)) {
  }
  return exit_yes;
}

}  // namespace

void add_show(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_show, "show", to_show,
                   "Play the recorded legs of a round on a projector, one after the other",
                   {"mirocup league show spring --round r3 --at-once 2"});
  add_folder(command, o.folder);
  command.option("--round", o.round,
                 "Round: r3, or k1 of a knockout (default: the last round that was played)");
  command.option("--at", o.at, "Where to listen (default: this host only, any free port)");
  command.option("--at-once", o.at_once, "Number of legs side by side: 1, 2 or 4")
      .one_of_numbers({1, 2, 4});
}

}  // namespace mirocup::league
