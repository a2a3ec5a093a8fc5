// SPDX-License-Identifier: MIT
#include "tournaments/publish/former_pages.hpp"

namespace mirocup::league {

Result<void> remove_former_pages(system::Files& files, const std::string& site,
                                 const std::string& part, const std::set<std::string>& names) {
  const std::string folder = site + "/" + part;
  MIROCUP_TRY(const auto present, files.names_if_there(folder));
  for (const std::string& name : present) {
    if (names.contains(part + name) || system::is_unfinished(name)) continue;
    if (auto removed = files.remove(folder + name); !removed) return removed;
  }
  return {};
}

}  // namespace mirocup::league
