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
inline constexpr TopicQos world_state{.name = "WorldState",
                                      .reliable = false,
                                      .kept_for_late = false,
                                      .written_depth = 1,
                                      .read_depth = 1};
// Room for what a stranger can push in between before the server looks.
inline constexpr TopicQos team_command{.name = "TeamCommand",
                                       .reliable = false,
                                       .kept_for_late = false,
                                       .written_depth = 1,
                                       .read_depth = 256};
inline constexpr TopicQos hello{
    .name = "Hello", .reliable = true, .kept_for_late = true, .written_depth = 1, .read_depth = 16};
inline constexpr TopicQos welcome{.name = "Welcome",
                                  .reliable = true,
                                  .kept_for_late = true,
                                  .written_depth = 16,
                                  .read_depth = 16};
inline constexpr TopicQos match_event{.name = "MatchEvent",
                                      .reliable = true,
                                      .kept_for_late = true,
                                      .written_depth = 1000,
                                      .read_depth = 1000};

}  // namespace mirocup::idl
