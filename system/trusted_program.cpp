// SPDX-License-Identifier: MIT
#include "system/trusted_program.hpp"

#include "system/users.hpp"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace mirocup::system {

namespace {

namespace fs = std::filesystem;

constexpr int max_links = 40;  // as many as the kernel follows

bool others_write(const struct statx& about) {
  return !S_ISLNK(about.stx_mode) && (about.stx_mode & (S_IWGRP | S_IWOTH)) != 0;
}

// True if others make files in the folder, but rename and remove their own ones only.
bool is_shared_folder(const struct statx& about) {
  return S_ISDIR(about.stx_mode) && others_write(about) && (about.stx_mode & S_ISVTX) != 0 &&
         about.stx_uid == 0;
}

// Returns why a stranger could have put it there; "" if none could.
std::string objection(const struct statx& about, bool is_in_shared_folder) {
  const bool is_own = about.stx_uid == this_user();
  if (!is_own && (about.stx_uid != 0 || is_in_shared_folder))
    return "belongs to " + name_of_user(about.stx_uid);
  if (others_write(about) && !is_shared_folder(about))
    return "may be written by others than its owner";
  if (is_in_shared_folder && !S_ISDIR(about.stx_mode) && about.stx_nlink > 1)
    return "has a second name (a hard link) in a folder that all users share";
  if (is_in_shared_folder && (about.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0)
    return "is mounted in a folder that all users share";
  return "";
}

// Adds the names of a path in front of those that are left, of which the next one is the last.
void put_in_front(std::vector<std::string>& left, const fs::path& path) {
  const std::vector<std::string> names(path.begin(), path.end());
  left.insert(left.end(), names.rbegin(), names.rend());
}

tl::unexpected<Error> cannot_be_read(const fs::path& path, const std::error_code& why) {
  return fail(Errc::unavailable, path.string() + " cannot be read: " + why.message());
}

}  // namespace

// Names are looked at by their whole path: nobody else can change the part that was looked at.
Result<std::string> trusted_path(const std::string& path) {
  std::error_code failed;
  std::vector<std::string> left;
  put_in_front(left, fs::absolute(path, failed));
  if (failed) return cannot_be_read(path, failed);
  fs::path real;
  bool is_in_shared_folder = false;
  for (int links = 0; !left.empty();) {
    const std::string name = left.back();
    left.pop_back();
    if (name.empty() || name == ".") continue;
    const bool is_known = name == ".." || name == "/";  // looked at before: not in the folder
    const fs::path next = name == ".." ? real.parent_path() : real / name;
    struct statx about {};
    if (statx(AT_FDCWD, next.c_str(), AT_SYMLINK_NOFOLLOW, STATX_BASIC_STATS, &about) != 0)
      return cannot_be_read(next, {errno, std::generic_category()});
    if (const auto why = objection(about, is_in_shared_folder && !is_known); !why.empty())
      return fail(Errc::input, next.string() + " " + why);
    if (S_ISLNK(about.stx_mode)) {
      const fs::path target = fs::read_symlink(next, failed);
      if (failed) return cannot_be_read(next, failed);
      if (++links > max_links) return fail(Errc::input, path + " has too many links");
      put_in_front(left, target);
      continue;
    }
    is_in_shared_folder = is_shared_folder(about);
    real = next;
  }
  return real.string();
}

Result<std::string> trusted_program(const std::string& path, const std::string& name) {
  auto real = trusted_path(path);
  if (!real) return real;
  if (fs::path(*real).filename() != name)
    return fail(Errc::input, path + " leads to " + *real + ", which is not called " + name);
  std::error_code none;
  if (!fs::is_regular_file(*real, none) ||
      faccessat(AT_FDCWD, real->c_str(), X_OK, AT_EACCESS) != 0)
    return fail(Errc::input, *real + " is not a program that this user may run");
  return real;
}

}  // namespace mirocup::system
