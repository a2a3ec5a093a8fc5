// SPDX-License-Identifier: MIT
#include "plugins/host/doorbell.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

using namespace mirocup::plugins;

namespace {

// Sleeps on a word that does not change, so only a wake-up ends it.
struct Sleeper {
  std::atomic<std::uint32_t> word = 1;
  std::atomic<bool> is_awake = false;
  std::thread thread = std::thread([this] {
    wait_while_equal(word, 1, std::chrono::seconds(60));
    is_awake = true;
  });

  ~Sleeper() {
    word = 2;
    wake(word);
    thread.join();
  }
};

// Rings again and again, because a ring before the sleepers sleep wakes none of them. Returns false
// after ten seconds.
bool wakes(const std::function<void()>& ring, std::initializer_list<const Sleeper*> sleepers) {
  const auto is_asleep = [](const Sleeper* sleeper) { return !sleeper->is_awake; };
  for (int i = 0; i < 10'000; ++i) {
    ring();
    if (std::none_of(sleepers.begin(), sleepers.end(), is_asleep)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace

TEST(Doorbell, WakesBothMembersWhenBothHaveAsked) {
  Sleeper blue;
  Sleeper yellow;
  Doorbell bell;
  bell.join();
  bell.join();
  const auto ask_both = [&] {
    bell.ask(blue.word);
    bell.ask(yellow.word);
  };
  EXPECT_TRUE(wakes(ask_both, {&blue, &yellow}));
  EXPECT_EQ(yellow.word, 1u);
}

TEST(Doorbell, WakesASingleMemberAtOnceAlsoIfAnotherHasLeft) {
  for (const bool has_left : {false, true}) {
    Sleeper blue;
    Doorbell bell;
    bell.join();
    if (has_left) {
      bell.join();
      bell.leave();
    }
    EXPECT_TRUE(wakes([&] { bell.ask(blue.word); }, {&blue})) << has_left;
  }
}

TEST(Doorbell, WakesOneMemberAtTheRingIfTheOtherDidNotAsk) {
  Sleeper blue;
  Doorbell bell;
  bell.join();
  bell.join();
  const auto ask_one = [&] {
    bell.ask(blue.word);
    bell.ring();
  };
  EXPECT_TRUE(wakes(ask_one, {&blue}));
}
