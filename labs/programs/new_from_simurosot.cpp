// SPDX-License-Identifier: MIT
//
// mirocup new DIR --from-simurosot OLD: writes a team that builds from the sources of an old one.
#include "labs/programs/commands.hpp"
#include "labs/programs/old_sources.hpp"
#include "labs/programs/old_text.hpp"
#include "programs/mirocup/new_folder.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <filesystem>
#include <iostream>

namespace mirocup::labs {

namespace {

struct NewOptions {
  std::string simurosot;  // folder with the sources of the old team
  std::string folder;
};

namespace fs = std::filesystem;

// Copies a source of an old team, in the form that compilers of today read. Returns whether that
// is another one.
Result<bool> copy_source(system::Disk& disk, const fs::path& from, const fs::path& to) {
  MIROCUP_TRY(const auto text, disk.read(from.string(), {.max_size = system::size_limit::note}));
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  if (error) return fail(Errc::unavailable, to.string() + ": " + error.message());
  const std::string now = readable(text);
  MIROCUP_TRY_VOID(disk.write(to.string(), now));
  return now != text;
}

// Makes a team of old sources, which are copied to src.
Result<void> adopt(system::Disk& disk, const system::TeamKit& kit, const NewOptions& options,
                   const OldSources& old) {
  for (const std::string& path : old.files) {
    MIROCUP_TRY(const auto is_changed, copy_source(disk, fs::path(options.simurosot) / path,
                                                   fs::path(options.folder) / "src" / path));
    if (is_changed) {
      std::cout << "src/" << system::printable(path)
                << ": mirocup new changed its text so that g++ can read it\n";
    }
  }
  std::string sources;
  for (const std::string& path : old.sources) sources += "\n    \"src/" + path + '"';
  std::string macros;
  for (const std::string& macro : old.macros) macros += ' ' + macro;
  app::Words words = app::template_words(kit, options.folder);
  words.insert(words.end(), {{"@HEADER@", "src/" + old.header},
                             {"@SOURCES@", sources},
                             {"@DEFINITIONS@", macros.empty() ? "" : "\n  DEFINITIONS" + macros},
                             {"@STYLE@", old.style},
                             {"@STANDARD@", old.standard}});
  const fs::path templates = fs::path(kit.prefix) / "share" / "mirocup" / "simurosot" / "template";
  for (const fs::path& file : {templates / "CMakeLists.txt", templates / "README.md",
                               fs::path(kit.templates) / "c++" / "CMakePresets.json"}) {
    if (auto done = app::write_filled(disk, file, options.folder, words); !done) return done;
  }
  std::cout << "style " << old.style << ", header " << system::printable(old.header) << ", "
            << old.sources.size() << (old.sources.size() == 1 ? " source" : " sources") << ", "
            << old.standard << (macros.empty() ? "" : ", macros" + macros) << '\n';
  if (!old.lost_entry.empty()) {
    std::cout << "no source here seems to define " << old.lost_entry
              << ", which the platform calls: are these the sources of a team?\n";
  }
  return {};
}

Result<int> run_new(const NewOptions& options) {
  MIROCUP_TRY_VOID(app::expect_empty_folder(options.folder));
  MIROCUP_TRY(const auto old, find_old_sources(options.simurosot));
  system::Disk disk;
  MIROCUP_TRY_VOID(disk.make_folder(options.folder));
  MIROCUP_TRY_VOID(adopt(disk, system::team_kit(), options, old));
  std::cout << system::printable(options.folder) << ": a team. Build, test and check it: cd "
            << system::shell_word(options.folder) << " && cmake --workflow --preset team\n";
  return exit_yes;
}

}  // namespace

// `mirocup new` has the help of the option.
void add_new(system::Commands& commands) {
  const auto [command, o] = commands.add(run_new, "new", "", "", {});
  command.option("DIR", o.folder).required();
  command.option("--from-simurosot", o.simurosot).required();
}

}  // namespace mirocup::labs
