// SPDX-License-Identifier: MIT
#include "system/file_lock.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace mirocup::system {

namespace {

// For 0.2 s try_acquire() waits for a lock that is about to be free.
constexpr int patience_steps = 20;
constexpr useconds_t patience_step_us = 10'000;

tl::unexpected<Error> cannot_lock(const std::string& path, const std::string& why) {
  return fail(Errc::unavailable, path + " cannot be locked: " + why);
}

// Returns why this file is not to be locked; "" if it may.
std::string objection_to(int fd, const std::string& path) {
  struct stat about {};
  struct stat folder {};
  const std::string parent = std::filesystem::path(path).parent_path().string();
  if (fstat(fd, &about) != 0 || stat(parent.empty() ? "." : parent.c_str(), &folder) != 0)
    return std::strerror(errno);
  if (!S_ISREG(about.st_mode)) return "it is not a regular file";
  if (about.st_nlink > 1) return "it has a second name (a hard link)";
  if (about.st_uid != geteuid() && about.st_uid != folder.st_uid)
    return "it belongs to user " + std::to_string(about.st_uid);
  // Others could hold a lock that they may open.
  if ((about.st_mode & 077) != 0 && fchmod(fd, 0600) != 0) return std::strerror(errno);
  return "";
}

Result<Descriptor> open_lock(const std::string& path, int create) {
  constexpr int flags = O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  Descriptor file(open(path.c_str(), flags | create, 0600));
  if (!file.is_open() && errno == ELOOP) return cannot_lock(path, "it is a symbolic link");
  if (!file.is_open()) return cannot_lock(path, std::strerror(errno));
  if (const std::string why = objection_to(file.get(), path); !why.empty())
    return cannot_lock(path, why);
  return file;
}

bool lock(int fd, int how) {
  while (flock(fd, how) != 0) {
    if (errno != EINTR) return false;
  }
  return true;
}

std::string text_of(const char* path) {
  const Descriptor file(open(path, O_RDONLY | O_CLOEXEC));
  std::array<char, 4096> text;
  const ssize_t size = file.is_open() ? read(file.get(), text.data(), text.size()) : -1;
  return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "";
}

// Returns what tells a process from every other one: its id, which a later process may have again,
// the time at which it started, and the start of the computer. "" if there is no such process.
std::string identity_of(pid_t pid) {
  const std::string id = std::to_string(pid);
  const std::string about = text_of(("/proc/" + id + "/stat").c_str());
  // The name of the program is in parentheses and may hold any bytes; the start time is the 20th
  // word after it.
  const std::size_t name_end = about.rfind(')');
  if (name_end == std::string::npos) return "";
  std::istringstream words(about.substr(name_end + 1));
  std::string start;
  for (int i = 0; i < 20; ++i) words >> start;
  const std::string boot = text_of("/proc/sys/kernel/random/boot_id");
  return words ? id + "\n" + start + "\n" + boot : "";
}

}  // namespace

Result<FileLock> FileLock::acquire(const std::string& path) {
  MIROCUP_TRY(auto file, open_lock(path, O_CREAT));
  if (!lock(file.get(), LOCK_EX)) return cannot_lock(path, std::strerror(errno));
  return FileLock(std::move(file));
}

Result<std::optional<FileLock>> FileLock::try_acquire(const std::string& path) {
  MIROCUP_TRY(auto file, open_lock(path, O_CREAT));
  // A process that was killed while it started a child leaves the lock to the child, until that
  // runs its program.
  bool is_locked = lock(file.get(), LOCK_EX | LOCK_NB);
  for (int i = 0; i < patience_steps && !is_locked && errno == EWOULDBLOCK; ++i) {
    usleep(patience_step_us);
    is_locked = lock(file.get(), LOCK_EX | LOCK_NB);
  }
  if (!is_locked) {
    if (errno == EWOULDBLOCK) return std::nullopt;
    return cannot_lock(path, std::strerror(errno));
  }
  const std::string text = identity_of(getpid());
  if (ftruncate(file.get(), 0) != 0 ||
      ::write(file.get(), text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    return cannot_lock(path, std::strerror(errno));
  }
  return std::optional<FileLock>(FileLock(std::move(file)));
}

Result<bool> FileLock::signal_holder(const std::string& path, std::span<const int> signals) {
  auto file = open_lock(path, 0);
  const bool is_there = faccessat(AT_FDCWD, path.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0;
  if (!file && !is_there && errno == ENOENT) return false;
  if (!file) return tl::unexpected(file.error());
  if (lock(file->get(), LOCK_EX | LOCK_NB)) return false;
  if (errno != EWOULDBLOCK) return cannot_lock(path, std::strerror(errno));

  std::array<char, 256> buffer;
  const ssize_t size = pread(file->get(), buffer.data(), buffer.size(), 0);
  const std::string text(buffer.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
  pid_t pid = 0;
  std::from_chars(text.data(), text.data() + text.size(), pid);
  // The descriptor stands for one process. If the process with that id is the one of the file after
  // the descriptor was opened, the descriptor stands for it.
  const Descriptor process(pid > 0 ? static_cast<int>(syscall(SYS_pidfd_open, pid, 0)) : -1);
  if (!process.is_open() || identity_of(pid) != text) {
    return fail(Errc::unavailable, path +
                                       " is locked, but not by a process of this computer that can "
                                       "be asked to stop; end the process where it was started");
  }
  for (const int signal : signals) {
    if (syscall(SYS_pidfd_send_signal, process.get(), signal, nullptr, 0) != 0)
      return fail(Errc::unavailable, "process " + std::to_string(pid) +
                                         " cannot be asked to stop: " + std::strerror(errno));
  }
  return true;
}

}  // namespace mirocup::system
