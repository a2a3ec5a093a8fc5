// SPDX-License-Identifier: MIT
//
// Catches a slow viewer that does not get the end of a large page, and one that takes nothing and
// keeps a thread.
#include "web/http/connection.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace mirocup::web {
namespace {

struct Ends {
  Ends() { EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0); }
  ~Ends() {
    close(ends[0]);
    close(ends[1]);
  }
  int ends[2] = {-1, -1};
};

// More than a socket holds.
const std::string page(1u << 20, 'p');

// The kernel calls a socket ready for more when three quarters of what it holds are read: here
// after more than six seconds, and a viewer that takes nothing for five is given up.
TEST(Connection, SendsALargePageToASlowViewer) {
  Ends ends;
  std::size_t received = 0;
  std::thread viewer([&] {
    std::string part(25u << 10, ' ');
    ssize_t count = 1;
    for (int i = 0; count > 0; ++i) {
      if (i < 8) std::this_thread::sleep_for(std::chrono::seconds(1));
      count = recv(ends.ends[1], part.data(), part.size(), MSG_WAITALL);
      if (count > 0) received += static_cast<std::size_t>(count);
    }
  });
  std::optional<system::TlsConnection> plain;
  EXPECT_TRUE(Connection(ends.ends[0], plain).send(page));
  shutdown(ends.ends[0], SHUT_WR);
  viewer.join();
  EXPECT_EQ(received, page.size());
}

TEST(Connection, GivesUpAViewerThatTakesNothing) {
  Ends ends;
  std::optional<system::TlsConnection> plain;
  EXPECT_FALSE(Connection(ends.ends[0], plain).send(page));
}

}  // namespace
}  // namespace mirocup::web
