// SPDX-License-Identifier: MIT
#include "system/files.hpp"

#include "system/links.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mirocup::system {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> problem(const std::string& path, const char* doing) {
  const bool is_full = errno == ENOSPC || errno == EDQUOT;
  return fail(is_full ? Errc::no_room : Errc::unavailable,
              path + " cannot be " + doing + ": " + std::strerror(errno));
}

tl::unexpected<Error> wrong(const std::string& path, const std::string& why) {
  return fail(Errc::input, path + ": " + why);
}

std::int64_t ns_of(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::string size_text(std::uint64_t bytes) {
  return bytes % (1u << 20) == 0 ? std::to_string(bytes >> 20) + " MiB"
                                 : std::to_string(bytes) + " bytes";
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

// A new name is on disk only after its folder has been flushed.
bool sync_folder_of(const std::string& path) {
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  const Descriptor fd(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return fd.is_open() && fsync(fd.get()) == 0;
}

// True for /dev/stdout and /proc/self/fd/1, for example: links of the system to something that is
// open, which may be a regular file.
bool is_link_of_the_system(const std::string& path, const struct stat& name) {
  if (!S_ISLNK(name.st_mode)) return false;
  std::error_code code;
  const std::string folder = fs::canonical(fs::absolute(path).parent_path(), code).string() + "/";
  return !code && (folder == "/dev/" || folder.rfind("/proc/", 0) == 0);
}

Result<void> write_into(const std::string& path, std::string_view bytes) {
  const Descriptor fd(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!fd.is_open() || !write_all(fd.get(), bytes)) return problem(path, "written");
  return {};
}

// Opens a regular file for writing, and no link; negative on failure, with errno.
Descriptor open_for_writing(const std::string& path, int flags) {
  constexpr int always = O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  Descriptor fd(open(path.c_str(), always | flags, 0644));
  struct stat about {};
  if (fd.is_open() && fstat(fd.get(), &about) == 0 && !S_ISREG(about.st_mode)) {
    fd.reset();
    errno = EINVAL;
  }
  return fd;
}

// The name of a temporary file is the file's name, this mark and random digits.
constexpr std::string_view unfinished_mark = ".unfinished-";
constexpr std::size_t random_digits = 32;

struct Unfinished {
  std::string path;
  Descriptor descriptor{};  // closed on failure, with errno
};

// Makes a new temporary file and locks it. The kernel releases the lock when the process ends, so a
// temporary file without a lock has no writer any more. The lock is not waited for: if another user
// is quick enough to take it, the file is written without it, as on a disk without locks.
Unfinished make_unfinished(const std::string& path, mode_t mode) {
  constexpr int tries = 8;
  for (int i = 0; i < tries; ++i) {
    const std::string name = hexadecimal(random_bytes(random_digits / 2));
    Unfinished made{.path = path + std::string(unfinished_mark) + name};
    made.descriptor.reset(
        open(made.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
    if (!made.descriptor.is_open() && errno == EEXIST) continue;
    if (!made.descriptor.is_open()) return made;
    const bool is_locked = flock(made.descriptor.get(), LOCK_EX | LOCK_NB) == 0;
    // remove_unfinished() may have been quicker.
    struct stat about {};
    const bool is_there = fstat(made.descriptor.get(), &about) == 0 && about.st_nlink > 0;
    if (is_there && (is_locked || errno != EWOULDBLOCK || i + 1 == tries)) return made;
    unlink(made.path.c_str());
  }
  return Unfinished{};
}

void remove_if_abandoned(const std::string& path) {
  const auto way = way_to(path, "removed");
  if (!way) return;
  const Descriptor fd = open_for_writing(way->path, 0);
  if (fd.is_open() && flock(fd.get(), LOCK_EX | LOCK_NB) == 0) unlink(way->path.c_str());
}

}  // namespace

bool is_written_in_place(const std::string& path) {
  struct stat name {};
  struct stat target {};
  if (lstat(path.c_str(), &name) != 0 || stat(path.c_str(), &target) != 0) return false;
  const bool is_trusted = name.st_uid == 0 || name.st_uid == geteuid();
  if (!is_trusted || S_ISDIR(target.st_mode)) return false;
  // A link to a disk or to a pipe may have come with a stranger's folder.
  const bool is_no_file =
      S_ISLNK(name.st_mode) ? S_ISCHR(target.st_mode) : !S_ISREG(target.st_mode);
  return is_no_file || is_link_of_the_system(path, name);
}

bool is_unfinished(const std::string& path) {
  const std::size_t mark = path.rfind(unfinished_mark);
  if (mark == std::string::npos) return false;
  const std::string_view end = std::string_view(path).substr(mark + unfinished_mark.size());
  return end.size() == random_digits &&
         end.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Result<OpenFile> open_file(const std::string& path, const ReadOptions& options) {
  const int links = options.links == Links::refused ? O_NOFOLLOW : 0;
  // A league.json may name a library beside the league's folder.
  const bool is_free = links == 0 || path.find("/../") != std::string::npos;
  MIROCUP_TRY(const auto way, is_free ? Way{.path = path} : way_to(path, "read"));
  OpenFile file{.path = path, .options = options};
  file.descriptor.reset(
      open(way.path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | links));
  if (!file.descriptor.is_open()) {
    if (errno == ELOOP && links != 0)
      return wrong(path, "it is a symbolic link; name the file itself");
    if (errno == ENXIO) return wrong(path, "it is not a regular file");  // a socket
    return problem(path, "read");
  }
  struct stat about {};
  if (fstat(file.descriptor.get(), &about) != 0) return problem(path, "read");
  if (S_ISDIR(about.st_mode)) return wrong(path, "it is a folder and not a regular file");
  if (!S_ISREG(about.st_mode)) return wrong(path, "it is not a regular file");
  file.size = static_cast<std::uint64_t>(about.st_size);
  if (file.size > options.max_size)
    return wrong(path, "it is larger than " + size_text(options.max_size) +
                           std::string(options.if_too_large));
  file.modified = ns_of(about.st_mtim);
  return file;
}

Result<Descriptor> sealed_copy(std::string_view bytes) {
  constexpr unsigned executable = 0x10;  // MFD_EXEC, which kernels before 6.3 do not know
  constexpr unsigned flags = MFD_CLOEXEC | MFD_ALLOW_SEALING;
  constexpr int seals = F_SEAL_SEAL | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE;
  Descriptor file(memfd_create("mirocup", flags | executable));
  if (!file.is_open() && errno == EINVAL) file.reset(memfd_create("mirocup", flags));
  if (!file.is_open() || !write_all(file.get(), bytes) ||
      fcntl(file.get(), F_ADD_SEALS, seals) != 0)
    return fail(Errc::unavailable, std::string("no copy of it can be made: ") + strerror(errno));
  return file;
}

Result<std::string> read_file(const OpenFile& file, std::uint64_t offset) {
  std::string bytes(file.size - std::min(offset, file.size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = pread(file.descriptor.get(), bytes.data() + done, bytes.size() - done,
                            static_cast<off_t>(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return problem(file.path, "read");
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  if (file.options.growth == Growth::ignored) {
    bytes.resize(done);
    return bytes;
  }
  struct stat now {};
  if (fstat(file.descriptor.get(), &now) != 0) return problem(file.path, "read");
  if (done < bytes.size() || static_cast<std::uint64_t>(now.st_size) != file.size ||
      ns_of(now.st_mtim) != file.modified) {
    return fail(Errc::unavailable, file.path + " was changed while it was read; try again");
  }
  return bytes;
}

Result<IncomingFile> IncomingFile::begin(const std::string& path) {
  IncomingFile file;
  MIROCUP_TRY(const auto way, way_to(path, "written"));
  Unfinished made = make_unfinished(way.path, 0600);
  if (!made.descriptor.is_open()) return problem(path, "written");
  file.path_ = path + made.path.substr(way.path.size());
  file.descriptor_ = std::move(made.descriptor);
  return file;
}

IncomingFile::~IncomingFile() {
  const auto way = way_to(path_, "removed");
  if (way && descriptor_.is_open() && !path_.empty()) unlink(way->path.c_str());
}

Result<void> IncomingFile::add(std::string_view bytes) {
  if (!write_all(descriptor_.get(), bytes)) return problem(path_, "written");
  size_ += bytes.size();
  digest_.add(bytes);
  return {};
}

Result<std::string> IncomingFile::finish() {
  if (fsync(descriptor_.get()) != 0) return problem(path_, "written");
  return digest_.digits();
}

Result<void> IncomingFile::keep(const std::string& path) {
  MIROCUP_TRY(const auto from, way_to(path_, "written"));
  MIROCUP_TRY(const auto to, way_to(path, "written"));
  if (rename(from.path.c_str(), to.path.c_str()) != 0 || !sync_folder_of(to.path))
    return problem(path, "written");
  path_.clear();
  return {};
}

Result<std::string> Files::read_from(const std::string& path, std::size_t offset,
                                     const ReadOptions& options) {
  auto bytes = read(path, options);
  if (bytes) bytes->erase(0, offset);
  return bytes;
}

Result<std::optional<std::string>> Files::read_if_there(const std::string& path,
                                                        const ReadOptions& options,
                                                        std::size_t offset) {
  auto bytes = read_from(path, offset, options);
  if (bytes) return std::move(*bytes);
  if (!exists(path)) return std::nullopt;
  const Error& error = bytes.error();
  return fail(error.code == Errc::input ? Errc::damaged : error.code, error.what);
}

Result<void> Files::update(const std::string& path, std::string_view bytes) {
  const auto there = read(path, {.max_size = bytes.size()});
  return there && *there == bytes ? Result<void>() : write(path, bytes);
}

Result<std::vector<std::string>> Files::names_if_there(const std::string& folder) {
  auto names = names_in(folder);
  if (names || exists(folder)) return names;
  return std::vector<std::string>{};
}

Result<std::string> Disk::read(const std::string& path, const ReadOptions& options) {
  return read_from(path, 0, options);
}

Result<std::string> Disk::read_from(const std::string& path, std::size_t offset,
                                    const ReadOptions& options) {
  MIROCUP_TRY(const auto file, open_file(path, options));
  return read_file(file, offset);
}

Result<void> Disk::write(const std::string& path, std::string_view bytes, Readers readers) {
  MIROCUP_TRY(const auto way, way_to(path, "written"));
  if (!way.folder.is_open() && is_written_in_place(path)) return write_into(path, bytes);
  const Unfinished made = make_unfinished(way.path, readers == Readers::owner ? 0600 : 0644);
  if (!made.descriptor.is_open()) return problem(path, "written");
  if (!write_all(made.descriptor.get(), bytes) || fsync(made.descriptor.get()) != 0 ||
      rename(made.path.c_str(), way.path.c_str()) != 0 || !sync_folder_of(way.path)) {
    const auto failed = problem(path, "written");
    unlink(made.path.c_str());
    return failed;
  }
  return {};
}

Result<void> Disk::remove_unfinished(const std::string& folder) {
  MIROCUP_TRY_VOID(way_to(folder, "searched"));
  std::error_code code;
  using Walk = fs::recursive_directory_iterator;
  Walk file(folder, fs::directory_options::skip_permission_denied, code);
  for (; !code && file != Walk(); file.increment(code)) {
    const std::string path = file->path().string();
    if (is_unfinished(path)) remove_if_abandoned(path);
  }
  if (code) return fail(Errc::unavailable, folder + " cannot be searched: " + code.message());
  return {};
}

Result<void> Disk::append(const std::string& path, std::string_view bytes) {
  const bool is_new = !exists(path);
  MIROCUP_TRY(const auto way, way_to(path, "written"));
  const Descriptor fd = open_for_writing(way.path, O_CREAT | O_APPEND);
  if (!fd.is_open() || !write_all(fd.get(), bytes) || fsync(fd.get()) != 0) {
    return problem(path, "written");
  }
  if (is_new && !sync_folder_of(way.path)) return problem(path, "written");
  return {};
}

Result<void> Disk::truncate(const std::string& path, std::size_t size) {
  MIROCUP_TRY(const auto way, way_to(path, "shortened"));
  const Descriptor fd = open_for_writing(way.path, 0);
  if (!fd.is_open() || ftruncate(fd.get(), static_cast<off_t>(size)) != 0 || fsync(fd.get()) != 0) {
    return problem(path, "shortened");
  }
  return {};
}

bool Disk::exists(const std::string& path) {
  if (const auto way = way_to(path, "read"); !way && way.error().code == Errc::input) return true;
  struct stat about {};
  if (lstat(path.c_str(), &about) == 0 || errno != ENOENT) return true;
  // Nothing has that name, unless a folder on the way is a link to a disk that is away.
  const fs::path folder = fs::path(path).parent_path();
  if (folder.empty() || folder == path) return false;
  return lstat(folder.c_str(), &about) == 0 ? stat(folder.c_str(), &about) != 0
                                            : exists(folder.string());
}

Result<void> Disk::make_folder(const std::string& path, Readers readers) {
  const std::string parent = fs::path(path).parent_path();
  if (!parent.empty() && !exists(parent)) MIROCUP_TRY_VOID(make_folder(parent));
  MIROCUP_TRY(const auto way, way_to(path, "made"));
  const bool is_closed = readers == Readers::owner;
  if (mkdir(way.path.c_str(), is_closed ? 0700 : 0777) != 0 && errno != EEXIST)
    return problem(path, "made");
  const int access = is_closed ? O_RDONLY | O_NOFOLLOW : O_PATH;
  const Descriptor fd(open(way.path.c_str(), access | O_DIRECTORY | O_CLOEXEC));
  if (!fd.is_open() || (is_closed && fchmod(fd.get(), 0700) != 0))
    return problem(path, is_closed ? "closed to others" : "made");
  return {};
}

Result<std::vector<std::string>> Disk::names_in(const std::string& folder) {
  MIROCUP_TRY(const auto way, way_to(folder, "read"));
  std::vector<std::string> names;
  std::error_code code;
  fs::directory_iterator file(way.path, code);
  for (; !code && file != fs::directory_iterator(); file.increment(code))
    names.push_back(file->path().filename().string());
  if (code) return fail(Errc::unavailable, folder + " cannot be read: " + code.message());
  std::sort(names.begin(), names.end());
  return names;
}

Result<void> Disk::remove(const std::string& path) {
  const auto way = way_to(path, "removed");
  if (!way) return exists(path) ? tl::unexpected(way.error()) : Result<void>();
  if (unlink(way->path.c_str()) == 0 || errno == ENOENT) return {};
  if (errno != EISDIR) return problem(path, "removed");
  MIROCUP_TRY(const auto names, names_in(path));
  for (const std::string& name : names) {
    MIROCUP_TRY(const auto file, way_to(path + "/" + name, "removed"));
    if (unlink(file.path.c_str()) != 0) return problem(path + "/" + name, "removed");
  }
  return rmdir(way->path.c_str()) == 0 ? Result<void>() : problem(path, "removed");
}

}  // namespace mirocup::system
