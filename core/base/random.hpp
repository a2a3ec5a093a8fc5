// SPDX-License-Identifier: MIT
//
// Seeded random numbers that are the same on every machine.
//
// The generator is xoshiro256** (Blackman and Vigna 2018), seeded by splitmix64. The distributions
// are our own, because std:: distributions differ between standard libraries. Records name this
// generator "mirocup-1".
#pragma once

#include <array>
#include <cstdint>

namespace mirocup {

// Returns one step of splitmix64, a good 64-bit hash of a 64-bit number. Derives independent seeds
// from one seed.
constexpr std::uint64_t mix_seed(std::uint64_t seed) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// A generator. A copy gives the same further numbers as its original; neither affects the other.
class Random {
 public:
  Random() : Random(0) {}
  explicit Random(std::uint64_t seed);

  // Returns 64 random bits.
  std::uint64_t next();

  // Returns a number in [0, 1), a multiple of 2^-53.
  double uniform();

  // Returns a number in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // Returns an integer in 0 .. bound-1, without bias; bound > 0.
  std::uint64_t below(std::uint64_t bound);

  // Returns true or false with equal probability.
  bool coin() { return (next() >> 63) != 0; }

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace mirocup
