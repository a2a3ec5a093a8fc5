// SPDX-License-Identifier: MIT
//
// Arrays of numpy: an .npz is a zip archive of .npy files.
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#pragma once

#include "core/base/error.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::policy {

// An array of 32-bit floats, whose last index varies fastest in memory, or a text.
struct Array {
  std::vector<std::size_t> shape;  // empty for a text
  std::vector<float> numbers;
  std::string text;
  bool is_text = false;
};

inline constexpr std::size_t max_arrays = 256;
inline constexpr std::size_t max_array_bytes = 64u << 20;   // of an unpacked array
inline constexpr std::size_t max_total_bytes = 256u << 20;  // of all arrays together

// Reads all arrays and returns them by name. The error, Errc::damaged or Errc::input, names `path`
// and the array.
Result<std::map<std::string, Array>> read_npz(std::string_view bytes, const std::string& path);

}  // namespace mirocup::policy
