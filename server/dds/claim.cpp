// SPDX-License-Identifier: MIT
#include "server/dds/claim.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>

namespace mirocup::dds {

Result<system::Descriptor> claim(const std::string& name) {
  system::Descriptor claimed(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (!claimed.is_open())
    return fail(Errc::unavailable, std::string("a socket cannot be made: ") + std::strerror(errno));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(claimed.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0) claimed.reset();
  return claimed;
}

}  // namespace mirocup::dds
