// SPDX-License-Identifier: MIT
//
// Where the system allows it, each run of these tests has a host of its own: a network namespace
// with only a loopback interface. So the tests disturb neither each other (a host has ports for ten
// matches) nor a league on this computer, which storms of packets would reach. On other systems
// they run on the computer itself.
#include "tests/programs/dds/own_host.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <net/if.h>
#include <sched.h>
#include <string>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mirocup {
namespace {

// Enters a network namespace of its own. A user who is not root needs a user namespace for it,
// which keeps the user's number.
bool leave_network() {
  if (unshare(CLONE_NEWNET) == 0) return true;
  const std::string user = std::to_string(getuid());
  const std::string group = std::to_string(getgid());
  if (unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) return false;
  std::ofstream("/proc/self/setgroups") << "deny";
  std::ofstream("/proc/self/uid_map") << user + " " + user + " 1\n";
  std::ofstream("/proc/self/gid_map") << group + " " + group + " 1\n";
  return true;
}

bool raise_loopback() {
  const int any = socket(AF_INET, SOCK_DGRAM, 0);
  ifreq loopback{};
  std::strncpy(loopback.ifr_name, "lo", sizeof loopback.ifr_name - 1);
  loopback.ifr_flags = IFF_UP;
  const bool is_up = ioctl(any, SIOCSIFFLAGS, &loopback) == 0;
  close(any);
  return is_up;
}

class OwnHost : public testing::Environment {
 public:
  void SetUp() override {
    const int home = open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC);
    const bool has_left = leave_network();
    is_own_ = has_left && raise_loopback();
    if (has_left && !is_own_) {
      ASSERT_EQ(setns(home, CLONE_NEWNET), 0) << std::strerror(errno);
    }
    close(home);
  }
  bool is_own() const { return is_own_; }

 private:
  bool is_own_ = false;
};

const auto* const own_host = static_cast<OwnHost*>(testing::AddGlobalTestEnvironment(new OwnHost));

}  // namespace

bool is_on_own_host() {
  return own_host->is_own();
}

}  // namespace mirocup
