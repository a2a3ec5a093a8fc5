// SPDX-License-Identifier: MIT
//
// Catches strangers that keep others out by streams and half requests, and a rule against them that
// hits the viewers of a lecture hall, who share an address and were there before.
#include "web/http/entrance.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::web {
namespace {

using namespace std::chrono_literals;

const Instant begin{};

class Crowd : public testing::Test {
 protected:
  // Returns the number of the connection; nothing if it was refused.
  std::optional<int> come(const std::string& address, Instant now = begin) {
    const int connection = next_++;
    if (entrance_.arrive(connection, address, now) == Stage::leaving) return std::nullopt;
    return connection;
  }

  bool stream(const std::string& address, bool is_for_known = false) {
    const auto connection = come(address);
    if (!connection) return false;
    entrance_.set_stage(*connection, Stage::answering, begin);
    if (entrance_.begin_stream(*connection, is_for_known, begin)) return true;
    entrance_.leave(*connection);
    return false;
  }

  // Ends those that have to, as the server does.
  std::size_t end(Instant now) {
    const auto ending = entrance_.to_end(now);
    for (const int connection : ending) entrance_.leave(connection);
    return ending.size();
  }

  Entrance entrance_{EntranceLimits{.capacity = 256}};
  int next_ = 1;
};

TEST_F(Crowd, LetsEverybodyInWhileHalfIsFree) {
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(stream("10.0.0.1"));
  EXPECT_FALSE(entrance_.is_crowded());
  EXPECT_EQ(entrance_.streams(), 100);
}

TEST_F(Crowd, KeepsTheHallAndMakesStrangersWait) {
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(stream("hall"));
  ASSERT_TRUE(stream("team", true));
  int streams = 0;
  for (int i = 0; i < 200; ++i) streams += stream("attacker" + std::to_string(i % 4)) ? 1 : 0;
  EXPECT_EQ(streams, 128 - 31) << "then it is crowded, and they have many";
  for (int i = 0; i < 600; ++i) {
    const auto page = come("attacker" + std::to_string(i % 4));
    if (page && i % 3 > 0) entrance_.set_stage(*page, Stage::answering, begin);
  }
  EXPECT_LE(entrance_.present(), 256);
  // The hall is an address with many streams, too: it gets pages one after the other.
  const auto page = come("hall");
  ASSERT_TRUE(page);
  entrance_.set_stage(*page, Stage::answering, begin);
  entrance_.leave(*page);
  EXPECT_FALSE(stream("hall")) << "and no further stream";
  EXPECT_TRUE(stream("team", true));
  EXPECT_TRUE(come("somebody"));
  EXPECT_EQ(entrance_.streams(), 129) << "nobody who was there before has lost a stream";
}

TEST_F(Crowd, LetsThoseInWhoWaitedWhenOthersGo) {
  for (int i = 0; i < 129; ++i) ASSERT_TRUE(come("a" + std::to_string(i)));
  std::vector<int> inside;
  for (int i = 0; i < 36; ++i) {
    inside.push_back(*come("b", begin + 1ms * i));
    if (i < 32) entrance_.set_stage(inside.back(), Stage::answering, begin + 1ms * i);
  }
  EXPECT_TRUE(entrance_.let_in(begin + 40ms).empty());
  EXPECT_TRUE(entrance_.has_entered(inside[31]));
  EXPECT_FALSE(entrance_.has_entered(inside[32])) << "it is the 33rd of its address";
  for (int i = 0; i < 29; ++i) entrance_.leave(inside[static_cast<std::size_t>(i)]);
  EXPECT_EQ(entrance_.let_in(begin + 50ms), std::vector{inside[32]});
}

// Half requests of a hall, more at once than the server has places, and each that ends comes again.
// Catches a limit for each address that sends a neighbour away, who has the right token.
TEST_F(Crowd, LetsTheOwnOldestHalfRequestGiveWayAndNoNeighbour) {
  Instant now = begin;
  for (const int count : {129, 300, 600}) {
    for (int i = 0; i < count; ++i) EXPECT_TRUE(come("hall", now += 1ms)) << i;
    for (int i = 0; i < 20; ++i) {
      const auto neighbour = come("hall", now += 1ms);
      ASSERT_TRUE(neighbour);
      EXPECT_TRUE(entrance_.has_entered(*neighbour));
      for (int k = 0; k < 31; ++k) ASSERT_TRUE(come("hall", now += 1ms));
      const auto ending = entrance_.to_end(now);
      EXPECT_EQ(std::count(ending.begin(), ending.end(), *neighbour), 0);
      for (const int connection : ending) entrance_.leave(connection);
      entrance_.leave(*neighbour);  // it has its answer
    }
    EXPECT_TRUE(come("elsewhere", now));
    EXPECT_LE(entrance_.present(), 256);
  }
}

// The same with few half requests, in a crowd of streams that others have made.
TEST_F(Crowd, LetsTheOwnHalfRequestsGiveWayWhoeverMakesTheCrowd) {
  for (int i = 0; i < 128; ++i) ASSERT_TRUE(stream("a" + std::to_string(i)));
  for (int i = 0; i < 9; ++i) stream("hall", true);
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(come("hall", begin + 1ms * i));
  const auto neighbour = come("hall", begin + 200ms);
  ASSERT_TRUE(neighbour);
  EXPECT_TRUE(entrance_.has_entered(*neighbour));
  EXPECT_EQ(entrance_.present(), 128 + 9 + 32) << "and the hall takes no more than that";
}

// Catches slow readers of an address that hold all answers which its neighbours may get.
TEST_F(Crowd, LetsTheOwnSlowAnswerGiveWay) {
  for (int i = 0; i < 140; ++i)
    entrance_.set_stage(*come("hall"), Stage::answering, begin + 1ms * i);
  const auto early = come("hall", begin + 1s);
  ASSERT_TRUE(early);
  EXPECT_FALSE(entrance_.has_entered(*early)) << "answers of the last five seconds stay";
  const auto later = come("hall", begin + 6s);
  ASSERT_TRUE(later);
  EXPECT_TRUE(entrance_.has_entered(*later));
  EXPECT_EQ(entrance_.to_end(begin + 5s + 900ms), std::vector{1});
}

TEST_F(Crowd, EndsHalfRequestsSoonerWhenItIsCrowded) {
  for (int i = 0; i < 128; ++i) ASSERT_TRUE(come("a" + std::to_string(i)));
  EXPECT_EQ(end(begin + 9s), 0u);
  ASSERT_TRUE(come("b", begin + 9s));
  EXPECT_EQ(end(begin + 9s), 128u);
  EXPECT_EQ(end(begin + 18s), 0u);
  EXPECT_EQ(end(begin + 20s), 1u);
}

TEST_F(Crowd, LetsTheOldestHalfRequestGiveWay) {
  for (int i = 0; i < 256; ++i)
    ASSERT_TRUE(come("a" + std::to_string(i), begin + 1ms * (i == 7 ? -1 : i)));
  ASSERT_TRUE(come("b", begin + 1s));
  EXPECT_EQ(entrance_.to_end(begin + 1s), std::vector{8});
  // Streams and uploads do not give way, and so nobody else enters.
  for (int i = 1; i <= 257; ++i)
    if (i != 8) entrance_.set_stage(i, Stage::uploading, begin);
  EXPECT_FALSE(come("c", begin + 100s));
}

TEST_F(Crowd, KeepsPlacesForPagesWhateverStreams) {
  int streams = 0;
  for (int i = 0; i < 500; ++i) streams += stream("a" + std::to_string(i), true) ? 1 : 0;
  EXPECT_EQ(streams, 192);
  EXPECT_TRUE(come("b"));
}

TEST_F(Crowd, CountsAConnectionOfAProxyForItsViewer) {
  for (int i = 0; i < 129; ++i) ASSERT_TRUE(come("a" + std::to_string(i)));
  for (int i = 0; i < 100; ++i) {
    const auto connection = come("proxy");
    ASSERT_TRUE(connection);
    entrance_.name(*connection, "viewer" + std::to_string(i));
    entrance_.set_stage(*connection, Stage::answering, begin);
  }
  EXPECT_EQ(*come("proxy"), 230);
  EXPECT_TRUE(entrance_.has_entered(230));
}

TEST(ConnectionCapacity, IsAtMost256ForEachProcessor) {
  EXPECT_GE(connection_capacity(), 64);
  EXPECT_LE(connection_capacity(), 1024);
}

}  // namespace
}  // namespace mirocup::web
