// SPDX-License-Identifier: MIT
#include "tournaments/publish/strength_history.hpp"

#include "system/text.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::league {

namespace {

using system::formatted;

constexpr std::size_t max_rounds = 24;
constexpr std::size_t max_curves = 64;  // teams

// In pixels.
constexpr int width = 720;
constexpr int height = 300;
constexpr int left = 44;    // for the numbers of the scale
constexpr int right = 150;  // for the names
constexpr int top = 12;
constexpr int bottom = 26;  // for the rounds
constexpr int label_gap = 15;
constexpr std::size_t named_curves = 8;  // more colours cannot be told apart

FixtureResults results_of(const FixtureView& fixture) {
  FixtureResults results;
  for (const LegView* leg : fixture.legs) {
    if (leg->has_replay()) results.push_back(leg->played->result);
  }
  return results;
}

class Chart {
 public:
  Chart(const Overview& o, const StrengthHistory& history, int highlighted)
      : o_(o), history_(history), highlighted_(highlighted) {
    for (const Ratings& ratings : history.after) {
      for (std::size_t team = 0; team < ratings.strengths.size(); ++team) {
        const Strength& s = ratings.strengths[team];
        const bool has_interval = static_cast<int>(team) == highlighted;
        low_ = std::min(low_, has_interval ? s.low : s.value);
        high_ = std::max(high_, has_interval ? s.high : s.value);
      }
    }
    low_ = std::floor(low_ / 100.0) * 100.0;
    high_ = std::ceil(high_ / 100.0) * 100.0;
  }

  std::string draw() {
    std::string svg = formatted(R"(<svg class="chart" viewBox="0 0 %d %d" role="img" aria-label=")",
                                highlighted_ < 0 ? width : width - right + left, height) +
                      label() + "\">\n";
    svg += scale();
    if (highlighted_ >= 0) {
      for (const TableRow& row : o_.table) {
        if (row.team != highlighted_ && row.rank > 0) svg += curve(row.team, "other");
      }
      svg += band(highlighted_) + curve(highlighted_, "own");
      return svg + "</svg>\n";
    }
    // The first teams of the table in front.
    for (std::size_t i = o_.table.size(); i-- > 0;) {
      if (o_.table[i].rank == 0) continue;
      const std::string css =
          i < named_curves ? "team c" + std::to_string(i) : std::string("other");
      svg += curve(o_.table[i].team, css);
    }
    return svg + names() + "</svg>\n";
  }

 private:
  std::string label() const {
    return highlighted_ >= 0
               ? "Strength of " + system::html_escaped(o_.state.shown_name(highlighted_)) +
                     " after each round, with its 95 % interval"
               : std::string("Strength of each team after each round");
  }

  int x(std::size_t round) const {
    const auto last = static_cast<int>(history_.rounds.size()) - 1;
    return left + (width - left - right) * static_cast<int>(round) / std::max(1, last);
  }

  int y(double strength) const {
    const double share = (high_ - strength) / std::max(1.0, high_ - low_);
    return top + static_cast<int>(std::lround(share * (height - top - bottom)));
  }

  std::string point(std::size_t round, double strength) const {
    return std::to_string(x(round)) + " " + std::to_string(y(strength));
  }

  std::string scale() const {
    std::string svg;
    const double step = high_ - low_ > 1000.0 ? 400.0 : high_ - low_ > 500.0 ? 200.0 : 100.0;
    for (double at = std::ceil(low_ / step) * step; at <= high_; at += step) {
      svg += formatted(
          "<path class=\"grid\" d=\"M%d %dH%d\"/><text class=\"scale\" x=\"%d\" "
          "y=\"%d\">%ld</text>\n",
          left, y(at), width - right, left - 6, y(at) + 4, std::lround(at));
    }
    const std::size_t last = history_.rounds.size() - 1;
    for (const std::size_t round : {std::size_t{0}, last}) {
      svg += formatted(R"(<text class="round%s" x="%d" y="%d">)", round == 0 ? "" : " end",
                       x(round), height - 6) +
             system::html_escaped(history_.rounds[round]) + "</text>\n";
    }
    return svg;
  }

  std::string curve(int team, const std::string& css) const {
    std::string path;
    for (std::size_t round = 0; round < history_.after.size(); ++round)
      path += (round == 0 ? "M" : "L") + point(round, value(round, team));
    return "<path class=\"" + css + "\" d=\"" + path + "\"><title>" +
           system::html_escaped(o_.state.shown_name(team)) + "</title></path>\n";
  }

  std::string band(int team) const {
    std::string path;
    const std::size_t rounds = history_.after.size();
    for (std::size_t round = 0; round < rounds; ++round)
      path += (round == 0 ? "M" : "L") + point(round, history_.after[round].strengths[team].high);
    for (std::size_t round = rounds; round-- > 0;)
      path += "L" + point(round, history_.after[round].strengths[team].low);
    return "<path class=\"band\" d=\"" + path + "Z\"/>\n";
  }

  // The names at the ends of the curves, moved apart, with the interval after the last round.
  std::string names() const {
    struct Label {
      std::size_t rank;
      int y;
    };
    std::vector<Label> labels;
    const std::size_t last = history_.after.size() - 1;
    for (std::size_t i = 0; i < std::min(named_curves, o_.table.size()); ++i) {
      if (o_.table[i].rank > 0) labels.push_back({i, y(value(last, o_.table[i].team))});
    }
    std::ranges::stable_sort(labels, {}, &Label::y);
    int free = top;
    for (Label& label : labels) {
      label.y = std::max(label.y, free);
      free = label.y + label_gap;
    }
    int end = height - bottom;
    for (std::size_t i = labels.size(); i-- > 0;) {
      labels[i].y = std::min(labels[i].y, end);
      end = labels[i].y - label_gap;
    }
    std::string svg;
    for (const Label& label : labels) {
      const int team = o_.table[label.rank].team;
      std::string name = o_.state.shown_name(team);
      if (name.size() > 16) name = name.substr(0, 15) + "…";
      svg += formatted(R"(<circle class="c%zu" cx="%d" cy="%d" r="4"/><text x="%d" y="%d">)",
                       label.rank, width - right + 12, label.y, width - right + 21, label.y + 4) +
             system::html_escaped(name) + "</text>\n";
    }
    return svg;
  }

  double value(std::size_t round, int team) const {
    return history_.after[round].strengths[team].value;
  }

  const Overview& o_;
  const StrengthHistory& history_;
  int highlighted_;
  double low_ = 0.0;
  double high_ = 0.0;
};

}  // namespace

StrengthHistory strength_history(const Overview& o, const std::vector<RoundView>& rounds) {
  StrengthHistory history;
  const std::size_t teams = o.state.file.teams.size();
  if (teams > max_curves) return history;
  std::size_t played = 0;
  for (const RoundView& round : rounds) played += round.decided > 0 ? 1 : 0;
  const std::size_t step = (played + max_rounds - 1) / max_rounds;
  std::vector<FixtureResults> results;
  std::vector<int> present(teams, no_entry);
  const bool is_ladder = o.state.file.format.kind == FormatKind::ladder;
  std::size_t number = 0;
  for (const RoundView& round : rounds) {
    for (const FixtureView& f : round.fixtures) {
      FixtureResults legs = results_of(f);
      for (const LegResult& leg : legs) {
        present[leg.home] = leg.home_entry;
        present[leg.away] = leg.away_entry;
      }
      if (!legs.empty()) results.push_back(std::move(legs));
    }
    if (round.decided == 0 || (++number != played && number % step != 0)) continue;
    history.rounds.push_back(round.title);
    history.after.push_back(number == played ? o.ratings
                            : o.state.file.format.is_open_ended()
                                ? rate_entries(present, results, is_ladder)
                                : rate(static_cast<int>(teams), results));
  }
  return history;
}

std::string strength_picture(const Overview& o, const StrengthHistory& history, int highlighted) {
  return history.empty() ? "" : Chart(o, history, highlighted).draw();
}

}  // namespace mirocup::league
