// SPDX-License-Identifier: MIT
//
// The files of the published league, and their names.
#pragma once

#include "system/files.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>

namespace mirocup::league {

struct SiteFile {
  std::string name;  // path inside site/
  std::string bytes;
};

// Functions that return the bytes of files, by their names inside site/. Most pages of a large
// league are seldom read, so a server makes a page only when it is asked for. The data from which
// such functions were made must outlive them.
using FileMakers = std::map<std::string, std::function<std::string()>>;

// The page in which visitors play by hand. The page has a separate content security policy.
inline constexpr const char* playground_name = "playground.html";

// The following functions return paths inside site/.
std::string team_page_of(const std::string& team);

// The files of a record ("records/x.json"): its replay page "replays/x.html", the statistics of
// its leg, what the league has put on the page, and the script file with the commands of its leg,
// which exists only if the page has a proof.
std::string replay_page_of(const std::string& record);
std::string statistics_file_of(const std::string& record);
std::string part_file_of(const std::string& record);
std::string commands_file_of(const std::string& record);

// To be called because the staff may have hidden rounds again: removes the files that `names` does
// not list from the folder `part` ("rounds/") of the site. Each name begins with `part`. Files stay
// whose names publishing never gives, and so do folders.
Result<void> remove_former_pages(system::Files& files, const std::string& site,
                                 const std::string& part, const std::set<std::string>& names);

}  // namespace mirocup::league
