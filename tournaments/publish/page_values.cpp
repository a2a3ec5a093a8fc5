// SPDX-License-Identifier: MIT
#include "tournaments/publish/page_values.hpp"

#include "system/text.hpp"
#include "tournaments/publish/site_file.hpp"
#include "web/design/template.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace mirocup::league {

namespace {

constexpr double interval_width = 90.0;  // px
constexpr double interval_margin = 5.0;  // px

std::string_view word_of(char letter) {
  return letter == 'W' ? "won" : letter == 'D' ? "drawn" : "lost";
}

// What is worth saying of a leg besides its score.
std::string note_of(const Overview& o, const LegView& leg, bool has_several) {
  const PlayedLeg& played = *leg.played;
  if (played.end == LegEnd::full_time && !played.fault && played.ruling.empty()) return "";
  return (has_several ? "Leg " + std::to_string(leg.leg) + ": " : "") + end_in_words(o.state, leg);
}

// Returns the bounds of all intervals. The outermost twentieth at each end sticks out, since a team
// that is far from all others would make dots of their intervals.
std::pair<double, double> scale_of(const Ratings& ratings) {
  std::vector<double> lows, highs;
  for (const Strength& s : ratings.strengths) {
    lows.push_back(s.low);
    highs.push_back(-s.high);
  }
  const auto bound = [](std::vector<double>& ends) {
    const auto at = ends.begin() + static_cast<std::ptrdiff_t>(ends.size() / 20);
    std::nth_element(ends.begin(), at, ends.end());
    return std::min(0.0, *at);
  };
  return {bound(lows), -bound(highs)};
}

// An interval and its middle on the scale of all teams.
std::string interval_picture(const Overview& o, const Strength& s) {
  const auto [low, high] = scale_of(o.ratings);
  const auto x = [low = low, high = high](double value) {
    const double share = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
    return system::formatted("%.1f",
                             interval_margin + share * (interval_width - 2.0 * interval_margin));
  };
  return "<svg class=\"interval\" width=\"90\" height=\"14\" aria-hidden=\"true\"><path d=\"M" +
         x(0.0) + " 1V13\" class=\"mean\"/><path d=\"M" + x(s.low) + " 7H" + x(s.high) +
         "\"/><circle cx=\"" + x(s.value) + "\" cy=\"7\" r=\"3.5\"/></svg>";
}

}  // namespace

std::string filled_page(std::string_view name, const Json& values) {
  return web::filled(page_file, name, values);
}

Json page_values(const Overview& o, const std::string& root, const std::string& title) {
  const std::string& league = o.state.file.title;
  return {{"root", root},
          {"league", league},
          {"heading", title.empty() ? league : title},
          {"page_title", title.empty() ? league : title + " · " + league},
          {"has_knockout", o.state.file.format.has_knockout()},
          {"played", o.state.played()},
          {"legs", o.state.legs()}};
}

Json team_values(const Overview& o, int team, const std::string& root) {
  return {{"name", o.state.shown_name(team)},
          {"page", root + team_page_of(o.state.name(team))},
          {"index", team}};
}

std::string score_text(const LegView& leg, int team) {
  std::string text =
      std::to_string(leg.goals(team)) + ":" + std::to_string(leg.goals_against(team));
  if (leg.facts != nullptr && leg.facts->shoot_out) {
    const HomeAway& p = *leg.facts->shoot_out;
    const bool is_home = team == leg.home;
    text += " (" + std::to_string(is_home ? p.home : p.away) + ":" +
            std::to_string(is_home ? p.away : p.home) + " p)";
  }
  return text;
}

Json fixture_values(const Overview& o, const FixtureView& fixture, const std::string& root) {
  const Fixture& f = fixture.state->fixture;
  Json home = team_values(o, f.home, root);
  Json away = team_values(o, f.away, root);
  Json legs = Json::array();
  Json open = Json::array();
  Json notes = Json::array();
  int ahead = 0;  // goals of the home team
  for (const LegView* leg : fixture.legs) {
    if (leg->played == nullptr) {
      open.push_back("–");
      continue;
    }
    ahead += leg->goals(f.home) - leg->goals_against(f.home);
    const bool has = leg->has_replay();
    legs.push_back({{"score", score_text(*leg, f.home)},
                    {"number", leg->leg},
                    {"page", leg->page(root)},
                    {"record", has ? root + "../" + leg->played->record : ""}});
    if (const std::string note = note_of(o, *leg, fixture.legs.size() > 1); !note.empty())
      notes.push_back(note);
  }
  if (f.is_for_third_place()) notes.push_back("for the third place");
  if (fixture.state->is_annulled) notes.push_back("counts for nothing");
  const bool is_over = open.empty() && !legs.empty();
  home["won"] = is_over && ahead > 0;
  away["won"] = is_over && ahead < 0;
  if (is_over && f.part == Part::knockout) {
    // A shoot-out, or a lot, may have decided.
    const int winner = outcome(o.state, *fixture.state).winner;
    home["won"] = winner == f.home;
    away["won"] = winner == f.away;
    if (is_by_lot(o, *fixture.state))
      notes.push_back("level: decided by lot for " + o.state.shown_name(winner));
  }
  return {{"id", f.id()},   {"round", round_in_words(o.state, f)},
          {"home", home},   {"away", away},
          {"legs", legs},   {"open", open},
          {"notes", notes}, {"link", root + fixture_link(f)}};
}

Json fixtures_values(const Overview& o, const RoundView& round, const std::string& root) {
  Json fixtures = Json::array();
  for (const FixtureView& f : round.fixtures) fixtures.push_back(fixture_values(o, f, root));
  return fixtures;
}

Json leg_values(const Overview& o, const LegView& leg, const std::string& root,
                const std::string& why) {
  return {{"score", score_text(leg, leg.home)},
          {"page", leg.page(root)},
          {"home", o.state.shown_name(leg.home)},
          {"away", o.state.shown_name(leg.away)},
          {"where", leg.round + ", leg " + std::to_string(leg.leg)},
          {"why", why}};
}

Json form_values(const Overview& o, int team, std::size_t most, const std::string& root) {
  Json form = Json::array();
  const std::vector<std::size_t>& legs = o.decided_legs[team];
  for (std::size_t i = legs.size() - std::min(most, legs.size()); i < legs.size(); ++i) {
    const LegView& leg = o.legs[legs[i]];
    const char letter = leg.letter(team);
    form.push_back(
        {{"letter", std::string(1, letter)}, {"word", word_of(letter)}, {"page", leg.page(root)}});
  }
  return form;
}

Json strength_values(const Overview& o, int team) {
  const Strength& s = o.ratings.strengths[team];
  return {{"value", std::lround(s.value)},
          {"low", std::lround(s.low)},
          {"high", std::lround(s.high)},
          {"picture", interval_picture(o, s)}};
}

Json filter_values(const Overview& o) {
  std::vector<int> teams = all_teams(static_cast<int>(o.state.file.teams.size()));
  std::ranges::sort(teams, {}, [&o](int team) { return o.state.shown_name(team); });
  Json names = Json::array();
  for (const int team : teams)
    names.push_back({{"name", o.state.shown_name(team)}, {"index", team}});
  return names;
}

}  // namespace mirocup::league
