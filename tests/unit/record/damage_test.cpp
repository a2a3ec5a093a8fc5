// SPDX-License-Identifier: MIT
//
// A record and its replay with one byte flipped, lost or added, at random places. Catches a byte
// that no digest covers, and a reader that trusts its input. For many more tries:
//   MIROCUP_TRIES=2000 build/unit_record --gtest_filter='Damage.*'
#include "core/base/random.hpp"
#include "core/replay/verification.hpp"
#include "record/match_record.hpp"
#include "tests/support/controllers.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/support/tries.hpp"

#include <gtest/gtest.h>

namespace mirocup::record {
namespace {

using namespace test_support;

constexpr int few = 300;

class Damage : public testing::Test {
 protected:
  void SetUp() override {
    match::Leg match(test_support::short_setup(7, 4.0));
    auto blue = test_support::ball_hunter();
    auto yellow = test_support::random_team(7);
    MatchRecord record;
    record.recording = test_support::played_and_traced(match, blue, yellow);
    ASSERT_TRUE(save(files_, "leg.json", record));
    ASSERT_TRUE(load(files_, "leg.json"));
  }

  std::string bytes_of(const std::string& path) { return *files_.read(path); }

  // The file with one byte changed, missing or doubled; never the file itself.
  std::string damaged(const std::string& bytes) {
    std::string changed = bytes;
    const auto at =
        static_cast<std::size_t>(random_.uniform(0.0, static_cast<double>(bytes.size())));
    const double kind = random_.uniform(0.0, 3.0);
    if (kind < 1.0) {
      changed[at] =
          static_cast<char>(changed[at] ^ (1 << static_cast<int>(random_.uniform(0.0, 8.0))));
    } else if (kind < 2.0) {
      changed.erase(at, 1);
    } else {
      changed.insert(at, 1, changed[at]);
    }
    return changed;
  }

  MemoryFiles files_;
  Random random_{2024};
};

TEST_F(Damage, IsFoundInTheRecord) {
  const std::string whole = bytes_of("leg.json");
  for (int i = 0; i < tries(few); ++i) {
    const std::string changed = damaged(whole);
    ASSERT_TRUE(files_.write("leg.json", changed));
    const auto loaded = load(files_, "leg.json");
    ASSERT_FALSE(loaded) << changed;
    ASSERT_EQ(loaded.error().code, Errc::damaged);
    ASSERT_NE(loaded.error().what.find("leg.json"), std::string::npos) << "the file is named";
  }
}

TEST_F(Damage, IsFoundInTheReplay) {
  const std::string whole = bytes_of("leg.replay.zst");
  for (int i = 0; i < tries(few); ++i) {
    ASSERT_TRUE(files_.write("leg.replay.zst", damaged(whole)));
    const auto loaded = load(files_, "leg.json");
    ASSERT_FALSE(loaded);
    ASSERT_EQ(loaded.error().code, Errc::damaged);
    ASSERT_NE(loaded.error().what.find("leg.replay.zst"), std::string::npos);
  }
}

// A reader that ignores the checksum, as verify does, must not crash on any damage.
TEST_F(Damage, CrashesNoReaderThatIgnoresTheChecksum) {
  const std::string whole = bytes_of("leg.json");
  int readable = 0;
  for (int i = 0; i < tries(few / 5); ++i) {
    ASSERT_TRUE(files_.write("leg.json", damaged(whole)));
    const auto loaded = load(files_, "leg.json", ChecksumPolicy::ignored);
    if (!loaded) continue;
    ++readable;
    (void)replay::verify(loaded->recording);
  }
  EXPECT_GT(readable, 10) << "or this test says nothing";
}

}  // namespace
}  // namespace mirocup::record
