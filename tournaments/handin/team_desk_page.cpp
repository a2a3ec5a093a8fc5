// SPDX-License-Identifier: MIT
#include "tournaments/handin/team_desk_page.hpp"

#include "record/json_fields.hpp"
#include "system/text.hpp"
#include "tournaments/handin/progress.hpp"
#include "tournaments/publish/page_values.hpp"

#include <algorithm>
#include <set>

namespace mirocup::league {

namespace {

using record::value_in;

// What is not folded of a list whose latest lines come first.
constexpr std::ptrdiff_t shown_friendlies = 10;
constexpr std::ptrdiff_t shown_legs = 20;

// Returns the answer to an entry in a sentence, without the team and the number, which are beside.
std::string answer_in_words(const Json& entry) {
  std::string message = text_in(entry, "message");
  if (message.empty()) return text_in(entry, "reason");
  const std::string before =
      text_in(entry, "team") + ": entry " + number_text(entry, "entry", "%.0f") + " ";
  if (message.starts_with(before)) message.erase(0, before.size());
  return message;
}

// The rows of the versions. page/hand_in.js reads data-pin.
Json entries_values(const TeamDesk& desk) {
  Json rows = desk.entries;
  for (Json& entry : rows) {
    const bool plays = value_in(entry, "entry", 0) == desk.playing;
    const bool is_pinned = plays && desk.is_pinned;
    entry["is_pinned"] = is_pinned;
    entry["plays"] = is_pinned ? "pinned " : plays ? "plays " : "";
    const bool may_play = text_in(entry, "state") == "accepted" && !entry.contains("late");
    entry["pin"] = may_play && !is_pinned ? entry["entry"] : Json();
    entry["answer"] = answer_in_words(entry);
    entry["when"] = desk.league.time_in_words(text_in(entry, "handed_in"));
    if (!entry.contains("late") || text_in(entry, "state") != "accepted") continue;
    entry["state"] = "late";
    entry["plays"] = "plays only if the host takes it ";
  }
  return rows;
}

std::string score_of(const Json& leg) {
  return number_text(leg, "goals", "%.0f") + " : " + number_text(leg, "against", "%.0f");
}

// The cells that legs of the league and friendlies share: leg_cells.html, opponent and score.
void add_leg_cells(Json& leg, const TeamDesk& desk) {
  const std::string bank = number_text(leg, "bank_seconds", "%.1f");
  const std::string cpu = number_text(leg, "cpu_seconds", "%.2f");
  leg["cpu"] = cpu.empty() ? "" : cpu + " of " + bank;
  leg["slowest"] = number_text(leg, "slowest_tick_ms", "%.2f");
  leg["opponent"] = desk.league.shown_name_of(text_in(leg, "opponent"));
  leg["score"] = score_of(leg);
  const bool has_thoughts = leg.contains("thoughts");
  if (!leg.contains("replay")) leg["replay"] = leg["log"] = Json();
  if (has_thoughts) leg["replay"] = leg["thoughts"];
  for (const char* link : {"replay", "log"})
    if (leg[link].is_string()) leg[link] = text_in(leg, link).substr(1);  // relative to /hand-in
}

Json friendlies_values(const TeamDesk& desk) {
  Json rows = desk.friendlies;
  for (Json& leg : rows) {
    add_leg_cells(leg, desk);
    const bool is_played = text_in(leg, "state") == "played";
    const int difference = is_played ? value_in(leg, "goals", 0) - value_in(leg, "against", 0) : 0;
    leg["letter"] = !is_played ? "" : difference > 0 ? "W" : difference < 0 ? "L" : "D";
    if (!is_played) leg["score"] = leg["state"];
    if (text_in(leg, "end") == "full_time") leg["end"] = "";
  }
  return rows;
}

// The table of the first legs, which are the latest, and a folded table of the others.
Json latest_first(const Json& legs, std::ptrdiff_t shown) {
  const auto older = legs.begin() + std::min<std::ptrdiff_t>(shown, legs.end() - legs.begin());
  Json tables = Json::array();
  for (const auto& [from, to] : {std::pair(legs.begin(), older), std::pair(older, legs.end())}) {
    if (from == to) continue;
    const bool has_thoughts =
        std::any_of(from, to, [](const Json& leg) { return leg.contains("thoughts"); });
    tables.push_back(
        {{"is_older", from == older}, {"has_thoughts", has_thoughts}, {"legs", Json(from, to)}});
  }
  return tables;
}

constexpr std::size_t shown_progress = 5;  // entries

// What friendlies against house teams say of the versions; null if there were none.
Json progress_values(const Json& progress) {
  if (progress.empty()) return {};
  std::set<std::string> houses;
  for (const Json& entry : progress) {
    for (const auto& met : entry["against"].items()) houses.insert(met.key());
  }
  Json rows;
  for (std::size_t i = 0; i < std::min(progress.size(), shown_progress); ++i) {
    const Json& entry = progress[i];
    Json scores = Json::array();
    for (const std::string& name : houses) {
      const auto met = entry["against"].find(name);
      scores.push_back(met == entry["against"].end() ? "" : score_of(*met));
    }
    rows.push_back({{"entry", entry["entry"]},
                    {"rating", number_text(entry, "rating", "%+.0f") + " (" +
                                   number_text(entry, "low", "%+.0f") + " to " +
                                   number_text(entry, "high", "%+.0f") + ")"},
                    {"scores", scores},
                    {"drills", number_text(entry["drills"], "score", "%.1f")},
                    {"fouls", number_text(entry, "fouls", "%.1f")},
                    {"slowest", number_text(entry, "slowest_tick_ms", "%.2f")}});
  }
  return {{"change", change_in_words(progress)}, {"houses", houses}, {"rows", rows}};
}

}  // namespace

std::string desk_page(const std::string& title, const std::string& content,
                      const std::string& root) {
  return filled_page("plain.html", {{"root", root},
                                    {"league", "League"},
                                    {"page_title", title},
                                    {"heading", title},
                                    {"content", content}});
}

std::string number_text(const Json& object, const char* key, const char* format) {
  const auto number = record::value_in<std::optional<double>>(object, key);
  if (!number) return "";
  const std::string text = system::formatted(format, *number);
  const bool is_minus_zero =
      text.starts_with('-') && text.find_first_of("123456789") == std::string::npos;
  return is_minus_zero ? text.substr(1) : text;
}

std::string log_in_page(const std::string& why, const std::string& root) {
  return desk_page("Hand in", filled_page("log_in.html", {{"root", root}, {"why", why}}), root);
}

std::string team_desk_page(const TeamDesk& desk) {
  Json opponents = Json::array();
  for (const std::string& name : desk.opponents)
    opponents.push_back({{"team", name}, {"name", desk.league.shown_name_of(name)}});
  Json legs = desk.legs;
  for (Json& leg : legs) add_leg_cells(leg, desk);
  return desk_page(
      desk.league.shown_name_of(desk.team),
      filled_page(
          "team_desk.html",
          {{"has_entries", !desk.entries.empty()},
           {"entries", entries_values(desk)},
           {"older", desk.older},
           {"is_late", desk.is_late},
           {"deadline", desk.deadline.empty() ? "" : desk.league.time_in_words(desk.deadline)},
           {"grade", desk.mark},
           {"has_sheets", !desk.sheets.empty()},
           {"sheets", desk.sheets},
           {"digest", desk.digest},
           {"progress", progress_values(desk.progress)},
           {"may_play", desk.playing > 0},
           {"opponents", opponents},
           {"friendlies", latest_first(friendlies_values(desk), shown_friendlies)},
           {"legs", latest_first(legs, shown_legs)},
           {"has_legs", !legs.empty()},
           {"team", desk.team}}));
}

}  // namespace mirocup::league
