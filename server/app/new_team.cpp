// SPDX-License-Identifier: MIT
//
// mirocup new DIR: writes a team that builds without changes.
#include "server/app/commands.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"

#include <filesystem>
#include <iostream>
#include <utility>

namespace mirocup::app {

namespace {

namespace fs = std::filesystem;

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
  return text;
}

// A word that a shell reads as it is.
std::string quoted_for_shell(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+=@%";
  if (word.find_first_not_of(plain) == std::string::npos) return word;
  return "'" + replaced(word, "'", "'\\''") + "'";
}

}  // namespace

Result<int> run_new(const NewOptions& options) {
  const std::string& folder = options.folder;
  system::Disk disk;
  std::error_code none;
  if (fs::exists(folder, none) && !fs::is_empty(folder, none))
    return fail(Errc::input, folder + ": there is something in it already; name a new folder");
  const system::TeamKit kit = system::team_kit();
  if (!fs::is_directory(kit.templates, none))
    return fail(Errc::unavailable, kit.templates + ": the files of a new team are missing here");
  if (auto made = disk.make_folder(folder); !made) return tl::unexpected(made.error());

  for (const auto& file : fs::directory_iterator(kit.templates)) {
    auto text = disk.read(file.path().string(), {.max_size = system::size_limit::system_file,
                                                 .links = system::Links::followed});
    if (!text) return tl::unexpected(text.error());
    std::string filled = replaced(std::move(*text), "@MIROCUP@", kit.program);
    filled = replaced(std::move(filled), "@MIROCUP_PREFIX@", kit.prefix);
    filled = replaced(std::move(filled), "@MIROCUP_HEADERS@", kit.headers);
    const std::string path = (fs::path(folder) / file.path().filename()).string();
    if (auto written = disk.write(path, filled); !written) return tl::unexpected(written.error());
  }
  std::cout << system::printable(folder) << ": a team. Build, test and check it: cd "
            << quoted_for_shell(folder) << " && cmake --workflow --preset team\n";
  return exit_yes;
}

}  // namespace mirocup::app
