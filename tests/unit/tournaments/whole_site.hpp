// SPDX-License-Identifier: MIT
//
// Makes all files of a league's site at once, for tests that compare sites or look into pages.
#pragma once

#include "tournaments/publish/site.hpp"

#include <utility>
#include <vector>

namespace mirocup::league {

inline std::vector<SiteFile> make_site(SiteSource source) {
  const Site site(std::move(source));
  std::vector<SiteFile> files;
  for (const std::string& name : site.names()) files.push_back({name, *site.file(name)});
  return files;
}

}  // namespace mirocup::league
