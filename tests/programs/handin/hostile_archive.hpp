// SPDX-License-Identifier: MIT
//
// Archives as an attacker writes them, byte by byte: tar and zip with any names, links and sizes.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

namespace mirocup::test_support {

// One header of ustar, then the bytes. `type` is '0' for a file, '1' and '2' for links, '3' for a
// device; `size` is what the header claims.
inline std::string tar_entry(const std::string& name, const std::string& bytes, char type = '0',
                             const std::string& target = "", long long size = -1) {
  char header[512] = {};
  const auto put = [&header](int at, const std::string& text) {
    std::memcpy(header + at, text.data(), text.size());
  };
  put(0, name.substr(0, 100));
  put(100, "0000644");
  put(108, "0000000");
  put(116, "0000000");
  char number[32];
  std::snprintf(number, sizeof number, "%011llo",
                size < 0 ? static_cast<long long>(bytes.size()) : size);
  put(124, number);
  put(136, "00000000000");
  header[156] = type;
  put(157, target.substr(0, 100));
  put(257, "ustar");
  put(263, "00");
  std::memset(header + 148, ' ', 8);
  unsigned sum = 0;
  for (const char c : header) sum += static_cast<unsigned char>(c);
  std::snprintf(number, sizeof number, "%06o", sum);
  put(148, number);
  std::string entry(header, sizeof header);
  entry += bytes;
  entry.resize((entry.size() + 511) / 512 * 512);
  return entry;
}

inline std::string tar_of(const std::string& entries) {
  return entries + std::string(1024, '\0');
}

}  // namespace mirocup::test_support
