// SPDX-License-Identifier: MIT
//
// mirocup new DIR: writes a team that builds, or in Python plays, without changes. An old team of
// SimuroSot is written by mirocup-labs.
#include "programs/mirocup/commands.hpp"
#include "programs/mirocup/new_folder.hpp"
#include "system/locations.hpp"
#include "system/text.hpp"

#include <filesystem>

namespace mirocup::app {

namespace {

struct NewOptions {
  std::string simurosot;  // folder with the sources of an old team; "": a new team
  std::string folder;
  std::string language = "c++";
};

namespace fs = std::filesystem;

Result<int> run_new(const NewOptions& options) {
  const std::string& folder = options.folder;
  if (!options.simurosot.empty())
    return tl::unexpected(
        become_labs({"new", "--from-simurosot", options.simurosot, "--", folder}));
  MIROCUP_TRY_VOID(expect_empty_folder(folder));
  system::Disk disk;
  const system::TeamKit kit = system::team_kit();
  const fs::path templates = fs::path(kit.templates) / options.language;
  std::error_code none;
  if (!fs::is_directory(templates, none)) {
    return fail(Errc::unavailable,
                templates.string() +
                    ": the files of a new team are missing here; install a package of mirocup "
                    "(docs/installing.md), or build with cmake --preset packages");
  }
  MIROCUP_TRY_VOID(disk.make_folder(folder));

  const Words words = template_words(kit, folder);
  std::vector<fs::path> files(fs::directory_iterator{templates}, fs::directory_iterator{});
  // A team in C is built as one in C++.
  for (const char* name : {"CMakePresets.json", "README.md", "debug", "watch"}) {
    if (options.language == "c") files.push_back(fs::path(kit.templates) / "c++" / name);
  }
  for (const fs::path& file : files) MIROCUP_TRY_VOID(write_filled(disk, file, folder, words));
  std::cout << system::printable(folder) << ": a team. "
            << (options.language == "python" ? "Test" : "Build, test") << " and check it: cd "
            << system::shell_word(folder)
            << (options.language == "python" ? " && ./test\n"
                                             : " && cmake --workflow --preset team\n");
  return exit_yes;
}

}  // namespace

void add_new(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_new, "new", for_teams, "Make a folder with a team that builds without changes",
      {"mirocup new mine && cd mine && cmake --workflow --preset team",
       "mirocup new mine --language python"});
  command.option("DIR", o.folder, "Folder to make; must be new or empty").required();
  command.option("--language", o.language, "Language of the team")
      .one_of({"c++", "c", "python"})
      .shows_default();
  command.option("--from-simurosot OLD", o.simurosot,
                 "Folder with the sources of a team that was written for SimuroSot or Simuro5v5; "
                 "they are copied");
}

}  // namespace mirocup::app
