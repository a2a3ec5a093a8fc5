// SPDX-License-Identifier: MIT
//
// The playground: one page in which a visitor plays by hand, without a server. The workbench: the
// same page with an editor, which compiles a visitor's team and plays it.
#pragma once

#include "web/page_parts.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mirocup::web {

// Returns the playground's page with the drills of mirocup; nothing if the module was not built.
Result<std::optional<std::string>> playground_page(system::Files& files);

// A file of the workbench.
struct WorkbenchFile {
  std::string name;         // its path beside the page
  std::string text;         // its bytes, unless `source` is given
  std::string source = {};  // the path of a file of this installation with its bytes
};

// Returns the files of the workbench, the page first; no files if its parts were not built. All
// but the page are in folders below `folder` ("" or "NAME/"), whose names have a hash of their
// content. With `takes_hand_ins` the page hands in to the portal of a league, which has the page.
Result<std::vector<WorkbenchFile>> workbench_files(system::Files& files, const std::string& folder,
                                                   bool takes_hand_ins);

// Returns the bytes of a file of the workbench.
Result<std::string> bytes_of(system::Files& files, const WorkbenchFile& file);

}  // namespace mirocup::web
