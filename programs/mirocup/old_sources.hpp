// SPDX-License-Identifier: MIT
//
// Finds the parts of a folder with the sources of a SimuroSot team: its header, the files to
// compile, and the style of its interface.
#pragma once

#include "core/base/error.hpp"

#include <string>
#include <vector>

namespace mirocup::app {

struct OldSources {
  std::vector<std::string> files;    // all to be kept: sources and what they include
  std::string header;                // defines the structures of the platform
  std::vector<std::string> sources;  // to be compiled
  std::string style;                 // "classic", "restart", "v5"
  std::string standard;              // of C++, as g++ calls it
};

// Paths are relative to `folder`. Errc::input if it holds no team, or more than one.
Result<OldSources> find_old_sources(const std::string& folder);

}  // namespace mirocup::app
