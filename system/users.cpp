// SPDX-License-Identifier: MIT
#include "system/users.hpp"

#include "system/number_of.hpp"

#include <cerrno>
#include <cstring>
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

Result<FolderWriters> writers_of(const std::string& folder) {
  struct stat about {};
  if (stat(folder.c_str(), &about) != 0)
    return fail(Errc::unavailable, folder + " cannot be read: " + std::strerror(errno));
  if (!S_ISDIR(about.st_mode)) return fail(Errc::input, folder + ": it is no folder");
  const bool others_write = (about.st_mode & (S_IWGRP | S_IWOTH)) != 0;
  return FolderWriters{.owner = about.st_uid,
                       .others_write = others_write,
                       .others_remove = others_write && (about.st_mode & S_ISVTX) == 0};
}

std::optional<uid_t> owner_of(const std::string& path) {
  struct stat about {};
  return lstat(path.c_str(), &about) == 0 ? std::optional(about.st_uid) : std::nullopt;
}

std::optional<uid_t> find_user(const std::string& text) {
  if (const auto number = number_of<uid_t>(text)) return number;
  std::vector<char> memory(max_entry);
  passwd about{};
  passwd* found = nullptr;
  getpwnam_r(text.c_str(), &about, memory.data(), memory.size(), &found);
  return found != nullptr ? std::optional(found->pw_uid) : std::nullopt;
}

}  // namespace mirocup::system
