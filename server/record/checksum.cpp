// SPDX-License-Identifier: MIT
#include "server/record/checksum.hpp"

#include "system/digest.hpp"

namespace mirocup::record {

namespace {

// The end of a record whose text before it is `text`.
std::string checksum_line(const std::string& text) {
  return ",\n \"sha256\": \"" + system::sha256(text) + "\"\n}\n";
}

}  // namespace

std::string with_checksum(std::string object) {
  object.resize(object.rfind("\n}"));
  const std::string line = checksum_line(object);
  return object + line;
}

Result<void> expect_whole(const std::string& text, const std::string& path) {
  const std::size_t begin = text.rfind(",\n");
  if (begin != std::string::npos && text.substr(begin) == checksum_line(text.substr(0, begin)))
    return {};
  return fail(Errc::damaged, path + ": its text is not what was written (sha256)");
}

}  // namespace mirocup::record
