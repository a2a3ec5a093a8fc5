// SPDX-License-Identifier: MIT
//
// The subcommands serve and check-hand-in.
#include "programs/league/commands.hpp"
#include "programs/league/served_league.hpp"
#include "system/clock.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/process_set.hpp"
#include "system/tls.hpp"
#include "tournaments/handin/check_runner.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

constexpr double wait_s = 3600.0;  // s

void tell_host(const std::string& line) {
  std::cerr << "mirocup: " << system::printable(line) << std::endl;
}

web::Site site_of(ServedLeague& league) {
  return {.page = [&league](const std::string& path) { return league.page(path); },
          .news = [&league](std::uint64_t& seen) { return league.news(seen); },
          .match = [&league](const std::string& name) { return league.match(name); }};
}

Result<std::unique_ptr<Portal>> open_portal(system::Files& files, const ServeOptions& options,
                                            ServedLeague& league) {
  PortalOptions portal;
  portal.proxy.addresses = {options.proxies.begin(), options.proxies.end()};
  portal.proxy.team_header = options.team_header;
  portal.why_not = [&league](const std::string& team, const std::string& now) {
    return league.why_not(team, now);
  };
  portal.legs = [&league](const std::string& team) { return league.legs_of(team); };
  portal.digest = [&league](const std::string& team) { return league.digest_of(team); };
  portal.replay = [&league](const std::string& name, const record::Whose& whose) {
    return league.own_replay(name, whose);
  };
  portal.statistics = [&league](const std::string& team) { return league.statistics_of(team); };
  portal.time_in_words = [&league](const std::string& utc) { return league.time_in_words(utc); };
  portal.friendlies = {
      .teams = [&league] { return league.entries_that_play(); },
      .neighbours = [&league](const std::string& team) { return league.neighbours_of(team); },
      .house = system::house_teams(),
      .replay = [&league](const std::string& record,
                          const record::Whose& whose) { return league.replay_of(record, whose); }};
  portal.now = [] { return system::now_s(); };
  std::string notice;
  auto opened = Portal::open(files, Folder{options.folder}, std::move(portal), &notice);
  if (!notice.empty()) tell_host(notice);
  return opened;
}

Result<web::SiteLimits> limits_of(const ServeOptions& options) {
  web::SiteLimits limits;
  if (options.hand_in) limits.max_upload = system::size_limit::entry;
  if (options.tls.empty()) return limits;
  MIROCUP_TRY(limits.tls, system::TlsServer::load(options.tls.front(), options.tls.back()));
  return limits;
}

}  // namespace

Result<int> run_serve(const ServeOptions& options) {
  MIROCUP_TRY(const auto address, web::parse_address(options.at, "--at"));
  if (!options.team_header.empty() && options.proxies.empty())
    return fail(Errc::input, "--team-header needs --trust-proxy: anybody can send a header");
  MIROCUP_TRY(auto limits, limits_of(options));
  system::Disk disk;
  MIROCUP_TRY(auto store, LeagueStore::open(disk, Folder{options.folder}));
  system::ProcessSet processes;  // must exist before the first thread starts
  ServedLeague league(disk, std::move(store));
  web::Site site = site_of(league);
  std::unique_ptr<Portal> portal;
  if (options.hand_in) {
    league.offer_hand_in();
    MIROCUP_TRY(portal, open_portal(disk, options, league));
    site.desk = [&portal = *portal](const web::Request& request, const web::Body& body) {
      return portal.answer(request, body);
    };
  }
  MIROCUP_TRY(const auto server,
              web::SiteServer::open(address, "--at", std::move(site), std::move(limits)));
  std::cout << server->url() << std::endl;
  if (portal) {
    const int jobs =
        options.jobs > 0 ? options.jobs : static_cast<int>(system::processors().size());
    CheckRunner checks(disk, Folder{options.folder}, *portal, processes, jobs, tell_host);
    while (checks.step()) {
    }
  } else {
    while (!processes.is_asked_to_stop_within(wait_s)) {
    }
  }
  return exit_yes;
}

Result<int> run_check_hand_in(const CheckHandInOptions& options) {
  system::Disk disk;
  return check_hand_in(disk, Folder{options.folder}, options.team, options.entry, options.file,
                       options.at, options.compile_seconds);
}

}  // namespace mirocup::league
