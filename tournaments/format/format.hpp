// SPDX-License-Identifier: MIT
//
// The format of a league, and the part of its schedule that is known before the first leg.
#pragma once

#include "core/base/names.hpp"
#include "tournaments/format/groups.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

enum class FormatKind { double_round_robin, round_robin, groups, knockout, swiss, ladder, nightly };

// A kind with its settings. Settings of other kinds are ignored.
struct Format {
  FormatKind kind = FormatKind::double_round_robin;
  int legs = legs_per_fixture;  // legs of each pair of teams, or of each tie of a knockout
  int groups = 2;
  int qualifiers = 2;  // teams of each group that enter the knockout
  bool third_place = true;
  int rounds = 0;     // rounds of a Swiss tournament; 0: usual_swiss_rounds()
  int sample = 4;     // the number of opponents of a new entry in a ladder
  int opponents = 0;  // opponents of each team in a night; 0: all other teams

  bool has_knockout() const { return kind == FormatKind::groups || kind == FormatKind::knockout; }

  // True if the league also takes entries after the start. The table of a ladder or
  // a nightly league counts only results of present entries, and ranks by points per leg.
  bool is_open_ended() const { return kind == FormatKind::ladder || kind == FormatKind::nightly; }
  int swiss_rounds(int teams) const;
};

// Returns why a number of teams cannot play the format; "" if they can.
std::string objection(const Format& format, int teams);

// Returns all fixtures of a round robin, of groups and of a knockout. Returns no fixtures for a
// Swiss tournament, a ladder or a nightly league, because their fixtures depend on results and
// entries. Precondition: objection() is "".
std::vector<Fixture> first_schedule(const Format& format, int teams);

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 7> enum_names<league::FormatKind>{
    "double_round_robin", "round_robin", "groups", "knockout", "swiss", "ladder", "nightly"};
static_assert(to_string(league::FormatKind::nightly) == "nightly");

}  // namespace mirocup
