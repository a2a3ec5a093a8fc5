// SPDX-License-Identifier: MIT
//
// A disk in memory, which can be made to fail.
#pragma once

#include "system/files.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace mirocup::test_support {

class MemoryFiles final : public system::Files {
 public:
  // Lets the next `writes` writes or appends succeed, and all later ones fail.
  void fail_after(int writes) { writes_left_ = writes; }

  // Without options: what a test has written itself.
  Result<std::string> read(const std::string& path) {
    return read(path, {.max_size = system::size_limit::journal});
  }

  Result<std::string> read(const std::string& path, const system::ReadOptions&) override {
    const auto found = files_.find(path);
    if (found == files_.end()) return fail(Errc::unavailable, path + " cannot be read");
    return found->second;
  }

  Result<void> write(const std::string& path, std::string_view bytes,
                     system::Readers = system::Readers::everybody) override {
    if (!may_write()) return fail(Errc::unavailable, path + " cannot be written: no space left");
    files_[path] = bytes;
    return {};
  }

  Result<void> remove_unfinished(const std::string&) override { return {}; }

  Result<void> append(const std::string& path, std::string_view bytes) override {
    if (!may_write()) return fail(Errc::unavailable, path + " cannot be written: no space left");
    files_[path] += bytes;
    return {};
  }

  Result<void> truncate(const std::string& path, std::size_t size) override {
    files_[path].resize(size);
    return {};
  }

  bool exists(const std::string& path) override { return files_.count(path) != 0; }

  Result<void> make_folder(const std::string&,
                           system::Readers = system::Readers::everybody) override {
    return {};
  }

  Result<std::vector<std::string>> names_in(const std::string& folder) override {
    std::set<std::string> names;
    const std::size_t begin = folder.size() + 1;
    for (const auto& [path, bytes] : files_) {
      if (path.starts_with(folder + "/"))
        names.insert(path.substr(begin, path.find('/', begin) - begin));
    }
    return std::vector<std::string>(names.begin(), names.end());
  }

  Result<void> remove(const std::string& path) override {
    std::erase_if(files_, [&path](const auto& file) {
      return file.first == path || file.first.starts_with(path + "/");
    });
    return {};
  }

 private:
  bool may_write() { return writes_left_ < 0 || writes_left_-- > 0; }

  std::map<std::string, std::string> files_;
  int writes_left_ = -1;
};

}  // namespace mirocup::test_support
