// SPDX-License-Identifier: MIT
//
// mirocup new DIR: writes a team that builds, or in Python plays, without changes: a new one, or an
// old one of SimuroSot.
#include "plugins/host/team_host.hpp"
#include "programs/mirocup/commands.hpp"
#include "programs/mirocup/old_sources.hpp"
#include "programs/mirocup/old_text.hpp"
#include "system/files.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <utility>
#include <vector>

namespace mirocup::app {

namespace {

struct NewOptions {
  std::string simurosot;  // folder with the sources of an old team; "": a new team
  std::string folder;
  std::string language = "c++";
};

namespace fs = std::filesystem;

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

using Words = std::vector<std::pair<std::string, std::string>>;

// Copies a file of the installation into the folder, with other words in place of some.
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
  if (auto written = disk.write(path, filled); !written) return written;
  // Scripts can be run.
  std::error_code none;
  if ((fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none)
    fs::permissions(path, fs::perms::all & ~fs::perms(022), none);
  return {};
}

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
                   const OldSources& old, Words words) {
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
  words.insert(words.end(), {{"@HEADER@", "src/" + old.header},
                             {"@SOURCES@", sources},
                             {"@STYLE@", old.style},
                             {"@STANDARD@", old.standard}});
  const fs::path templates = fs::path(kit.prefix) / "share" / "mirocup" / "simurosot" / "template";
  for (const fs::path& file : {templates / "CMakeLists.txt", templates / "README.md",
                               fs::path(kit.templates) / "c++" / "CMakePresets.json"}) {
    if (auto done = write_filled(disk, file, options.folder, words); !done) return done;
  }
  std::cout << "style " << old.style << ", header " << system::printable(old.header) << ", "
            << old.sources.size() << (old.sources.size() == 1 ? " source" : " sources") << ", "
            << old.standard << '\n';
  return {};
}

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
                templates.string() +
                    ": the files of a new team are missing here; install a package of mirocup "
                    "(docs/installing.md), or build with cmake --preset packages");
  }
  Result<OldSources> old = OldSources{};
  if (!options.simurosot.empty()) old = find_old_sources(options.simurosot);
  if (!old) return tl::unexpected(old.error());
  MIROCUP_TRY_VOID(disk.make_folder(folder));

  const Words words{{"@NAME@", named_after(folder)},
                    {"@MIROCUP@", system::shell_word(called_as(kit.program))},
                    {"@MIROCUP_PREFIX@", kit.prefix},
                    {"@MIROCUP_HEADERS@", kit.headers},
                    {"@MIROCUP_PYTHON@", kit.python}};
  if (!options.simurosot.empty()) {
    MIROCUP_TRY_VOID(adopt(disk, kit, options, *old, words));
  } else {
    std::vector<fs::path> files(fs::directory_iterator{templates}, fs::directory_iterator{});
    // A team in C is built as one in C++.
    for (const char* name : {"CMakePresets.json", "debug", "watch"}) {
      if (options.language == "c") files.push_back(fs::path(kit.templates) / "c++" / name);
    }
    for (const fs::path& file : files) MIROCUP_TRY_VOID(write_filled(disk, file, folder, words));
  }
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
  command
      .option("--from-simurosot", o.simurosot,
              "Folder with the sources of a team that was written for SimuroSot or Simuro5v5; "
              "they are copied")
      .named("OLD");
}

}  // namespace mirocup::app
