// SPDX-License-Identifier: MIT
#include "tournaments/publish/night_pages.hpp"

#include "record/json_fields.hpp"
#include "system/text.hpp"
#include "tournaments/publish/page_values.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace mirocup::league {

namespace {

constexpr const char* closing_words = "A closing round of the last entries decides the season";

bool is_first(const Night& night) {
  return night.number == 1;
}

// "3 (yesterday 5)", or "3 (new)". In the first night everything is new.
std::string rank_in_words(const Night& night, const TeamDigest& d) {
  if (d.rank == 0) return "has not played";
  if (d.rank_before == 0) return std::to_string(d.rank) + (is_first(night) ? "" : " (new)");
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
  if (d.legs.legs == 0) return "none";
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
                    : !d.strength_before ? (is_first(night) ? "–" : "new")
                                         : (change >= 0 ? "+" : "") + std::to_string(change)},
         {"digest", page_of_digest(o.state, d.team)},
         {"is_new", d.has_new_entry && !is_first(night)}});
    teams.push_back(row);
  }
  return plain_page(o, "", title_of(night), shown_time(o.state.file, night.at),
                    filled_page("night.html", {{"teams", teams}}));
}

std::string entry_in_words(const Night& night, const TeamDigest& d) {
  if (d.entry == 0) return "";
  const bool is_new = d.has_new_entry && !is_first(night);
  return std::to_string(d.entry) + (is_new ? ", new since yesterday" : "");
}

}  // namespace

// The values of digest.html and digest.txt. Links begin with `root`.
static Json digest_values(const Overview& o, const Night& night, const TeamDigest& d,
                          const std::string& root) {
  Json losses = Json::array();
  for (const LegView* leg : d.losses)
    losses.push_back(
        {{"page", leg->page(root)},
         {"what", o.state.shown_name(leg->other(d.team)) + " " + score_text(*leg, d.team)},
         {"fixture", leg->fixture},
         {"leg", leg->leg}});
  Json moments = Json::array();
  for (const WorstMoment& moment : d.moments)
    moments.push_back({{"page", moment.leg->page(root, moment.at)},
                       {"what", (moment.when.empty() ? "" : moment.when + ": ") + moment.what}});
  return {{"title", title_of(night)},
          {"rank", rank_in_words(night, d)},
          {"strength", strength_in_words(d)},
          {"legs", legs_in_words(d)},
          {"entry", entry_in_words(night, d)},
          {"closing", o.state.closing_round.empty() ? "" : closing_words},
          {"has_played", d.legs.legs > 0},
          {"losses", losses},
          {"moments", moments}};
}

std::string digest_html(const Overview& o, const Night& night, const TeamDigest& d,
                        const std::string& root) {
  return filled_page("digest.html", digest_values(o, night, d, root));
}

std::string digest_text(const Overview& o, const Night& night, const TeamDigest& d,
                        const std::string& address) {
  Json values = digest_values(o, night, d, address);
  values.update({{"league", o.state.file.title},
                 {"at", shown_time(o.state.file, night.at)},
                 {"team", o.state.shown_name(d.team)},
                 {"hand_ins", d.hand_ins},
                 {"has_links", !address.empty()}});
  return filled_page("digest.txt", values);
}

Json digest_json(const Overview& o, const TeamDigest& d) {
  Json losses = Json::array();
  for (const LegView* leg : d.losses) {
    losses.push_back({{"to", o.state.name(leg->other(d.team))},
                      {"score", score_text(*leg, d.team)},
                      {"fixture", leg->fixture},
                      {"leg", leg->leg},
                      {"replay", leg->page()}});
  }
  Json moments = Json::array();
  for (const WorstMoment& moment : d.moments) {
    moments.push_back({{"what", moment.what},
                       {"at", moment.at >= 0.0 ? Json(moment.at) : Json()},
                       {"when", record::or_null(moment.when)},
                       {"replay", moment.leg->page("", moment.at)}});
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
      {"moments", moments},
      {"hand_ins", d.hand_ins}};
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
