// SPDX-License-Identifier: MIT
//
// Every number of the laws, said once. A preset is a set of them; a league may change single ones,
// and the match record says which were used, so that a disputed call can be judged again with
// others.
//
// Sources: the FIRA MiroSot rule texts for what they state; where they leave a judgement to a
// person ("stalemate", "as judged by the referee"), common practice of automatic referees.
// docs/laws.md says which is which.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <limits>
#include <string_view>

namespace mirocup::referee {

enum class Preset { mirosot, simurosot, vsss };

// Group matches may end level.
enum class Stage { group, knockout };

inline constexpr double off =
    std::numeric_limits<double>::infinity();  // a limit that is never reached

// Seconds and metres.
struct Rules {
  Preset preset = Preset::mirosot;
  double half_s = 300.0;                  // length of a half, effective time
  int mercy_goal_difference = 10;         // a lead of so many ends the match; 0: off
  double stalemate_s = 10.0;              // the ball stays within the radius for so long
  double stalemate_radius_m = 0.075;      // one robot side
  double keeper_hold_s = 10.0;            // the ball stays uncontested in a goal area
  double contested_m = 0.1125;            // an opponent's centre this near to the ball contests it
  bool kickoff_backward_required = true;  // the ball goes towards the taker's own side first
  double kickoff_move_m = 0.05;           // when it has moved so far, its side is judged
  double kickoff_limit_s = 5.0;           // until the ball is touched
  double ready_s = 0.33;   // between placement and whistle; robots stand, teams see where
  int forfeit_goals = 10;  // a forfeit counts as 0 to so many
};

// The rules of a preset.
Rules make_rules(Preset preset);

}  // namespace mirocup::referee

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<referee::Preset>{"mirosot", "simurosot",
                                                                             "vsss"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<referee::Stage>{"group", "knockout"};

}  // namespace mirocup
