// SPDX-License-Identifier: MIT
//
// One reader of bytes that strangers wrote: MIROCUP_FUZZ_TARGET(NAME) and a body with `data` and
// `size`. It is libFuzzer's entry in build/fuzz/NAME_fuzz, and one of several in
// build/fuzz_corpus, which reads kept inputs with the limits of time and memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace mirocup::fuzz {

using Reader = void (*)(const std::uint8_t* data, std::size_t size);

// All readers of this program by name.
inline std::map<std::string, Reader>& readers() {
  static std::map<std::string, Reader> all;
  return all;
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace mirocup::fuzz

#if defined(MIROCUP_FUZZ_CORPUS)
#define MIROCUP_FUZZ_ENTRY(name) \
  static const bool is_##name##_known = (mirocup::fuzz::readers()[#name] = read_##name, true);
#else
#define MIROCUP_FUZZ_ENTRY(name)                                                      \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    read_##name(data, size);                                                          \
    return 0;                                                                         \
  }
#endif

#define MIROCUP_FUZZ_TARGET(name)                                      \
  static void read_##name(const std::uint8_t* data, std::size_t size); \
  MIROCUP_FUZZ_ENTRY(name)                                             \
  static void read_##name(const std::uint8_t* data, std::size_t size)
