// SPDX-License-Identifier: MIT
//
// Which format a league has, and the part of its schedule that is known before anything is played.
#pragma once

#include "core/base/names.hpp"
#include "tournaments/format/groups.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

enum class FormatKind { double_round_robin, round_robin, groups, knockout, swiss, ladder };

// What does not concern a format's kind is not looked at.
struct Format {
  FormatKind kind = FormatKind::double_round_robin;
  int legs = legs_per_fixture;  // of each pair in a round robin or a group, of a tie in a knockout
  int groups = 2;
  int qualifiers = 2;  // of each group
  bool third_place = true;
  int rounds = 0;  // Swiss; 0: usual_swiss_rounds()
  int sample = 4;  // ladder: opponents of a new entry

  bool has_knockout() const { return kind == FormatKind::groups || kind == FormatKind::knockout; }
  int swiss_rounds(int teams) const;
};

// Why this many teams cannot play it; "" if they can.
std::string objection(const Format& format, int teams);

// Everything of a round robin, groups and a knockout; nothing of a Swiss tournament or a ladder.
std::vector<Fixture> first_schedule(const Format& format, int teams);

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 6> enum_names<league::FormatKind>{
    "double_round_robin", "round_robin", "groups", "knockout", "swiss", "ladder"};

}  // namespace mirocup
