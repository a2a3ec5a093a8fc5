// SPDX-License-Identifier: MIT
//
// mirocup league serve: shows a league in browsers, and takes hand-ins.
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

struct ServeOptions {
  std::string folder;
  std::string at = "0";  // [HOST:]PORT
  bool hand_in = false;  // take entries from teams with a token

  // With hand_in.
  int jobs = 0;                      // checks at once; 0: one for each processor
  std::vector<std::string> tls;      // files of certificate and key; empty: no encryption
  std::vector<std::string> proxies;  // addresses that are believed whom they speak for
  std::string team_header;           // in which they name a team; "": none is believed
};

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
  portal.shown_name = [&league](const std::string& team) { return league.shown_name_of(team); };
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

Result<int> run_serve(const ServeOptions& options) {
  MIROCUP_TRY(const auto address, web::parse_address(options.at, "--at"));
  if (!options.team_header.empty() && options.proxies.empty())
    return fail(Errc::input, "--team-header needs --trust-proxy: anybody can send a header");
  MIROCUP_TRY(auto limits, limits_of(options));
  if (options.hand_in) {
    MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  }
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

}  // namespace

void add_serve(system::Commands& commands) {
  const auto [command, o] = commands.add<ServeOptions>(
      {"serve",
       to_show,
       "Show the league in browsers, as it is now",
       {"mirocup league serve spring --at 8080",
        "mirocup league serve spring --hand-in --at 0.0.0.0:8443 --tls cert.pem key.pem"}},
      run_serve);
  add_folder(command, o.folder);
  command.option("--at", o.at, "where to listen (default: this host only, any free port)");
  const system::Option hand_in = command.flag(
      "--hand-in", o.hand_in, "also take entries from teams that have a token (league token)");
  command.option("--jobs", o.jobs, "number of checks at once (default: one for each processor)")
      .between(1, 1024)
      .needs(hand_in);
  command.option("--tls", o.tls, "encrypt connections: files of the certificate and of its key")
      .named("CERT KEY")
      .takes(2, 2);
  command
      .option("--trust-proxy", o.proxies,
              "address of a proxy that is believed for whom it asks (X-Forwarded-For, "
              "X-Forwarded-Proto); may be given several times")
      .named("ADDR")
      .takes(1, 1)
      .needs(hand_in);
  command
      .option("--team-header", o.team_header,
              "header in which that proxy names the team of a person that it has signed on")
      .named("NAME")
      .needs(hand_in);
}

}  // namespace mirocup::league
