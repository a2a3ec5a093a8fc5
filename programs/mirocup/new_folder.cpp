// SPDX-License-Identifier: MIT
#include "programs/mirocup/new_folder.hpp"

#include "plugins/host/team_host.hpp"
#include "system/text.hpp"

#include <algorithm>

namespace mirocup::app {

namespace fs = std::filesystem;

namespace {

// A program that every shell finds is called by its name, so that the files outlive a move.
std::string called_as(const std::string& program) {
  const fs::path path(program);
  for (const char* folder : {"/usr/bin", "/usr/local/bin"}) {
    if (path.parent_path() == folder) return path.filename().string();
  }
  return program;
}

// Returns the name of the team in this folder: that of the folder, without what a text of C++ or
// Python cannot hold.
std::string named_after(const std::string& folder) {
  std::string path = fs::absolute(folder).lexically_normal().string();
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  std::string name;
  for (const char c : fs::path(path).filename().string()) {
    const bool is_plain = static_cast<unsigned char>(c) >= ' ' && c != '\x7f' && c != '"' &&
                          c != '\\' && c != '?' && c != '@';
    name += is_plain ? c : '_';
  }
  return name.empty() || name.size() > plugins::max_own_name ? "mine" : name;
}

}  // namespace

Result<void> expect_empty_folder(const std::string& folder) {
  std::error_code none;
  if (fs::exists(folder, none) && !fs::is_empty(folder, none))
    return fail(Errc::input, folder + ": there is something in it already; name a new folder");
  return {};
}

Words template_words(const system::TeamKit& kit, const std::string& folder) {
  return {{"@NAME@", named_after(folder)},
          {"@MIROCUP@", system::shell_word(called_as(kit.program))},
          {"@MIROCUP_PREFIX@", kit.prefix},
          {"@MIROCUP_HEADERS@", kit.headers},
          {"@MIROCUP_PYTHON@", kit.python}};
}

Result<void> write_filled(system::Disk& disk, const fs::path& file, const std::string& folder,
                          const Words& words) {
  MIROCUP_TRY(const auto text, disk.read_named(file.string(), system::size_limit::system_file));
  // In one pass: the name of a file may look like one of the words.
  std::string filled;
  for (std::size_t at = 0; at < text.size();) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& word) {
      return text.compare(at, word.first.size(), word.first) == 0;
    });
    filled += found != words.end() ? found->second : text.substr(at, 1);
    at += found != words.end() ? found->first.size() : 1;
  }
  const std::string path = (fs::path(folder) / file.filename()).string();
  MIROCUP_TRY_VOID(disk.write(path, filled));
  // Scripts can be run.
  std::error_code none;
  if ((fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none)
    fs::permissions(path, fs::perms::all & ~fs::perms(022), none);
  return {};
}

}  // namespace mirocup::app
