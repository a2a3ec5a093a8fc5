// SPDX-License-Identifier: MIT
#include "server/dds/nonce.hpp"

#include "system/digest.hpp"

#include <cstring>

namespace mirocup::dds {

std::uint64_t random_nonce() {
  std::uint64_t number = 0;
  while (number == 0)
    std::memcpy(&number, system::random_bytes(sizeof number).data(), sizeof number);
  return number;
}

std::uint64_t connection_nonce() {
  static const std::uint64_t process = random_nonce();
  constexpr std::uint64_t connection = 0xffffU;
  const std::uint64_t number = (process & ~connection) | (random_nonce() & connection);
  return number == 0 ? process : number;
}

}  // namespace mirocup::dds
