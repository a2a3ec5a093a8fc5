// SPDX-License-Identifier: MIT
#include "tournaments/publish/bracket_svg.hpp"

#include "system/markup.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

// In pixels.
constexpr int box_width = 210;
constexpr int box_height = 52;
constexpr int column = 262;  // from one round to the next
constexpr int row = 68;      // of the first round
constexpr int margin = 8;
constexpr int head = 28;

struct Point {
  int x;
  int y;
};

class BracketPicture {
 public:
  explicit BracketPicture(const LeagueState& state) : state_(state) {
    for (const FixtureState& f : state.fixtures) {
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
    const std::string size = " width=\"" + std::to_string(width) + "\" height=\"" +
                             std::to_string(height + margin) + "\"";
    return "<svg class=\"bracket\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
           "aria-label=\"Bracket\"" +
           size + ">\n" + lines_ + boxes_ + "</svg>\n";
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
    boxes_ += "<a href=\"#" + f.fixture.id() + "\"><g>\n";
    boxes_ += "<rect x=\"" + std::to_string(at.x) + "\" y=\"" + std::to_string(at.y) +
              "\" width=\"" + std::to_string(box_width) + "\" height=\"" +
              std::to_string(box_height) + "\" rx=\"4\"/>\n";
    team(f, f.fixture.home, o, {at.x, at.y + 21});
    team(f, f.fixture.away, o, {at.x, at.y + 43});
    boxes_ += "</g></a>\n";
    if (f.fixture.is_for_third_place()) text("round", {at.x, at.y - 6}, "Third place");
    for (const TeamSource& source : {f.fixture.home_source, f.fixture.away_source}) {
      if (source.kind != TeamSource::Kind::winner) continue;
      const Fixture& before = state_.fixtures[source.index].fixture;
      const Point from = place_of(before.round, before.number);
      const int x = (from.x + box_width + at.x) / 2;
      lines_ += "<path d=\"M" + std::to_string(from.x + box_width) + " " +
                std::to_string(from.y + box_height / 2) + "H" + std::to_string(x) + "V" +
                std::to_string(at.y + box_height / 2) + "H" + std::to_string(at.x) + "\"/>\n";
    }
  }

  void team(const FixtureState& f, int team, const TieOutcome& o, Point at) {
    const std::string name = team >= 0 ? state_.name(team) : team == unknown_team ? "" : "–";
    const char* style = team >= 0 && team == o.winner  ? "won"
                        : team >= 0 && team == o.loser ? "lost"
                                                       : "open";
    text(style, {at.x + 8, at.y}, name);
    if (team < 0 || f.decided() == 0) return;
    std::string goals;
    for (int i = 0; i < f.needed(); ++i) {
      const auto& leg = f.legs[i].played;
      if (!leg) continue;
      goals +=
          (goals.empty() ? "" : " ") +
          std::to_string(team == f.fixture.home ? leg->result.home_goals : leg->result.away_goals);
    }
    text((std::string(style) + " goals").c_str(), {at.x + box_width - 8, at.y}, goals);
  }

  void text(const char* style, Point at, const std::string& words) {
    boxes_ += std::string("<text class=\"") + style + "\" x=\"" + std::to_string(at.x) + "\" y=\"" +
              std::to_string(at.y) + "\">" + system::html_escaped(words) + "</text>\n";
  }

  const LeagueState& state_;
  int rounds_ = 0;
  bool has_third_ = false;
  std::string lines_;
  std::string boxes_;
};

}  // namespace

std::string bracket_svg(const LeagueState& state) {
  return BracketPicture(state).draw();
}

}  // namespace mirocup::league
