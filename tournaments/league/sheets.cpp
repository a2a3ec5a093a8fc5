// SPDX-License-Identifier: MIT
#include "tournaments/league/sheets.hpp"

#include "record/json_fields.hpp"
#include "record/json_reader.hpp"

namespace mirocup::league {

namespace {

using Json = nlohmann::ordered_json;

constexpr int most_grace = 60;  // days
constexpr std::int64_t grace_day_s = 86400;

SheetDeadlines read_deadlines(const record::JsonReader& json, const LeagueFile& file) {
  SheetDeadlines deadlines;
  for (const auto& [sheet, one] : json.members()) {
    one.expect_object({"until", "grace_days", "extensions"});
    SheetDeadline& deadline = deadlines[sheet];
    deadline.until = deadline.grace = read_time(one.at("until"), file);
    int days = 0;
    record::FieldReader(one).optional("grace_days", days, 0, most_grace);
    if (const auto until = system::parse_time(deadline.until))
      deadline.grace = utc_text(until->at + grace_day_s * days);
    if (!one.has("extensions")) continue;
    for (const auto& [team, until] : one.at("extensions").members())
      deadline.extensions[team] = read_time(until, file);
  }
  return deadlines;
}

std::map<std::string, std::string> read_scores(const record::JsonReader& json) {
  std::map<std::string, std::string> scores;
  for (const auto& [sheet, score] : json.members()) scores[sheet] = score.text();
  return scores;
}

}  // namespace

Result<SheetDeadlines> read_sheet_deadlines(system::Files& files, const Folder& folder,
                                            const LeagueFile& file) {
  MIROCUP_TRY(const auto text,
              files.read_if_there(folder.sheets(), {.max_size = system::size_limit::league_file}));
  if (!text) return SheetDeadlines{};
  return record::read_json<SheetDeadlines>(
      *text, folder.sheets(), Errc::input,
      [&](const record::JsonReader& json) { return read_deadlines(json, file); });
}

Result<void> release_scores(system::Files& files, const Folder& folder, const LeagueFile& file,
                            const SheetScores& scores) {
  MIROCUP_TRY_VOID(files.make_folder(folder.marks(), system::Readers::owner));
  MIROCUP_TRY_VOID(files.make_folder(folder.released_scores(), system::Readers::owner));
  for (const TeamConfig& team : file.teams) {
    const std::string path = folder.released_scores(team.name);
    MIROCUP_TRY_VOID(files.remove(path));
    const auto of_team = scores.find(team.name);
    if (of_team == scores.end()) continue;
    MIROCUP_TRY_VOID(
        files.write(path, record::json_text(Json(of_team->second)) + "\n", system::Readers::owner));
  }
  return {};
}

Result<Json> sheets_of_team(system::Files& files, const Folder& folder, const LeagueFile& file,
                            const std::string& team) {
  MIROCUP_TRY(const auto deadlines, read_sheet_deadlines(files, folder, file));
  const std::string path = folder.released_scores(team);
  MIROCUP_TRY(const auto text, files.read_if_there(path, {.max_size = system::size_limit::note}));
  std::map<std::string, std::string> scores;
  if (text) {
    MIROCUP_TRY(scores, (record::read_json<std::map<std::string, std::string>>(
                            *text, path, Errc::damaged, read_scores)));
  }
  std::map<std::string, Json> rows;
  const auto row_of = [&rows](const std::string& sheet) -> Json& {
    const Json empty{{"sheet", sheet}, {"until", ""}, {"own", ""}, {"score", ""}};
    return rows.try_emplace(sheet, empty).first->second;
  };
  for (const auto& [sheet, deadline] : deadlines) {
    const std::string& own = deadline.of(team);
    Json& row = row_of(sheet);
    row["until"] = shown_time(file, deadline.until);
    if (own != deadline.until) row["own"] = shown_time(file, own);
  }
  for (const auto& [sheet, score] : scores) row_of(sheet)["score"] = score;
  Json all = Json::array();
  for (const auto& [sheet, row] : rows) all.push_back(row);
  return all;
}

}  // namespace mirocup::league
