// SPDX-License-Identifier: MIT
//
// mirocup league serve: shows a league in browsers, and takes hand-ins.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "programs/league/served_league.hpp"
#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "system/tls.hpp"
#include "tournaments/handin/check_runner.hpp"

namespace mirocup::league {

namespace {

struct ServeOptions : LeagueOptions {
  std::string at = "0";  // [HOST:]PORT or unix:PATH
  std::string base;      // the path at which a proxy shows the league; "": its top, or cut off
  bool hand_in = false;  // take entries from teams with a token

  // With hand_in.
  int jobs = 0;                      // checks at once; 0: one for each processor
  std::vector<std::string> tls;      // files of certificate and key; empty: no encryption
  std::vector<std::string> proxies;  // addresses that are believed whom they speak for
  std::string proxy_secret;          // a file with what these proxies send; "": there is none
  std::string team_header;           // in which they name a team; "": none is believed
};

constexpr double wait_s = 3600.0;         // s
constexpr std::size_t least_secret = 16;  // characters

void tell_host(const std::string& line) {
  std::cerr << "mirocup: " << system::printable(line) << std::endl;
}

web::Site site_of(ServedLeague& league, const std::string& base) {
  return {.page = [&league](const std::string& path) { return league.page(path); },
          .news = [&league](std::uint64_t& seen) { return league.news(seen); },
          .match = [&league](const std::string& name) { return league.match(name); },
          .base = base};
}

Result<std::unique_ptr<Portal>> open_portal(system::Files& files, const ServeOptions& options,
                                            ServedLeague& league) {
  std::string notice;
  auto opened = Portal::open(files, Folder{options.folder}, league,
                             {.team_header = options.team_header,
                              .house = system::house_teams(),
                              .now = [] { return system::now_s(); }},
                             &notice);
  if (!notice.empty()) tell_host(notice);
  return opened;
}

// The secret is not on the command line, which every user of this computer can read.
Result<std::string> read_secret(const std::string& path) {
  system::Disk disk;
  MIROCUP_TRY(std::string secret, disk.read(path, {.max_size = system::size_limit::note}));
  while (secret.ends_with('\n') || secret.ends_with('\r')) secret.pop_back();
  if (secret.size() < least_secret) {
    return fail(Errc::input, path + ": the secret of the proxy needs at least " +
                                 std::to_string(least_secret) +
                                 " characters; make one by: openssl rand -hex 16");
  }
  return secret;
}

// Which programs are the proxy.
Result<web::ProxyTrust> proxy_trust(const ServeOptions& options, const web::Address& address) {
  web::ProxyTrust trust{.addresses = {options.proxies.begin(), options.proxies.end()},
                        .is_unix_socket = !address.path.empty()};
  if (!options.proxy_secret.empty()) {
    MIROCUP_TRY(trust.secret, read_secret(options.proxy_secret));
  }
  if (trust.is_unix_socket) return trust;
  if (!trust.addresses.empty() && trust.secret.empty())
    return fail(Errc::input,
                "--trust-proxy: an address is not enough, since every program on the proxy's "
                "computer has it: name a secret by --proxy-secret FILE, or let a proxy on this "
                "computer connect to --at unix:PATH");
  if (!options.team_header.empty() && trust.addresses.empty())
    return fail(Errc::input,
                "--team-header: anybody can send this header: listen at --at unix:PATH, or name "
                "the proxy by --trust-proxy ADDR and --proxy-secret FILE");
  return trust;
}

Result<web::ServerOptions> server_options(const ServeOptions& options,
                                          const web::Address& address) {
  web::ServerOptions server;
  if (options.hand_in) server.bodies.max_upload = system::size_limit::entry;
  MIROCUP_TRY(server.proxy, proxy_trust(options, address));
  if (options.tls.empty()) return server;
  MIROCUP_TRY(server.tls, system::TlsServer::load(options.tls.front(), options.tls.back()));
  return server;
}

Result<int> run_serve(const ServeOptions& options) {
  MIROCUP_TRY(const auto address, web::parse_address(options.at, "--at"));
  MIROCUP_TRY(auto listening, server_options(options, address));
  if (!options.base.empty() && (!options.base.starts_with('/') || options.base.ends_with('/')))
    return fail(Errc::input, "--base: a path like /spring is expected");
  if (options.hand_in) {
    MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  }
  system::Disk disk;
  MIROCUP_TRY(auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY_VOID(say_gaps(disk, store));
  system::ProcessSet processes;  // must exist before the first thread starts
  ServedLeague league(disk, std::move(store));
  web::Site site = site_of(league, options.base);
  std::unique_ptr<Portal> portal;
  if (options.hand_in) {
    league.offer_hand_in();
    MIROCUP_TRY(portal, open_portal(disk, options, league));
    site.desk = [&portal = *portal](const web::Request& request, const web::Body& body) {
      return portal.answer(request, body);
    };
  }
  MIROCUP_TRY(const auto server,
              web::SiteServer::open(address, "--at", std::move(site), std::move(listening)));
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
  const auto [command, o] = add_command(
      commands, run_serve, "serve", to_show, "Show the league in browsers, as it is now",
      {"mirocup league serve spring --at 8080",
       "mirocup league serve spring --hand-in --at 0.0.0.0:8443 --tls cert.pem key.pem"});
  command.option("--at [HOST:]PORT", o.at,
                 "Where to listen: [HOST:]PORT, or unix:PATH for a proxy (default: this host only, "
                 "any free port)");
  command.option("--base PATH", o.base,
                 "Path at which a proxy shows the league, as /spring, if the proxy passes it on");
  const system::Option hand_in = command.flag(
      "--hand-in", o.hand_in, "Also take entries from teams that have a token (league token)");
  command.jobs(o.jobs, "checks").needs(hand_in);
  command
      .option("--tls CERT KEY", o.tls,
              "Encrypt connections: files of the certificate and of its key")
      .takes(2, 2);
  command
      .option("--trust-proxy ADDR", o.proxies,
              "Address of a proxy whose requests may name the viewer (X-Forwarded-For, "
              "X-Forwarded-Proto); needs --proxy-secret; may be given several times")
      .takes(1, 1)
      .needs(hand_in);
  command
      .option("--proxy-secret FILE", o.proxy_secret,
              "File with the secret that the proxies of --trust-proxy send in the header "
              "X-Mirocup-Proxy; other programs at the same addresses do not know it")
      .needs(hand_in);
  command
      .option("--team-header NAME", o.team_header,
              "Header in which the proxy names the team of a visitor who signed on at the proxy")
      .needs(hand_in);
}

}  // namespace mirocup::league
