// SPDX-License-Identifier: MIT
#include "tournaments/publish/night_pages.hpp"

#include "record/json_fields.hpp"
#include "system/text.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/replay_pages.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace mirocup::league {

namespace {

constexpr const char* closing_words = "A closing round of the last entries decides the season";
constexpr double run_up_s = 3.0;  // a moment is shown from a little before

std::string page_of_moment(const Overview& o, const std::string& root, const WorstMoment& moment) {
  const std::string page = page_of_record(o.state, root, moment.record);
  if (moment.at < 0.0 || page.empty()) return page;
  return page + system::formatted("#t=%.1f", std::max(0.0, moment.at - run_up_s));
}

std::string time_text(double at) {
  if (at < 0.0) return "";
  const int s = static_cast<int>(at);
  return system::formatted("%d:%02d", s / 60, s % 60);
}

// "3 (yesterday 5)", or "3 (new)".
std::string rank_in_words(const TeamDigest& d) {
  if (d.rank == 0) return "has not played";
  if (d.rank_before == 0) return std::to_string(d.rank) + " (new)";
  return std::to_string(d.rank) + " (yesterday " + std::to_string(d.rank_before) + ")";
}

std::string strength_in_words(const TeamDigest& d) {
  const auto rounded = [](double value) { return std::to_string(std::lround(value)); };
  if (!d.strength) return "–";
  std::string words = rounded(d.strength->value) + " (95 %: " + rounded(d.strength->low) + " to " +
                      rounded(d.strength->high) + ")";
  if (!d.strength_before) return words;
  const long change = std::lround(d.strength->value) - std::lround(d.strength_before->value);
  return words + ", " + (change >= 0 ? "+" : "") + std::to_string(change) + " since yesterday";
}

std::string legs_in_words(const TeamDigest& d) {
  return std::to_string(d.legs.won) + " won, " + std::to_string(d.legs.drawn) + " drawn, " +
         std::to_string(d.legs.lost) + " lost";
}

std::string page_of_digest(const LeagueState& state, int team) {
  return "digests/" + state.name(team) + ".html";
}

std::string title_of(const Night& night) {
  return "Night " + std::to_string(night.number);
}

// A page with the usual head around its content.
std::string plain_page(const Overview& o, const std::string& root, const std::string& title,
                       const std::string& lead, std::string content) {
  Json values = page_values(o, root, title);
  values["lead"] = lead;
  values["content"] = std::move(content);
  return filled_page("plain.html", values);
}

std::string night_page(const Overview& o, const Night& night, const std::vector<TeamDigest>& all) {
  Json teams = Json::array();
  for (const TeamDigest& d : all) {
    Json row = team_values(o, d.team, "");
    const long change = d.strength && d.strength_before
                            ? std::lround(d.strength->value) - std::lround(d.strength_before->value)
                            : 0;
    row.update(
        {{"rank", d.rank > 0 ? std::to_string(d.rank) : "–"},
         {"yesterday", d.rank_before > 0 ? std::to_string(d.rank_before) : "–"},
         {"legs", legs_in_words(d)},
         {"strength", d.strength ? std::to_string(std::lround(d.strength->value)) : "–"},
         {"change", !d.strength          ? "–"
                    : !d.strength_before ? "new"
                                         : (change >= 0 ? "+" : "") + std::to_string(change)},
         {"digest", page_of_digest(o.state, d.team)},
         {"is_new", d.has_new_entry}});
    teams.push_back(row);
  }
  return plain_page(o, "", title_of(night), shown_time(o.state.file, night.at),
                    filled_page("night.html", {{"teams", teams}}));
}

std::string entry_in_words(const TeamDigest& d) {
  if (d.entry == 0) return "";
  return std::to_string(d.entry) + (d.has_new_entry ? ", new since yesterday" : "");
}

std::string moment_in_words(const WorstMoment& moment) {
  return (moment.at >= 0.0 ? time_text(moment.at) + " " : "") + moment.what;
}

}  // namespace

std::string digest_html(const Overview& o, const Night& night, const TeamDigest& d,
                        const std::string& root) {
  Json losses = Json::array();
  for (const LostLeg& leg : d.losses)
    losses.push_back({{"page", page_of_record(o.state, root, leg.record)},
                      {"what", o.state.shown_name(leg.opponent) + " " + leg.score},
                      {"fixture", leg.fixture},
                      {"leg", leg.leg}});
  Json moments = Json::array();
  for (const WorstMoment& moment : d.moments)
    moments.push_back(
        {{"page", page_of_moment(o, root, moment)}, {"what", moment_in_words(moment)}});
  return filled_page("digest.html",
                     {{"title", title_of(night)},
                      {"rank", rank_in_words(d)},
                      {"strength", strength_in_words(d)},
                      {"legs", legs_in_words(d)},
                      {"entry", entry_in_words(d)},
                      {"closing", o.state.closing_round.empty() ? "" : closing_words},
                      {"losses", losses},
                      {"moments", moments}});
}

std::string digest_text(const Overview& o, const Night& night, const TeamDigest& d,
                        const std::string& address) {
  const auto link = [&address](const std::string& page) {
    return address.empty() || page.empty() ? "" : "  " + address + page;
  };
  std::string text =
      o.state.file.title + ", " + title_of(night) + ", " + shown_time(o.state.file, night.at);
  text += "\n\n" + o.state.shown_name(d.team) + "\nRank:     " + rank_in_words(d) +
          "\nStrength: " + strength_in_words(d) + "\nLegs:     " + legs_in_words(d) + "\n";
  if (d.entry > 0) text += "Entry:    " + entry_in_words(d) + "\n";
  if (!o.state.closing_round.empty()) text += closing_words + std::string("\n");
  text += "\nLost to:\n";
  if (d.losses.empty()) text += "  nobody\n";
  for (const LostLeg& leg : d.losses) {
    text += "  " + o.state.shown_name(leg.opponent) + " " + leg.score +
            link(page_of_record(o.state, "", leg.record)) + "\n";
  }
  text += "\nWorst moments:\n";
  if (d.moments.empty()) text += "  none\n";
  for (const WorstMoment& moment : d.moments) {
    text += "  " + moment_in_words(moment) + link(page_of_moment(o, "", moment)) + "\n";
  }
  return text;
}

Json digest_json(const Overview& o, const TeamDigest& d) {
  Json losses = Json::array();
  for (const LostLeg& leg : d.losses) {
    losses.push_back({{"to", o.state.name(leg.opponent)},
                      {"score", leg.score},
                      {"fixture", leg.fixture},
                      {"leg", leg.leg},
                      {"replay", page_of_record(o.state, "", leg.record)}});
  }
  Json moments = Json::array();
  for (const WorstMoment& moment : d.moments) {
    moments.push_back({{"what", moment.what},
                       {"at", moment.at >= 0.0 ? Json(moment.at) : Json()},
                       {"replay", page_of_moment(o, "", moment)}});
  }
  return {
      {"team", o.state.name(d.team)},
      {"rank", d.rank > 0 ? Json(d.rank) : Json()},
      {"rank_before", d.rank_before > 0 ? Json(d.rank_before) : Json()},
      {"strength", d.strength ? Json(std::lround(d.strength->value)) : Json()},
      {"strength_before", d.strength_before ? Json(std::lround(d.strength_before->value)) : Json()},
      {"entry", d.entry > 0 ? Json(d.entry) : Json()},
      {"new_entry", d.has_new_entry},
      {"won", d.legs.won},
      {"drawn", d.legs.drawn},
      {"lost", d.legs.lost},
      {"losses", losses},
      {"moments", moments}};
}

FileMakers night_pages(const Overview& o, const Night& night) {
  const auto all = std::make_shared<const std::vector<TeamDigest>>(digests(night, o));
  FileMakers files{{"night.html", [&o, &night, all] { return night_page(o, night, *all); }}};
  for (const TeamDigest& d : *all) {
    files[page_of_digest(o.state, d.team)] = [&o, &night, &d, all] {
      return plain_page(o, "../", o.state.shown_name(d.team), shown_time(o.state.file, night.at),
                        digest_html(o, night, d, "../"));
    };
  }
  return files;
}

}  // namespace mirocup::league
