// SPDX-License-Identifier: MIT
//
// Seeded random numbers that are the same everywhere.
//
// The generator is xoshiro256** (Blackman and Vigna 2018) seeded by splitmix64; the distributions
// are our own because those of the standard library differ between libraries. Named "mirocup-1" in
// records.
#pragma once

#include <array>
#include <cstdint>

namespace mirocup {

// One step of splitmix64: a good 64-bit hash of a 64-bit number. Derives independent seeds from
// one.
constexpr std::uint64_t mix_seed(std::uint64_t seed) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

class Random {
 public:
  explicit Random(std::uint64_t seed);

  std::uint64_t next();

  // In [0, 1), a multiple of 2^-53.
  double uniform();

  // In [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // In 0 .. bound-1, without bias; bound > 0.
  std::uint64_t below(std::uint64_t bound);

  bool coin() { return (next() >> 63) != 0; }

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace mirocup
