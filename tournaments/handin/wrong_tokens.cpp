// SPDX-License-Identifier: MIT
#include "tournaments/handin/wrong_tokens.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cstdio>

namespace mirocup::league {

std::int64_t WrongTokens::note(const std::string& address, std::int64_t now) {
  const std::string network = network_of(address);
  if (!addresses_.contains(network) && addresses_.size() >= max_addresses) {
    if (now > swept_) {
      std::erase_if(addresses_,
                    [now](const auto& known) { return now - known.second.last > forgotten_after; });
      swept_ = now;
    }
    // So many addresses at once are no class: nobody of them is looked at soon.
    if (addresses_.size() >= max_addresses) return max_wait;
  }
  Count& count = addresses_[network];
  if (now - count.last > forgotten_after) count = {};
  if (now < count.waits) return count.waits - now;
  ++count.wrong;
  count.last = now;
  if (count.wrong <= free_tries) return 0;
  const int doubled = std::min(count.wrong - free_tries - 1, 10);
  const std::int64_t wait = std::min(max_wait, std::int64_t{1} << doubled);
  count.waits = now + wait;
  return wait;
}

std::string network_of(const std::string& address) {
  in6_addr v6{};
  if (inet_pton(AF_INET6, address.c_str(), &v6) != 1) return address;
  std::string network;
  constexpr int network_bytes = 8;
  for (int i = 0; i < network_bytes; ++i) {
    std::array<char, 4> digits;
    std::snprintf(digits.data(), digits.size(), "%02x", v6.s6_addr[i]);
    network += digits.data();
  }
  return network;
}

}  // namespace mirocup::league
