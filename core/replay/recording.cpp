// SPDX-License-Identifier: MIT
#include "core/replay/recording.hpp"

namespace mirocup::replay {

Recording record(const match::Match& match) {
  return {.setup = match.setup(),
          .ticks = match.log(),
          .decisions = match.decisions(),
          .result = match.result(),
          .state_hash = match.state_hash()};
}

}  // namespace mirocup::replay
