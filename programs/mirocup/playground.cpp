// SPDX-License-Identifier: MIT
//
// mirocup playground: writes the page in which anyone plays by hand.
#include "web/playground.hpp"

#include "programs/mirocup/commands.hpp"

namespace mirocup::app {

namespace {

struct PlaygroundOptions {
  std::string folder;
};

Result<int> run_playground(const PlaygroundOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto page, web::playground_page(disk));
  if (!page) {
    return fail(Errc::unavailable,
                "this mirocup was built without the module for browsers; docs/browser.md says what "
                "to install");
  }
  MIROCUP_TRY_VOID(disk.make_folder(options.folder));
  const std::string path = options.folder + "/index.html";
  MIROCUP_TRY_VOID(disk.write(path, *page));
  std::cout << system::printable(path) << '\n';
  return exit_yes;
}

}  // namespace

void add_playground(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_playground, "playground", for_teams,
      "Make a page in which anyone can play by hand, against house teams, in a browser",
      {"mirocup playground -o playground"});
  command
      .option("-o,--output FOLDER", o.folder,
              "Folder to write index.html to; this page opens from disk")
      .required();
}

}  // namespace mirocup::app
