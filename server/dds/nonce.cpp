// SPDX-License-Identifier: MIT
#include "server/dds/nonce.hpp"

#include "server/dds/wall_time.hpp"

#include <sys/random.h>

namespace mirocup::dds {

std::uint64_t random_nonce() {
  std::uint64_t number = 0;
  while (number == 0) {
    if (getrandom(&number, sizeof number, 0) != sizeof number) {
      number = static_cast<std::uint64_t>(WallClock::now().time_since_epoch().count());
    }
  }
  return number;
}

}  // namespace mirocup::dds
