// SPDX-License-Identifier: MIT
#include "server/dds/match_claim.hpp"

#include "system/digest.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>

namespace mirocup::dds {

// The claim is an abstract socket: its name has no file, and is known to all processes that share
// the network, and with it the ports, of this host.
Result<system::Descriptor> claim_match(const std::string& match_id, int domain) {
  const std::string name =
      "mirocup-" + std::to_string(domain) + "-" + system::sha256(match_id).substr(0, 32);
  system::Descriptor claim(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (claim.get() < 0) {
    return fail(Errc::unavailable, std::string("a socket cannot be made: ") + std::strerror(errno));
  }
  if (bind(claim.get(), reinterpret_cast<const sockaddr*>(&address), size) == 0) return claim;
  return fail(Errc::unavailable, "match \"" + match_id +
                                     "\" is already played by another match server on this host: "
                                     "wait for its end, or choose another --match");
}

}  // namespace mirocup::dds
