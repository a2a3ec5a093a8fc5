// SPDX-License-Identifier: MIT
//
// A 64-bit fingerprint of a run.
//
// In every tick the whole state is folded into the hash, bit by bit, so that two runs agree in the
// last hash only if they agreed in every bit of every tick. The hash reveals differences. Records
// carry a SHA-256 against forgery.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace mirocup {

class StateHash {
 public:
  StateHash() = default;
  explicit StateHash(std::uint64_t value) : value_(value) {}

  // Folds a word into the hash.
  void add(std::uint64_t word) {
    // Multiply-xorshift: each step is a bijection of the running value, so no difference is lost.
    value_ = (value_ ^ word) * 0xff51afd7ed558ccdULL;
    value_ ^= value_ >> 32;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

  std::uint64_t value() const { return value_; }

  bool operator==(const StateHash&) const = default;

 private:
  std::uint64_t value_ = 0x6d69726f63757031ULL;  // "mirocup1"
};

// Returns sixteen lower-case hexadecimal digits, as in records.
inline std::string to_hex(std::uint64_t value) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text(16, '0');
  for (int i = 15; i >= 0; --i, value >>= 4) text[i] = digits[value & 15];
  return text;
}

}  // namespace mirocup
