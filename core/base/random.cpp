// SPDX-License-Identifier: MIT
#include "core/base/random.hpp"

#include "core/base/assert.hpp"

namespace mirocup {

namespace {
constexpr std::uint64_t rotate_left(std::uint64_t x, int k) {
  return (x << k) | (x >> (64 - k));
}
}  // namespace

Random::Random(std::uint64_t seed) : state_{} {
  // splitmix64 of consecutive inputs is never zero for all four words, a state that xoshiro cannot
  // leave.
  for (auto& word : state_) {
    word = mix_seed(seed);
    seed += 0x9e3779b97f4a7c15ULL;
  }
}

std::uint64_t Random::next() {
  const std::uint64_t result = rotate_left(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = rotate_left(state_[3], 45);
  return result;
}

double Random::uniform() {
  return static_cast<double>(next() >> 11) * 0x1.0p-53;
}

std::uint64_t Random::below(std::uint64_t bound) {
  MIROCUP_ASSERT(bound > 0);
  // Numbers below 2^64 mod bound would make small remainders more likely, so they are drawn again.
  const std::uint64_t unfair = (0 - bound) % bound;
  std::uint64_t x = next();
  while (x < unfair) x = next();
  return x % bound;
}

}  // namespace mirocup
