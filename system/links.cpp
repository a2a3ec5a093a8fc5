// SPDX-License-Identifier: MIT
#include "system/links.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <set>
#include <string_view>
#include <sys/stat.h>

namespace mirocup::system {

namespace {

std::mutex roots_mutex;
std::set<std::string, std::less<>> roots;  // without slashes at their ends

std::string_view without_last_slashes(std::string_view path) {
  return path.substr(0, path.find_last_not_of('/') + 1);
}

// Returns the size of the longest root above the path; 0: there is none.
std::size_t root_of(const std::string& path) {
  const std::lock_guard lock(roots_mutex);
  std::string_view above = without_last_slashes(path);
  while (above.find('/') != std::string_view::npos) {
    above = without_last_slashes(above.substr(0, above.rfind('/')));
    if (roots.contains(above)) return above.size();
  }
  return 0;
}

}  // namespace

void follow_no_links_below(const std::string& folder) {
  namespace fs = std::filesystem;
  if (folder.empty()) return;
  std::error_code code;
  const std::lock_guard lock(roots_mutex);
  for (const fs::path& path : {fs::path(folder), fs::absolute(folder, code).lexically_normal()})
    roots.emplace(without_last_slashes(path.native()));
  roots.erase("");
}

Result<Way> way_to(const std::string& path, const char* done) {
  constexpr int flags = O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
  std::size_t end = root_of(path);
  if (end == 0) return Way{.path = path};
  Descriptor folder(open(path.substr(0, end).c_str(), flags & ~O_NOFOLLOW));
  while (folder.is_open()) {
    const std::size_t begin = path.find_first_not_of('/', end);
    end = std::min(path.find('/', begin), path.size());
    const std::string name = path.substr(begin, end - begin);
    if (name == "..") return fail(Errc::input, path + ": it may not have \"..\" in it");
    struct stat about {};
    if (fstatat(folder.get(), name.c_str(), &about, AT_SYMLINK_NOFOLLOW) == 0 &&
        S_ISLNK(about.st_mode))
      return fail(Errc::input, path.substr(0, end) +
                                   ": it is a symbolic link, which is not followed here; put the "
                                   "file or folder itself in its place");
    if (path.find_first_not_of('/', end) == std::string::npos) {
      std::string opened = "/proc/self/fd/" + std::to_string(folder.get()) + "/" + name;
      return Way{.path = std::move(opened), .folder = std::move(folder)};
    }
    folder.reset(openat(folder.get(), name.c_str(), flags));
  }
  return fail(Errc::unavailable, path + " cannot be " + done + ": " + std::strerror(errno));
}

}  // namespace mirocup::system
