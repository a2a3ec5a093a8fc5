// SPDX-License-Identifier: MIT
//
// The subcommand serve.
#include "system/process_set.hpp"
#include "tournaments/app/commands.hpp"
#include "tournaments/app/served_league.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

constexpr double wait_s = 3600.0;  // s

}  // namespace

Result<int> run_serve(const ServeOptions& options) {
  const auto address = web::parse_address(options.at, "--at");
  if (!address) return tl::unexpected(address.error());
  system::Disk disk;
  auto store = LeagueStore::open(disk, Folder{options.folder});
  if (!store) return tl::unexpected(store.error());
  system::ProcessSet interrupts;  // must exist before the first thread starts
  ServedLeague league(disk, std::move(*store));
  const auto server = web::SiteServer::open(
      *address, "--at",
      {.page = [&league](const std::string& path) { return league.page(path); },
       .news = [&league](std::uint64_t& seen) { return league.news(seen); },
       .match = [&league](const std::string& name) { return league.match(name); }});
  if (!server) return tl::unexpected(server.error());
  std::cout << (*server)->url() << std::endl;
  while (!interrupts.is_asked_to_stop_within(wait_s)) {
  }
  return exit_yes;
}

}  // namespace mirocup::league
