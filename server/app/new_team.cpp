// SPDX-License-Identifier: MIT
//
// mirocup new DIR: writes a team that builds, or in Python plays, without changes.
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

// A program that every shell finds is called by its name, so that the files outlive a move.
std::string called_as(const std::string& program) {
  const fs::path path(program);
  for (const char* folder : {"/usr/bin", "/usr/local/bin"}) {
    if (path.parent_path() == folder) return path.filename().string();
  }
  return program;
}

}  // namespace

Result<int> run_new(const NewOptions& options) {
  const std::string& folder = options.folder;
  system::Disk disk;
  std::error_code none;
  if (fs::exists(folder, none) && !fs::is_empty(folder, none))
    return fail(Errc::input, folder + ": there is something in it already; name a new folder");
  const system::TeamKit kit = system::team_kit();
  const fs::path templates = fs::path(kit.templates) / options.language;
  if (!fs::is_directory(templates, none)) {
    return fail(Errc::unavailable,
                templates.string() + ": the files of a new team are missing here");
  }
  const std::string program = quoted_for_shell(called_as(kit.program));
  if (auto made = disk.make_folder(folder); !made) return tl::unexpected(made.error());

  for (const auto& file : fs::directory_iterator(templates)) {
    auto text = disk.read(file.path().string(), {.max_size = system::size_limit::system_file,
                                                 .links = system::Links::followed});
    if (!text) return tl::unexpected(text.error());
    std::string filled = replaced(std::move(*text), "@MIROCUP@", program);
    filled = replaced(std::move(filled), "@MIROCUP_PREFIX@", kit.prefix);
    filled = replaced(std::move(filled), "@MIROCUP_HEADERS@", kit.headers);
    filled = replaced(std::move(filled), "@MIROCUP_PYTHON@", kit.python);
    const std::string path = (fs::path(folder) / file.path().filename()).string();
    if (auto written = disk.write(path, filled); !written) return tl::unexpected(written.error());
    // Scripts can be run.
    if ((fs::status(file.path()).permissions() & fs::perms::owner_exec) != fs::perms::none)
      fs::permissions(path, fs::perms::all & ~fs::perms(022), none);
  }
  std::cout << system::printable(folder) << ": a team. "
            << (options.language == "python" ? "Test" : "Build, test") << " and check it: cd "
            << quoted_for_shell(folder)
            << (options.language == "python" ? " && ./test\n"
                                             : " && cmake --workflow --preset team\n");
  return exit_yes;
}

}  // namespace mirocup::app
