// SPDX-License-Identifier: MIT
#include "server/system/files.hpp"

#include "server/system/descriptor.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mirocup::system {

namespace {

tl::unexpected<Error> problem(const std::string& path, const char* doing) {
  return fail(Errc::unavailable, path + " cannot be " + doing + ": " + std::strerror(errno));
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

// A new name is on disk only once its folder is.
bool sync_folder_of(const std::string& path) {
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) folder = ".";
  const Descriptor fd(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return fd.is_open() && fsync(fd.get()) == 0;
}

// A device or a pipe, /dev/null for one. A file must not take its place.
bool is_special(const std::string& path) {
  struct stat about {};
  return stat(path.c_str(), &about) == 0 && !S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode);
}

Result<void> write_into(const std::string& path, std::string_view bytes) {
  const Descriptor fd(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!fd.is_open() || !write_all(fd.get(), bytes)) return problem(path, "written");
  return {};
}

// Between a file's name and the process that writes it.
constexpr std::string_view unfinished_mark = ".unfinished-";

bool is_unfinished(const std::string& path) {
  const std::size_t mark = path.rfind(unfinished_mark);
  if (mark == std::string::npos) return false;
  const std::string_view writer = std::string_view(path).substr(mark + unfinished_mark.size());
  return !writer.empty() && writer.find_first_not_of("0123456789") == std::string_view::npos;
}

// Empty and locked for as long as it is open: the kernel gives a lock up with the process, so that
// what has none has no writer any more.
int open_unfinished(const std::string& path) {
  while (true) {
    const int fd = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    if (fd < 0) return fd;
    flock(fd, LOCK_EX);  // without locks the file is never taken for abandoned, see below
    struct stat about {};
    const bool is_removed = fstat(fd, &about) == 0 && about.st_nlink == 0;
    if (!is_removed && ftruncate(fd, 0) == 0) return fd;
    close(fd);
    if (!is_removed) return -1;
  }
}

void remove_if_abandoned(const std::string& path) {
  const Descriptor fd(open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW));
  if (fd.is_open() && flock(fd.get(), LOCK_EX | LOCK_NB) == 0) unlink(path.c_str());
}

}  // namespace

Result<std::string> Files::read_from(const std::string& path, std::size_t offset) {
  auto bytes = read(path);
  if (bytes) bytes->erase(0, offset);
  return bytes;
}

Result<std::string> Disk::read(const std::string& path) {
  return read_from(path, 0);
}

Result<std::string> Disk::read_from(const std::string& path, std::size_t offset) {
  const Descriptor fd(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd.is_open()) return problem(path, "read");
  if (offset > 0 && lseek(fd.get(), static_cast<off_t>(offset), SEEK_SET) < 0)
    return problem(path, "read");
  std::string bytes;
  char buffer[65536];
  while (true) {
    const ssize_t n = ::read(fd.get(), buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return problem(path, "read");
    if (n == 0) return bytes;
    bytes.append(buffer, static_cast<std::size_t>(n));
  }
}

Result<void> Disk::write(const std::string& path, std::string_view bytes) {
  if (is_special(path)) return write_into(path, bytes);
  const std::string unfinished = path + std::string(unfinished_mark) + std::to_string(getpid());
  const Descriptor fd(open_unfinished(unfinished));
  if (!fd.is_open()) return problem(path, "written");
  if (!write_all(fd.get(), bytes) || fsync(fd.get()) != 0 ||
      rename(unfinished.c_str(), path.c_str()) != 0 || !sync_folder_of(path)) {
    const auto failed = problem(path, "written");
    unlink(unfinished.c_str());
    return failed;
  }
  return {};
}

Result<void> Disk::remove_unfinished(const std::string& folder) {
  std::error_code code;
  using Walk = std::filesystem::recursive_directory_iterator;
  Walk file(folder, std::filesystem::directory_options::skip_permission_denied, code);
  for (; !code && file != Walk(); file.increment(code)) {
    const std::string path = file->path().string();
    if (is_unfinished(path)) remove_if_abandoned(path);
  }
  if (code) return fail(Errc::unavailable, folder + " cannot be searched: " + code.message());
  return {};
}

Result<void> Disk::append(const std::string& path, std::string_view bytes) {
  const bool is_new = !exists(path);
  const Descriptor fd(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (!fd.is_open() || !write_all(fd.get(), bytes) || fsync(fd.get()) != 0) {
    return problem(path, "written");
  }
  if (is_new && !sync_folder_of(path)) return problem(path, "written");
  return {};
}

Result<void> Disk::truncate(const std::string& path, std::size_t size) {
  const Descriptor fd(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!fd.is_open() || ftruncate(fd.get(), static_cast<off_t>(size)) != 0 || fsync(fd.get()) != 0) {
    return problem(path, "shortened");
  }
  return {};
}

bool Disk::exists(const std::string& path) {
  return access(path.c_str(), F_OK) == 0;
}

Result<void> Disk::make_folder(const std::string& path) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (code) return fail(Errc::unavailable, path + " cannot be made: " + code.message());
  return {};
}

}  // namespace mirocup::system
