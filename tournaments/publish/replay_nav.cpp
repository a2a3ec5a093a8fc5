// SPDX-License-Identifier: MIT
#include "tournaments/publish/replay_nav.hpp"

#include "record/json_reader.hpp"
#include "system/text.hpp"
#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/replay_pages.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

namespace {

constexpr std::string_view begin_mark = "<!--league-->";
constexpr std::string_view end_mark = "<!--/league-->";

Json link_to(const Overview& o, const LegView* leg) {
  if (leg == nullptr) return false;
  return {{"page", leg->page("../")},
          {"pair", o.state.shown_name(leg->home) + " – " + o.state.shown_name(leg->away)}};
}

std::string nav(const Overview& o, const std::string& record) {
  const FixtureState* f = fixture_of_record(o.state, record);
  if (f == nullptr || !f->fixture.has_both()) return "";
  const LegView* own = nullptr;
  const LegView* before = nullptr;
  const LegView* after = nullptr;
  for (const LegView& leg : o.legs) {
    if (!leg.has_replay() || (leg.is_pruned && leg.played->record != record)) continue;
    if (own != nullptr) {
      after = &leg;
      break;
    }
    if (leg.played->record == record) {
      own = &leg;
    } else {
      before = &leg;
    }
  }
  std::string where = round_in_words(o.state, f->fixture);
  if (own != nullptr) where += ", leg " + std::to_string(own->leg);
  std::string note;
  if (own == nullptr) {
    note = "This attempt is void; the leg was or will be played again.";
  } else if (!own->played->ruling.empty()) {
    note = "A ruling decided this leg " + score_text(*own, own->home) + ": " + own->played->ruling;
  }
  return filled_page("replay_nav.html", {{"league", o.state.file.title},
                                         {"round_page", fixture_link(f->fixture)},
                                         {"where", where},
                                         {"home", team_values(o, f->fixture.home, "../")},
                                         {"away", team_values(o, f->fixture.away, "../")},
                                         {"before", link_to(o, own == nullptr ? nullptr : before)},
                                         {"after", link_to(o, after)},
                                         {"note", note}});
}

// Puts a text in place of what stands between two others, after `from`. Returns where it ends, or
// npos if there is no such place.
std::size_t put_between(std::string& page, std::size_t from, std::string_view before,
                        std::string_view after, const std::string& text) {
  const std::size_t at = from == std::string::npos ? from : page.find(before, from);
  if (at == std::string::npos) return at;
  const std::size_t first = at + before.size();
  const std::size_t end = page.find(after, first);
  if (end == std::string::npos) return end;
  page.replace(first, end - first, text);
  return first + text.size();
}

// The program that makes a page knows the names of the record. Puts those that people know into
// title, scoreboard and data of the page, which may have others from before.
void put_shown_names(std::string& page, const LeagueState& state, const FixtureState& f, int leg) {
  const int blue = blue_team(f.fixture, leg);
  const int yellow = blue == f.fixture.home ? f.fixture.away : f.fixture.home;
  const std::string names[] = {state.shown_name(blue), state.shown_name(yellow)};
  const std::string title = system::html_escaped(names[0] + " – " + names[1]);
  put_between(page, 0, "<title>", "</title>", title);
  std::size_t at = put_between(page, 0, "<h1 class=\"visually-hidden\">", "</h1>", title);
  for (const std::string& name : names)
    at = put_between(page, at, "<span class=\"name\">", "</span>", system::html_escaped(name));
  at = page.find("<script type=\"application/json\" id=\"leg\">");
  if (at != std::string::npos) at = page.find("\"teams\":", at);
  // The name is the first key of a team, and in a text of JSON each quote is escaped.
  for (const std::string colour : {"blue", "yellow"}) {
    std::string text = record::json_text(Json(names[colour == "blue" ? 0 : 1]));
    for (std::size_t less = text.find('<'); less != std::string::npos; less = text.find('<'))
      text.replace(less, 1, "\\u003c");
    at = put_between(page, at, "\"" + colour + "\":{\"name\":", ",\"kind\":", text);
  }
}

}  // namespace

std::string with_league_links(std::string page, const Overview& o, const std::string& record) {
  const std::size_t begin = page.find(begin_mark);
  if (begin == std::string::npos) return page;
  const std::size_t inside = begin + begin_mark.size();
  const std::size_t end = page.find(end_mark, inside);
  if (end == std::string::npos) return page;
  page.replace(inside, end - inside, nav(o, record));
  const FixtureState* f = fixture_of_record(o.state, record);
  const std::size_t version = record.rfind('-');
  if (f == nullptr || !f->fixture.has_both() || version == std::string::npos) return page;
  put_shown_names(page, o.state, *f, record[version - 1] - '0');
  return page;
}

}  // namespace mirocup::league
