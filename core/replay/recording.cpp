// SPDX-License-Identifier: MIT
#include "core/replay/recording.hpp"

#include <utility>

namespace mirocup::replay {

Recording record(const match::Match& match, Trace trace) {
  return {.setup = match.setup(),
          .ticks = match.log(),
          .decisions = match.decisions(),
          .result = match.result(),
          .state_hash = match.state_hash(),
          .trace = std::move(trace)};
}

}  // namespace mirocup::replay
