// SPDX-License-Identifier: MIT
#include "system/text.hpp"
#include "tournaments/publish/rounds.hpp"

#include <algorithm>
#include <map>

namespace mirocup::league {

namespace {

using system::formatted;

// In pixels.
constexpr int box_width = 230;
constexpr int box_height = 52;
constexpr int column = 282;  // from one round to the next
constexpr int row = 68;      // of the first round
constexpr int margin = 8;
constexpr int letter_width = 9;      // of a name, about
constexpr int leg_width = 26;        // of the goals of a leg
constexpr int shoot_out_width = 56;  // with the score of a shoot-out
constexpr int head = 28;

struct Point {
  int x;
  int y;
};

class BracketPicture {
 public:
  explicit BracketPicture(const Overview& overview) : o_(overview), state_(overview.state) {
    for (const LegView& leg : o_.legs) legs_[leg.fixture].push_back(&leg);
    for (const FixtureState& f : state_.fixtures) {
      if (f.fixture.part != Part::knockout) continue;
      rounds_ = std::max(rounds_, f.fixture.round);
      has_third_ = has_third_ || f.fixture.is_for_third_place();
    }
  }

  std::string draw() {
    if (rounds_ == 0) return "";
    const int places = 1 << (rounds_ - 1);
    const int height = std::max(head + places * row, has_third_ ? third().y + row : 0);
    const int width = margin + (rounds_ - 1) * column + box_width + margin;
    for (const FixtureState& f : state_.fixtures) {
      if (f.fixture.part == Part::knockout) tie(f);
    }
    return formatted(
               R"(<svg class="bracket" xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" )"
               "viewBox=\"0 0 %d %d\">\n",
               width, height + margin, width, height + margin) +
           lines_ + boxes_ + "</svg>\n";
  }

 private:
  Point third() const {
    const Point final = place_of(rounds_, 1);
    return {final.x, final.y + std::max(2 * row, row + head)};
  }

  // The upper left corner of a tie's box.
  Point place_of(int round, int number) const {
    const int height = row << (round - 1);
    return {margin + (round - 1) * column,
            head + height * (number - 1) + (height - box_height) / 2};
  }

  void tie(const FixtureState& f) {
    const Point at =
        f.fixture.is_for_third_place() ? third() : place_of(f.fixture.round, f.fixture.number);
    const TieOutcome o = outcome(state_, f);
    boxes_ += "<a href=\"" + fixture_link(f.fixture) + "\" aria-label=\"" +
              system::html_escaped(name_of(f.fixture.home) + " – " + name_of(f.fixture.away)) +
              formatted("\"><rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"8\"/></a>\n",
                        at.x, at.y, box_width, box_height);
    team(f.fixture.home, o, {at.x, at.y + 21}, name_room(f));
    team(f.fixture.away, o, {at.x, at.y + 43}, name_room(f));
    if (f.fixture.has_both()) goals(f, o, at);
    if (f.fixture.is_for_third_place()) text("round", {at.x, at.y - 6}, "Third place");
    if (is_by_lot(o_, f)) text("round", {at.x + box_width - 48, at.y - 3}, "by lot");
    for (const TeamSource& source : {f.fixture.home_source, f.fixture.away_source}) {
      if (source.kind != TeamSource::Kind::winner) continue;
      const Fixture& before = state_.fixtures[source.index].fixture;
      const Point from = place_of(before.round, before.number);
      const int x = (from.x + box_width + at.x) / 2;
      lines_ += formatted("<path d=\"M%d %dH%dV%dH%d\"/>\n", from.x + box_width,
                          from.y + box_height / 2, x, at.y + box_height / 2, at.x);
    }
  }

  std::string name_of(int team) const {
    return team >= 0 ? state_.shown_name(team) : team == unknown_team ? "" : "–";
  }

  static const char* style_of(int team, const TieOutcome& o) {
    return team >= 0 && team == o.winner ? "won" : team >= 0 && team == o.loser ? "lost" : "open";
  }

  // The name, cut where the goals begin. Its own picture hides what wide letters still take.
  void team(int team, const TieOutcome& o, Point at, int room) {
    const std::string name = name_of(team);
    int left = room / letter_width;
    std::size_t end = 0;
    while (end < name.size() && left > 0) {
      ++end;
      while (end < name.size() && (name[end] & 0xC0) == 0x80) ++end;  // whole characters of UTF-8
      --left;
    }
    boxes_ +=
        formatted(R"(<svg x="%d" y="%d" width="%d" height="22">)", at.x + 10, at.y - 17, room);
    text(style_of(team, o), {0, 17}, end < name.size() ? name.substr(0, end) + "…" : name);
    boxes_ += "</svg>\n";
  }

  // The width of the goals of a leg.
  int leg_room(const LegView& leg) const {
    return leg.facts != nullptr && leg.facts->shoot_out ? shoot_out_width : leg_width;
  }

  int name_room(const FixtureState& f) {
    int room = box_width - 20;
    for (const LegView* leg : legs_[f.fixture.id()]) {
      if (leg->played != nullptr) room -= leg_room(*leg);
    }
    return room;
  }

  // A column for each leg, the last at the right edge; both numbers are one link to the replay.
  void goals(const FixtureState& f, const TieOutcome& o, Point at) {
    int x = at.x + box_width - 10;
    const auto& legs = legs_[f.fixture.id()];
    for (std::size_t i = legs.size(); i-- > 0;) {
      const LegView& leg = *legs[i];
      if (leg.played == nullptr) continue;
      const auto& shoot_out = leg.facts == nullptr ? no_shoot_out_ : leg.facts->shoot_out;
      const bool has_page = !leg.page().empty();
      if (has_page) {
        boxes_ += formatted(
            R"(<a class="leg" href="%s" aria-label="Leg %d: %d to %d"><rect class="hit" x="%d" )"
            R"(y="%d" width="%d" height="%d"/>)",
            leg.page().c_str(), leg.leg, leg.goals(leg.home), leg.goals(leg.away),
            x + 4 - leg_room(leg), at.y + 2, leg_room(leg), box_height - 4);
      }
      for (const bool is_home : {true, false}) {
        const int team = is_home ? leg.home : leg.away;
        std::string number = std::to_string(leg.goals(team));
        if (shoot_out)
          number += " (" + std::to_string(is_home ? shoot_out->home : shoot_out->away) + ")";
        text((std::string(style_of(team, o)) + " goals").c_str(), {x, at.y + (is_home ? 21 : 43)},
             number);
      }
      if (has_page) boxes_ += "</a>\n";
      x -= leg_room(leg);
    }
  }

  void text(const char* style, Point at, const std::string& words) {
    boxes_ += formatted(R"(<text class="%s" x="%d" y="%d">)", style, at.x, at.y) +
              system::html_escaped(words) + "</text>\n";
  }

  const Overview& o_;
  const LeagueState& state_;
  const std::optional<HomeAway> no_shoot_out_;
  std::map<std::string, std::vector<const LegView*>> legs_;
  int rounds_ = 0;
  bool has_third_ = false;
  std::string lines_;
  std::string boxes_;
};

}  // namespace

std::string bracket_svg(const Overview& overview) {
  return BracketPicture(overview).draw();
}

}  // namespace mirocup::league
