// SPDX-License-Identifier: MIT
#include "web/packed_text.hpp"

#include "system/digest.hpp"

#include <zlib.h>

namespace mirocup::web {

std::string packed_text(std::string_view text) {
  constexpr int gzip_window = 15 + 16;  // the largest window; 16 asks for gzip's header and no time
  constexpr int memory_level = 8;
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    return "";
  }
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const bool is_done = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  bytes.resize(is_done ? stream.total_out : 0);
  deflateEnd(&stream);
  return system::base64(bytes);
}

}  // namespace mirocup::web
