// SPDX-License-Identifier: MIT
#include "tournaments/publish/replay_nav.hpp"

#include "tournaments/publish/page_values.hpp"
#include "tournaments/publish/replay_pages.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

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

}  // namespace

std::string with_league_links(std::string page, const Overview& o, const std::string& record) {
  const std::size_t begin = page.find(begin_mark);
  if (begin == std::string::npos) return page;
  const std::size_t inside = begin + begin_mark.size();
  const std::size_t end = page.find(end_mark, inside);
  if (end == std::string::npos) return page;
  return page.replace(inside, end - inside, nav(o, record));
}

}  // namespace mirocup::league
