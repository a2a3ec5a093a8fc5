// SPDX-License-Identifier: MIT
//
// The runner of checks with real checks and small limits. Catches a budget that counts the program
// that is started and not the programs below it, and a file that is begun again and again.
#include "tests/support/is_ok.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tournaments/handin/check_runner.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace mirocup::league {
namespace {

class Checks : public testing::Test {
 protected:
  Checks() {
    sigprocmask(SIG_SETMASK, nullptr, &mask_);
    test_support::run({test_support::program("mirocup"), "league", "init", folder_.path, "--team",
                       "one=house:chaser", "--team", "two=house:keeper", "--half", "20"});
    TokenList list;
    alpha_ = list.add("alpha", utc_text(now_), "");
    beta_ = list.add("beta", utc_text(now_), "");
    EXPECT_TRUE(write_tokens(disk_, folder_, list));
    PortalOptions options;
    options.now = [this] { return now_; };
    options.legs = [](Viewer, const std::string&) { return std::vector<OwnLeg>(); };
    options.statistics = [](const std::string&) { return std::string(); };
    options.why_not = [](const std::string&, const std::string&) { return std::string(); };
    options.friendlies = {
        .teams = [] { return std::map<std::string, int>(); },
        .neighbours = [](const auto&) { return std::vector<std::string>(); },
        .house = {},
        .replay = [](const auto&, const auto&) { return std::optional<std::string>(); }};
    auto portal = Portal::open(disk_, folder_, std::move(options), nullptr);
    EXPECT_TRUE(test_support::is_ok(portal));
    portal_ = std::move(*portal);
  }
  ~Checks() override { sigprocmask(SIG_SETMASK, &mask_, nullptr); }

  void hand_in(const std::string& token, const std::string& name, const std::string& bytes) {
    web::Request request{.method = "PUT", .path = "/api/v1/entries", .address = "10.0.0.1"};
    request.headers.emplace("host", "league.example");
    request.headers.emplace("authorization", "Bearer " + token);
    request.query.emplace("name", name);
    const auto reply =
        portal_->answer(request, [&](const auto& take) { return take(std::string_view(bytes)); });
    ASSERT_TRUE(reply && reply->status == 202) << reply->bytes;
  }

  Json state_of(const std::string& token) {
    web::Request request{.method = "GET", .path = "/api/v1/entries/1", .address = "10.0.0.1"};
    request.headers.emplace("host", "league.example");
    request.headers.emplace("authorization", "Bearer " + token);
    const auto reply = portal_->answer(request, [](const auto&) { return true; });
    return Json::parse(reply->bytes, nullptr, false);
  }

  int told(const std::string& words) const {
    int count = 0;
    for (const std::string& line : lines_) count += line.find(words) != std::string::npos ? 1 : 0;
    return count;
  }

  sigset_t mask_{};
  test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  Folder folder_{temporary_ / "l"};
  std::int64_t now_ = 1'795'000'000;  // s since 1970
  std::string alpha_, beta_;
  std::vector<std::string> lines_;  // for the host
  std::unique_ptr<Portal> portal_;
};

const std::string loops = "hostile/ctor_loop.so";  // until it has used 4 s of processor time

TEST_F(Checks, AreBegunTwiceIfTheyUseUpTheirProcessorTime) {
  system::ProcessSet processes;
  CheckRunner runner(disk_, folder_, *portal_, processes, 1,
                     [this](const std::string& line) { lines_.push_back(line); },
                     {.processor = 1.0});
  hand_in(alpha_, "team.so", test_support::read_file(test_support::program(loops)));
  while (told("alpha: entry 1: its check") < 3 && state_of(alpha_)["state"] != "refused") {
    ASSERT_TRUE(runner.step());
  }
  EXPECT_EQ(told("its check was stopped after 1 s of processor time"), 2);
  EXPECT_EQ(state_of(alpha_)["state"], "refused");
  EXPECT_NE(state_of(alpha_)["message"].get<std::string>().find("and did so twice"),
            std::string::npos);
  EXPECT_EQ(processes.running(), 0u);
}

TEST_F(Checks, GiveWayToAnotherTeamAndAreAnsweredAfterwards) {
  system::ProcessSet processes;
  CheckRunner runner(disk_, folder_, *portal_, processes, 1,
                     [this](const std::string& line) { lines_.push_back(line); });
  hand_in(alpha_, "team.so", test_support::read_file(test_support::program(loops)));
  ASSERT_TRUE(runner.step());
  hand_in(beta_, "team.so", "no library");
  while (state_of(alpha_)["state"] != "refused") ASSERT_TRUE(runner.step());
  EXPECT_EQ(told("alpha: entry 1: its check gives way"), 1);
  EXPECT_EQ(state_of(beta_)["state"], "refused");
  EXPECT_NE(state_of(alpha_)["message"].get<std::string>().find("start_timeout"), std::string::npos)
      << "the same answer as if nobody had waited: " << state_of(alpha_).dump();
}

}  // namespace
}  // namespace mirocup::league
