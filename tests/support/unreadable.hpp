// SPDX-License-Identifier: MIT
//
// Files that are there and cannot be read, not even by root.
#pragma once

#include <filesystem>
#include <string>

namespace mirocup::test_support {

enum class Unreadable { is_folder, is_loop_of_links, leads_to_nothing };

inline constexpr Unreadable ways_to_be_unreadable[] = {
    Unreadable::is_folder, Unreadable::is_loop_of_links, Unreadable::leads_to_nothing};

// Puts it in the place of the file, whose folder is made if it is not there.
inline void make_unreadable(const std::string& path, Unreadable way) {
  namespace fs = std::filesystem;
  fs::remove_all(path);
  fs::create_directories(fs::path(path).parent_path());
  switch (way) {
    case Unreadable::is_folder:
      fs::create_directory(path);
      break;
    case Unreadable::is_loop_of_links:
      fs::create_symlink(path, path);
      break;
    case Unreadable::leads_to_nothing:
      fs::create_symlink(path + ".gone", path);
      break;
  }
}

}  // namespace mirocup::test_support
