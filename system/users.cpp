// SPDX-License-Identifier: MIT
#include "system/users.hpp"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace mirocup::system {

namespace {

constexpr std::size_t max_entry = 64u << 10;  // bytes of a user's line

}  // namespace

uid_t this_user() {
  return geteuid();
}

std::string name_of_user(uid_t user) {
  std::vector<char> memory(max_entry);
  passwd about{};
  passwd* found = nullptr;
  getpwuid_r(user, &about, memory.data(), memory.size(), &found);
  return found != nullptr ? std::string(found->pw_name) : "user " + std::to_string(user);
}

std::optional<uid_t> owner_of(const std::string& path) {
  struct stat about {};
  return lstat(path.c_str(), &about) == 0 ? std::optional(about.st_uid) : std::nullopt;
}

}  // namespace mirocup::system
