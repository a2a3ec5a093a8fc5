// SPDX-License-Identifier: MIT
//
// The quality of service of each topic as data. The writers and the readers of a topic use the same
// row.
//
// Every history is bounded, so that a slow or stuck reader cannot hold up a writer.
#pragma once

#include <cstdint>

namespace mirocup::idl {

struct TopicQos {
  const char* name;
  bool reliable;               // true: lost samples are sent again
  bool kept_for_late;          // true: a reader that joins later still gets the samples
  std::int32_t written_depth;  // number of samples that a writer keeps
  std::int32_t read_depth;     // number of samples that a reader keeps, from all writers together
};

// Not reliable, because the state of the next tick arrives before a lost state could be sent again.
inline constexpr TopicQos world_state{.name = "WorldState",
                                      .reliable = false,
                                      .kept_for_late = false,
                                      .written_depth = 1,
                                      .read_depth = 1};
// The reader has room for the samples that a stranger can write before the server reads.
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
inline constexpr TopicQos match_info{.name = "MatchInfo",
                                     .reliable = true,
                                     .kept_for_late = true,
                                     .written_depth = 1,
                                     .read_depth = 1};
inline constexpr TopicQos match_event{.name = "MatchEvent",
                                      .reliable = true,
                                      .kept_for_late = true,
                                      .written_depth = 1000,
                                      .read_depth = 1000};

}  // namespace mirocup::idl
