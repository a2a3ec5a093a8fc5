// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/file_access.hpp"

#include "plugins/host/sandbox/private_root.hpp"
#include "system/descriptor.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/syscall.h>

namespace mirocup::plugins {

namespace {

// The structure of version 6, which may be newer than the system's header.
struct Rules {
  std::uint64_t files;
  std::uint64_t network;
  std::uint64_t scopes;
};

// The number of file rights that each version knows; the index is the version.
constexpr int file_rights[] = {0, 13, 14, 15, 15, 16};
constexpr std::uint64_t bind_and_connect_tcp = 3;
constexpr std::uint64_t abstract_sockets_and_signals = 3;

system::Descriptor make_rules() {
  const int version = landlock_version();
  const int known = version < 5 ? file_rights[version < 0 ? 0 : version] : file_rights[5];
  Rules rules{};
  rules.files = (std::uint64_t{1} << known) - 1;
  std::size_t size = sizeof rules.files;
  if (version >= 4) {
    rules.network = bind_and_connect_tcp;
    size = offsetof(Rules, scopes);
  }
  if (version >= 6) {
    rules.scopes = abstract_sockets_and_signals;
    size = sizeof rules;
  }
  return system::Descriptor(
      static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, size, 0)));
}

// Adds a rule that allows reading below `path`. A path that does not exist needs no rule.
bool allow_reading(const system::Descriptor& rules, const char* path,
                   std::uint64_t rights = LANDLOCK_ACCESS_FS_READ_FILE) {
  const system::Descriptor file(open(path, O_PATH | O_CLOEXEC));
  if (file.get() < 0) return errno == ENOENT;
  landlock_path_beneath_attr below{};
  below.allowed_access = rights;
  below.parent_fd = file.get();
  return syscall(SYS_landlock_add_rule, rules.get(), LANDLOCK_RULE_PATH_BENEATH, &below, 0) == 0;
}

bool enforce(const system::Descriptor& rules) {
  return syscall(SYS_landlock_restrict_self, rules.get(), 0) == 0;
}

}  // namespace

int landlock_version() {
  return static_cast<int>(
      syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION));
}

bool allow_libraries_only(const char* entry_path, Folders folders) {
  const system::Descriptor rules = make_rules();
  if (rules.get() < 0) return false;
  std::uint64_t rights = LANDLOCK_ACCESS_FS_READ_FILE;
  if (folders == Folders::listed) rights |= LANDLOCK_ACCESS_FS_READ_DIR;
  for (const char* folder : library_folders) {
    if (!allow_reading(rules, folder, rights)) return false;
  }
  if (!allow_reading(rules, loader_cache)) return false;
  if (entry_path != nullptr && !allow_reading(rules, entry_path)) return false;
  return enforce(rules);
}

bool allow_no_files() {
  const system::Descriptor rules = make_rules();
  return rules.get() >= 0 && enforce(rules);
}

}  // namespace mirocup::plugins
