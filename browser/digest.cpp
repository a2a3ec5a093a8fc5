// SPDX-License-Identifier: MIT
//
// system::sha256() of the module, which has no OpenSSL: FIPS 180-4, section 6.2.
#include "system/digest.hpp"

#include "system/text.hpp"

#include <array>
#include <bit>
#include <cstdint>

namespace mirocup::system {

namespace {

using Words = std::array<std::uint32_t, 8>;

// The first 32 bits of the fractional parts of the cube roots of the first 64 primes, and of the
// square roots of the first eight. Made with whole numbers, so no digit can be mistyped.
std::uint32_t root_bits(std::uint32_t prime, int power) {
  std::uint64_t low = 0;
  for (int bit = 34; bit >= 0; --bit) {  // the greatest n with n^power <= prime * 2^(32 power)
    const std::uint64_t n = low | (std::uint64_t{1} << bit);
    unsigned __int128 most = prime;
    unsigned __int128 value = n;
    most <<= 32 * power;
    for (int i = 1; i < power; ++i) value *= n;
    if (value <= most) low = n;
  }
  return static_cast<std::uint32_t>(low);
}

struct Constants {
  std::array<std::uint32_t, 64> rounds{};
  Words start{};
  Constants() {
    std::size_t found = 0;
    for (std::uint32_t n = 2; found < rounds.size(); ++n) {
      bool is_prime = true;
      for (std::uint32_t d = 2; d * d <= n; ++d) is_prime = is_prime && n % d != 0;
      if (!is_prime) continue;
      if (found < start.size()) start[found] = root_bits(n, 2);
      rounds[found++] = root_bits(n, 3);
    }
  }
};

void add_block(Words& state, const unsigned char* block, const Constants& constants) {
  std::array<std::uint32_t, 64> w{};
  for (std::size_t i = 0; i < 64; ++i) {
    if (i < 16) {
      for (std::size_t b = 0; b < 4; ++b) w[i] = (w[i] << 8) | block[4 * i + b];
      continue;
    }
    const std::uint32_t a = w[i - 15];
    const std::uint32_t b = w[i - 2];
    w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3)) + w[i - 7] +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10));
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t t1 = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                             ((e & f) ^ (~e & g)) + constants.rounds[i] + w[i];
    const std::uint32_t t2 =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + t1, d = c, c = b, b = a, a = t1 + t2;
  }
  const Words change{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < state.size(); ++i) state[i] += change[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  static const Constants constants;
  std::string padded(bytes);
  padded += '\x80';
  padded.resize((padded.size() + 8 + 63) / 64 * 64 - 8, '\0');
  const std::uint64_t bits = std::uint64_t{8} * bytes.size();
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(bits >> shift);
  Words state = constants.start;
  for (std::size_t at = 0; at < padded.size(); at += 64) {
    add_block(state, reinterpret_cast<const unsigned char*>(padded.data()) + at, constants);
  }
  std::string digits;
  for (const std::uint32_t word : state) digits += formatted("%08x", static_cast<unsigned>(word));
  return digits;
}

}  // namespace mirocup::system
