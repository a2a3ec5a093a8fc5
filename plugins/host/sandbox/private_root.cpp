// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/private_root.hpp"

#include "system/descriptor.hpp"

#include <climits>

#include <cerrno>
#include <fcntl.h>
#include <linux/mount.h>
#include <sys/mount.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/syscall.h>

namespace mirocup::plugins {

namespace {

// The mount point where the tree is built. It hides the folder only in the child's own namespace.
constexpr const char* workshop = "/tmp";

// Enough room for the largest entry.
constexpr const char* root_options = "size=40m,mode=755";

// Binds `path` to the same path, without its leading slash, below the workshop.
bool bind(const char* path) {
  return mount(path, path + 1, nullptr, MS_BIND | MS_REC, nullptr) == 0 && make_read_only(path + 1);
}

bool add_loader_cache() {
  struct stat status {};
  if (stat(loader_cache, &status) != 0) return errno == ENOENT;
  const system::Descriptor file(
      open(loader_cache + 1, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  return file.get() >= 0 && bind(loader_cache);
}

bool add_entry(int entry) {
  struct stat status {};
  if (fstat(entry, &status) != 0) return false;
  const system::Descriptor file(
      open(private_entry_path + 1, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0444));
  return send_file(file.get(), entry, status.st_size);
}

}  // namespace

bool make_read_only(const char* path) {
  mount_attr attributes{};
  attributes.attr_set = MOUNT_ATTR_RDONLY | MOUNT_ATTR_NOSUID | MOUNT_ATTR_NODEV;
  return syscall(SYS_mount_setattr, AT_FDCWD, path, AT_RECURSIVE, &attributes, sizeof attributes) ==
         0;
}

bool show_folder(const char* path) {
  struct stat status {};
  if (lstat(path, &status) != 0) return errno == ENOENT;
  if (S_ISLNK(status.st_mode)) {
    char target[PATH_MAX];
    const ssize_t length = readlink(path, target, sizeof target - 1);
    if (length < 0) return false;
    target[length] = '\0';
    return symlink(target, path + 1) == 0;
  }
  return mkdir(path + 1, 0755) == 0 && bind(path);
}

bool send_file(int to, int from, off_t size) {
  for (off_t done = 0; done < size;) {
    if (sendfile(to, from, &done, static_cast<std::size_t>(size - done)) <= 0) return false;
  }
  return true;
}

const char* begin_root(const char* options, std::initializer_list<const char*> folders) {
  if (mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return "private mounts";
  if (mount("mirocup", workshop, "tmpfs", MS_NOSUID | MS_NODEV, options) != 0 ||
      chdir(workshop) != 0) {
    return "an empty root";
  }
  for (const char* folder : folders) {
    if (mkdir(folder, 0755) != 0) return "the folders of the root";
  }
  for (const char* folder : library_folders) {
    if (!show_folder(folder)) return folder;
  }
  return nullptr;
}

// Puts the old root on top of the new one and detaches it, which leaves the new one.
const char* change_root() {
  if (syscall(SYS_pivot_root, ".", ".") == 0 && umount2(".", MNT_DETACH) == 0 && chdir("/") == 0)
    return nullptr;
  return "the change of root";
}

const char* enter_private_root(int entry) {
  if (const char* step = begin_root(root_options, {"usr", "usr/local", "etc", "entry"}))
    return step;
  if (!add_loader_cache()) return loader_cache;
  if (entry != no_entry && !add_entry(entry)) return "the copy of the library";
  if (const char* step = change_root()) return step;
  if (!make_read_only("/")) return "a root that is read only";
  return nullptr;
}

}  // namespace mirocup::plugins
