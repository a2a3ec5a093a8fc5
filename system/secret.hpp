// SPDX-License-Identifier: MIT
//
// The comparison of a secret, such as a token, a key or a digest of these, with a text of a
// stranger.
#pragma once

#include <cstddef>
#include <string_view>

namespace mirocup::system {

// The time of the comparison tells a stranger whether the lengths differ, and nothing else.
inline bool is_same_secret(std::string_view secret, std::string_view sent) {
  if (secret.size() != sent.size()) return false;
  volatile unsigned char difference = 0;  // volatile: no compiler ends the loop early
  for (std::size_t i = 0; i < secret.size(); ++i)
    difference = difference | static_cast<unsigned char>(secret[i] ^ sent[i]);
  return difference == 0;
}

}  // namespace mirocup::system
