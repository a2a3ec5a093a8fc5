// SPDX-License-Identifier: MIT
//
// Sends any bytes to a site's server with a desk as a browser would, over a connection of this
// host, and reads what it answers. Run it where no other program listens: run.sh
// does so in a network of its own.
#include "tests/security/fuzz/fuzz_target.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tournaments/handin/portal.hpp"
#include "web/site_server.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

namespace {

using namespace mirocup;

// The desk of a league, with a team that a proxy on this host may name: so inputs reach each of its
// routes. What they hand in is never checked.
league::Portal& desk() {
  static system::Disk disk;
  static const test_support::TemporaryFolder folder;
  static const auto portal = [] {
    league::PortalOptions options;
    options.proxy = {.addresses = {"127.0.0.1"}, .team_header = "x-team"};
    options.why_not = [](const std::string&, const std::string&) { return std::string(); };
    options.legs = [](const std::string&) { return std::vector<league::OwnLeg>(); };
    options.statistics = [](const std::string&) { return std::string(); };
    options.friendlies = {
        .teams =
            [] {
              return std::map<std::string, int>{{"alpha", 1}, {"beta", 1}};
            },
        .neighbours = [](const std::string&) { return std::vector<std::string>(); },
        .house = {"striker"},
        .replay = [](const std::string&,
                     const auto&) { return std::optional<std::string>("replay"); }};
    options.now = [] { return std::int64_t{1'795'000'000}; };
    const league::Folder place{folder / "."};
    (void)league::add_entry(disk, place, "alpha", 1, "library");
    return league::Portal::open(disk, place, std::move(options), nullptr);
  }();
  if (!portal) {
    std::fprintf(stderr, "%s\n", portal.error().what.c_str());
    std::exit(1);
  }
  return **portal;
}

// A site of two pages and a desk. It has news all the time, so that the server notices who is gone.
web::Site site() {
  return {.page = [](const std::string& path) -> std::optional<web::Page> {
            if (path != "/" && path != "/table.json") return std::nullopt;
            return web::Page{"text/html", "default-src 'none'", "page " + path};
          },
          .news = [](std::uint64_t& seen) { return "data: " + std::to_string(++seen) + "\n\n"; },
          .match = [](const std::string&) { return std::nullopt; },
          .desk = [](const web::Request& request,
                     const web::Body& body) { return desk().answer(request, body); }};
}

int port_of_server() {
  static const auto server = web::SiteServer::open(
      web::Address{}, "--at", site(), web::SiteLimits{.max_upload = system::size_limit::entry});
  if (!server) {
    std::fprintf(stderr, "%s\n", server.error().what.c_str());
    std::exit(1);
  }
  const std::string url = (*server)->url();
  return std::atoi(url.c_str() + url.rfind(':') + 1);
}

}  // namespace

MIROCUP_FUZZ_TARGET(http) {
  static const int port = port_of_server();
  const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  // No waiting for ports of ended connections: the connection is reset when it is closed.
  const linger reset{.l_onoff = 1, .l_linger = 0};
  setsockopt(connection, SOL_SOCKET, SO_LINGER, &reset, sizeof reset);
  if (connect(connection, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    // libFuzzer's timer interrupts calls.
    if (errno != EINTR) {
      std::perror("connect");
      std::abort();
    }
    close(connection);
    return;
  }
  std::size_t sent = 0;
  while (sent < size) {
    const ssize_t count = send(connection, data + sent, size - sent, MSG_NOSIGNAL);
    if (count <= 0) break;
    sent += static_cast<std::size_t>(count);
  }
  shutdown(connection, SHUT_WR);
  char answer[4096];
  std::size_t received = 0;
  // Events have no end, so not all of them are read.
  while (received < 2 * sizeof answer) {
    const ssize_t count = recv(connection, answer, sizeof answer, 0);
    if (count <= 0) break;
    received += static_cast<std::size_t>(count);
    if (std::string_view(answer, static_cast<std::size_t>(count)).find("data: ") !=
        std::string_view::npos) {
      break;
    }
  }
  close(connection);
}
