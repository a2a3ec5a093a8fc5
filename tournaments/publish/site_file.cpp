// SPDX-License-Identifier: MIT
#include "tournaments/publish/site_file.hpp"

#include "tournaments/format/league_file.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

std::string stem_of(const std::string& record) {
  return std::filesystem::path(record).stem();
}

// True if publishing gives files of that part of the site such names, or gave them in the past.
bool is_name_of(std::string_view part, std::string_view name) {
  if (part.empty()) return name == "night.html" || name == "feed.xml" || name == playground_name;
  const bool is_module = part == "module/";
  std::string_view end = is_module ? ".js" : part == "statistics/" ? ".json" : ".html";
  if (is_module && name.ends_with(".css")) end = ".css";
  for (const std::string_view beside : {".proof.js", ".league.json"}) {
    if (part == "replays/" && name.ends_with(beside)) end = beside;
  }
  if (!name.ends_with(end)) return false;
  const std::string_view stem = name.substr(0, name.size() - end.size());
  if (part == "teams/" || part == "digests/") return is_good_name(std::string(stem));
  const char* letters = is_module ? "0123456789abcdef" : "fgkr-0123456789";  // "g1-r2-f3-1-1"
  return !stem.empty() && stem.find_first_not_of(letters) == std::string_view::npos;
}

}  // namespace

std::string team_page_of(const std::string& team) {
  return "teams/" + team + ".html";
}

std::string replay_page_of(const std::string& record) {
  return "replays/" + stem_of(record) + ".html";
}

std::string statistics_file_of(const std::string& record) {
  return "statistics/" + stem_of(record) + ".json";
}

std::string part_file_of(const std::string& record) {
  return "replays/" + stem_of(record) + ".league.json";
}

std::string commands_file_of(const std::string& record) {
  return "replays/" + stem_of(record) + ".proof.js";
}

Result<void> remove_former_pages(system::Files& files, const std::string& site,
                                 const std::string& part, const std::set<std::string>& names) {
  const std::string folder = site + "/" + part;
  MIROCUP_TRY(const auto present, files.names_if_there(folder));
  for (const std::string& name : present) {
    std::error_code none;
    const auto type = std::filesystem::symlink_status(folder + name, none).type();
    if (type == std::filesystem::file_type::directory) continue;
    if (names.contains(part + name) || !is_name_of(part, name)) continue;
    MIROCUP_TRY_VOID(files.remove(folder + name));
  }
  return {};
}

}  // namespace mirocup::league
