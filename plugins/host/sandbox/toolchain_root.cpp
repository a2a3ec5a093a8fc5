// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/toolchain_root.hpp"

#include "plugins/host/sandbox/private_root.hpp"
#include "system/descriptor.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mount.h>
#include <sys/stat.h>

namespace mirocup::plugins {

namespace {

constexpr const char* tree_options = "size=16m,mode=755";
constexpr const char* work_options = "size=256m,mode=700";

// What the compiler needs, beside library_folders, which have its parts and the libraries.
constexpr const char* compiler_folders[] = {"/bin", "/usr/bin", "/usr/include", "/usr/libexec"};

bool is_work(const TreeFile& file) {
  const std::size_t length = std::strlen(work_folder);
  return std::strncmp(file.path.c_str(), work_folder, length) == 0 && file.path[length] == '/';
}

bool write_file(const TreeFile& file) {
  if (file.is_folder) return mkdir(file.path.c_str(), 0755) == 0;
  const system::Descriptor out(
      open(file.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0444));
  std::size_t done = 0;
  while (out.is_open() && done < file.bytes.size()) {
    const ssize_t n = write(out.get(), file.bytes.data() + done, file.bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return out.is_open();
}

}  // namespace

const char* enter_toolchain_root(std::span<const TreeFile> files) {
  if (const char* step = begin_root(tree_options)) return step;
  for (const char* folder :
       {"usr", "usr/local", "etc", "mirocup", "mirocup/include", work_folder + 1}) {
    if (mkdir(folder, 0755) != 0) return "the folders of the root";
  }
  for (const char* folder : library_folders) {
    if (!show_folder(folder)) return folder;
  }
  for (const char* folder : compiler_folders) {
    if (!show_folder(folder)) return folder;
  }
  if (const char* step = change_root()) return step;
  for (const TreeFile& file : files) {
    if (!is_work(file) && !write_file(file)) return "the headers of a strategy";
  }
  if (!make_read_only("/")) return "a root that is read only";
  if (mount("work", work_folder, "tmpfs", MS_NOSUID | MS_NODEV, work_options) != 0 ||
      chdir(work_folder) != 0)
    return "the folder in which the compiler works";
  for (const TreeFile& file : files) {
    if (is_work(file) && !write_file(file)) return "the source";
  }
  return nullptr;
}

}  // namespace mirocup::plugins
