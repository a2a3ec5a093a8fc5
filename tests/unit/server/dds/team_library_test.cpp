// SPDX-License-Identifier: MIT
//
// What mirocup_team_open() says of a wrong call. Catches an errno that is left as it was, so that a
// program tries a wrong call again and again, and a name that waits for a seat that it cannot get.
#include "mirocup/team.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <string>

namespace mirocup::dds {
namespace {

struct OpenAnswer {
  mirocup_connection* connection = nullptr;
  std::string why;
  int error = 0;
};

OpenAnswer opened(const char* name, int domain) {
  mirocup_team_call call{};
  call.size = sizeof call;
  call.team = MIROCUP_BLUE;
  call.match = "unit";
  call.name = name;
  call.domain = domain;
  char why[256] = "";
  errno = 0;
  mirocup_connection* connection = mirocup_team_open(&call, why, sizeof why);
  return {connection, why, errno};
}

TEST(TeamLibrary, SaysThatACallIsWrong) {
  for (const int domain : {-1, 231}) {
    const OpenAnswer answer = opened("mine", domain);
    EXPECT_EQ(answer.connection, nullptr);
    EXPECT_EQ(answer.error, EINVAL) << domain;
    EXPECT_NE(answer.why.find(std::to_string(domain)), std::string::npos) << answer.why;
  }
  for (const std::string& name : {std::string(), std::string(65, 'a')}) {
    const OpenAnswer answer = opened(name.c_str(), 229);
    EXPECT_EQ(answer.connection, nullptr);
    EXPECT_EQ(answer.error, EINVAL) << name;
    EXPECT_EQ(answer.why, "the name of a team has 1 to 64 bytes");
  }
}

TEST(TeamLibrary, OpensOneConnectionAtATime) {
  const OpenAnswer first = opened(std::string(64, 'a').c_str(), 229);
  ASSERT_NE(first.connection, nullptr) << first.why;
  const OpenAnswer second = opened("mine", 229);
  EXPECT_EQ(second.connection, nullptr);
  EXPECT_EQ(second.error, EINVAL);
  EXPECT_EQ(second.why, "this process has a connection in DDS domain 229 already: close it first");
  mirocup_team_close(first.connection);
  const OpenAnswer again = opened("mine", 229);
  EXPECT_NE(again.connection, nullptr) << again.why;
  mirocup_team_close(again.connection);
}

}  // namespace
}  // namespace mirocup::dds
