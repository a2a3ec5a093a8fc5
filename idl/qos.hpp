// SPDX-License-Identifier: MIT
//
// The quality of service of each topic, as data. Both sides of a topic use the same row.
#pragma once

#include <cstdint>

namespace mirocup::idl {

struct TopicQos {
  const char* name;
  bool reliable;              // lost samples are sent again; else the next tick is the repair
  bool kept_for_late;         // who joins later still gets it
  std::int32_t depth;         // samples kept; 0: all
  std::int32_t most_samples;  // that a reader holds, 0: no limit; bounds what a flood can cost
};

// The state of a tick is overtaken by the next one before a repair could arrive.
inline constexpr TopicQos world_state{"WorldState", false, false, 1, 0};
inline constexpr TopicQos team_command{"TeamCommand", false, false, 4, 16};
inline constexpr TopicQos hello{"Hello", true, true, 1, 16};
inline constexpr TopicQos welcome{"Welcome", true, true, 1, 16};
inline constexpr TopicQos match_event{"MatchEvent", true, true, 0, 0};

}  // namespace mirocup::idl
