// SPDX-License-Identifier: MIT
//
// Catches a viewer that misses a decision, gets one twice, or gets none when it joins late.

#include "web/live_server.hpp"

#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::web {
namespace {

int times(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(LiveFeed, SendsEveryDecisionOnceToEveryViewer) {
  match::Leg match(test_support::short_setup(3, 20.0));
  auto blue = test_support::ball_hunter();
  auto yellow = test_support::random_team(3);
  LiveFeed feed(match);
  LiveFeed::Viewer early;
  std::string heard = feed.news(early);
  EXPECT_EQ(times(heard, "event: start"), 1);
  EXPECT_EQ(feed.news(early), "") << "nothing has happened since";
  while (!match.is_over()) {
    match.advance(blue, yellow);
    feed.publish(match);
    if (match.tick() % 7 == 0) heard += feed.news(early);  // a slow viewer
  }
  LiveFeed::Viewer late;
  const std::string told_late = feed.news(late);
  feed.close(match);
  heard += feed.news(early);
  EXPECT_EQ(feed.news(early), "") << "it is over";

  const int calls = static_cast<int>(match.decisions().size());
  ASSERT_GT(calls, 2);
  EXPECT_EQ(times(heard, "\"law\":"), calls);
  EXPECT_EQ(times(told_late, "\"law\":"), calls);
  EXPECT_EQ(times(told_late, "event: frame"), 1) << "the latest state, no queue";
  EXPECT_EQ(times(heard, "event: end"), 1);
}

TEST(LiveServer, ParsesAddressesAndRefusesWrongOnes) {
  EXPECT_EQ(parse_address("8080", "--watch")->host, "127.0.0.1")
      << "this host only unless told otherwise";
  EXPECT_EQ(parse_address("8080", "--watch")->port, 8080);
  EXPECT_EQ(parse_address("0.0.0.0:81", "--watch")->host, "0.0.0.0");
  EXPECT_EQ(parse_address("[::1]:82", "--watch")->host, "::1");
  for (const char* wrong : {"", "x", "8080x", "-1", "65536", ":80", "host:"}) {
    EXPECT_FALSE(parse_address(wrong, "--watch")) << wrong;
  }
}

}  // namespace
}  // namespace mirocup::web
