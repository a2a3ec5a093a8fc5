// SPDX-License-Identifier: MIT
//
// mirocup workbench: writes a folder for any web server, with a page in which anyone writes a team
// in C++ that the browser compiles and plays.
#include "programs/mirocup/commands.hpp"
#include "web/playground.hpp"

#include <filesystem>

namespace mirocup::app {

namespace {

struct WorkbenchOptions {
  std::string folder;
};

Result<int> run_workbench(const WorkbenchOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto files, web::workbench_files(disk, "", false));
  if (files.empty()) {
    return fail(
        Errc::unavailable,
        "this mirocup was built without the workbench; docs/browser.md says how to build it");
  }
  const auto write = [&](const std::string& name, const std::string& bytes) -> Result<void> {
    const std::string path = options.folder + "/" + name;
    MIROCUP_TRY_VOID(disk.make_folder(std::filesystem::path(path).parent_path().string()));
    return disk.update(path, bytes);
  };
  for (const web::WorkbenchFile& file : files) {
    MIROCUP_TRY(const auto bytes, web::bytes_of(disk, file));
    MIROCUP_TRY_VOID(write(file.name, bytes));
  }
  MIROCUP_TRY(const auto playground, web::playground_page(disk));
  MIROCUP_TRY_VOID(write("playground.html", playground.value_or("")));
  std::cout << system::printable(options.folder) << "/index.html\n";
  return exit_yes;
}

}  // namespace

void add_workbench(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_workbench, "workbench", for_teams,
                   "Make a page in which anyone writes a team in C++ and plays it, in a browser",
                   {"mirocup workbench -o workbench && python3 -m http.server -d workbench"});
  command.option("-o,--output FOLDER", o.folder, "Folder to write; put it on any web server")
      .required();
}

}  // namespace mirocup::app
