// SPDX-License-Identifier: MIT
//
// Removes the files of pages that a site no longer has, because the staff has hidden rounds again.
#pragma once

#include "system/files.hpp"

#include <set>
#include <string>

namespace mirocup::league {

// Removes the files that `names` does not list from the folder `part` ("rounds/") of the site. Each
// name begins with `part`. A file that another process is writing stays.
Result<void> remove_former_pages(system::Files& files, const std::string& site,
                                 const std::string& part, const std::set<std::string>& names);

}  // namespace mirocup::league
