// SPDX-License-Identifier: MIT
//
// Sends any bytes to a site's server with a desk as a proxy would, over a Unix socket, and reads
// what it answers.
#include "tests/security/fuzz/fuzz_target.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tournaments/handin/portal.hpp"
#include "web/site_server.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace {

using namespace mirocup;

struct ServedLeague final : league::PortalLeague {
  league::HandInTerms hand_in_terms(const std::string&, const std::string&) override { return {}; }
  std::optional<std::string> replay_of(const std::string&, const record::Whose&,
                                       const std::string&) override {
    return "replay";
  }
  std::map<std::string, int> booked_entries() override { return {{"alpha", 1}, {"beta", 1}}; }
};

// The desk of a league, with a team that a proxy on this host may name: so inputs reach each of its
// routes. What they hand in is never checked.
league::Portal& desk() {
  static system::Disk disk;
  static const test_support::TemporaryFolder folder;
  static ServedLeague served;
  static const auto portal = [] {
    league::PortalOptions options;
    options.team_header = "x-team";
    options.house = {"striker"};
    options.now = [] { return std::int64_t{1'795'000'000}; };
    const league::Folder place{folder / "."};
    (void)disk.write(place.config(), league::print_league_file({}));
    if (auto book = league::Book::open(disk, place)) (void)book->give("alpha", "library");
    return league::Portal::open(disk, place, served, std::move(options), nullptr);
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

// A Unix socket: whoever connects is the proxy that names teams.
std::string path_of_server() {
  static const test_support::TemporaryFolder folder;
  const std::string path = folder / "socket";
  static const auto server =
      web::SiteServer::open(web::Address{.path = path}, "--at", site(),
                            {.bodies = {.max_upload = system::size_limit::entry}});
  if (!server) {
    std::fprintf(stderr, "%s\n", server.error().what.c_str());
    std::exit(1);
  }
  return path;
}

}  // namespace

MIROCUP_FUZZ_TARGET(http) {
  static const std::string path = path_of_server();
  const int connection = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
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
