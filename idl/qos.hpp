// SPDX-License-Identifier: MIT
//
// The quality of service of each topic, as data. Both sides of a topic use the same row.
//
// Every history is bounded, so that nobody who reads slowly, or not at all, can hold up who writes.
#pragma once

#include <cstdint>

namespace mirocup::idl {

struct TopicQos {
  const char* name;
  bool reliable;               // lost samples are sent again; else the next tick is the repair
  bool kept_for_late;          // who joins later still gets it
  std::int32_t written_depth;  // samples that a writer keeps
  std::int32_t read_depth;     // samples that a reader keeps, of all writers together
};

// The state of a tick is overtaken by the next one before a repair could arrive.
inline constexpr TopicQos world_state{"WorldState", false, false, 1, 1};
// Room for what a stranger can push in between before the server looks.
inline constexpr TopicQos team_command{"TeamCommand", false, false, 1, 256};
inline constexpr TopicQos hello{"Hello", true, true, 1, 16};
inline constexpr TopicQos welcome{"Welcome", true, true, 16, 16};
inline constexpr TopicQos match_event{"MatchEvent", true, true, 1000, 1000};

}  // namespace mirocup::idl
