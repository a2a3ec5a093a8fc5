// SPDX-License-Identifier: MIT
//
// Catches a reader that takes memory before it knows how much all arrays of an archive need.
#include "labs/training/policy/npz.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace mirocup::policy {
namespace {

void put(std::string& bytes, std::uint64_t value, int width) {
  for (int i = 0; i < width; ++i, value >>= 8) bytes += static_cast<char>(value);
}

// An archive whose arrays a, b, ... say that they unpack to so many bytes. Two bytes stand for
// each, so whoever unpacks one finds it damaged.
std::string archive_of(std::size_t count, std::uint64_t size) {
  std::string files, directory;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = std::string(1, static_cast<char>('a' + i)) + ".npy";
    std::string about;
    put(about, 20, 2);  // version that unpacks it
    put(about, 0, 2);   // flags
    put(about, 8, 2);   // deflate
    put(about, 0, 4);   // time
    put(about, 0, 4);   // checksum
    put(about, 2, 4);
    put(about, size, 4);
    put(about, name.size(), 2);
    put(about, 0, 2);
    const std::size_t at = files.size();
    files += "PK\3\4" + about + name + "\x03";
    files += '\0';
    directory += std::string("PK\1\2\x14", 5) + '\0' + about;
    put(directory, 0, 2 + 2 + 2 + 4);
    put(directory, at, 4);
    directory += name;
  }
  std::string end = "PK\5\6";
  put(end, 0, 4);
  put(end, count, 2);
  put(end, count, 2);
  put(end, directory.size(), 4);
  put(end, files.size(), 4);
  put(end, 0, 2);
  return files + directory + end;
}

TEST(Npz, AllArraysTogetherHaveABound) {
  constexpr std::uint64_t mebibyte = 1u << 20;
  const auto four = read_npz(archive_of(4, 64 * mebibyte), "p.npz");
  ASSERT_FALSE(four);
  EXPECT_EQ(four.error().code, Errc::damaged) << four.error().what;
  const auto five = read_npz(archive_of(5, 52 * mebibyte), "p.npz");
  ASSERT_FALSE(five);
  EXPECT_EQ(five.error().code, Errc::input) << five.error().what;
  EXPECT_EQ(five.error().what.find("p.npz: e: with this array all arrays take more than 256 MiB"),
            0u)
      << five.error().what;
}

TEST(Npz, OneArrayHasABound) {
  const auto large = read_npz(archive_of(1, (std::uint64_t{64} << 20) + 1), "p.npz");
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().what.find("p.npz: a is larger than 64 MiB"), std::string::npos)
      << large.error().what;
}

}  // namespace
}  // namespace mirocup::policy
