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

std::uint64_t connection_nonce() {
  static const std::uint64_t process = random_nonce();
  constexpr std::uint64_t connection = 0xffffU;
  const std::uint64_t number = (process & ~connection) | (random_nonce() & connection);
  return number == 0 ? process : number;
}

}  // namespace mirocup::dds
