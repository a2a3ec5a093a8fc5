// SPDX-License-Identifier: MIT
//
// Finds the parts of a folder with the sources of a SimuroSot team: its header, the files to
// compile, and the style of its interface.
#pragma once

#include "core/base/error.hpp"

#include <string>
#include <vector>

namespace mirocup::labs {

struct OldSources {
  std::vector<std::string> files;    // all files to keep: sources and included files
  std::string header;                // defines the structures of the platform
  std::vector<std::string> sources;  // to be compiled
  std::vector<std::string> macros;   // of the project, for the preprocessor
  std::string style;                 // "classic", "restart", "v5"
  std::string standard;              // standard of C++, as g++ names it
  std::string lost_entry;            // the platform calls this function, and no source has it
};

// Returns paths relative to `folder`. Errc::input if the folder holds no team, or several teams.
Result<OldSources> find_old_sources(const std::string& folder);

}  // namespace mirocup::labs
