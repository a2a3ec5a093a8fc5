// SPDX-License-Identifier: MIT
#include "web/http/address.hpp"

#include "system/number_of.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace mirocup::web {

namespace {

constexpr std::string_view unix_prefix = "unix:";
constexpr int waiting_in_kernel = 1024;  // connections that nobody has accepted yet
constexpr mode_t socket_mode = 0660;

std::string why_not_bound(int reason) {
  if (reason == EACCES)
    return "needs the permission of root: take a port from 1024 on, 8080 for example";
  if (reason == EADDRINUSE) return "is in use: take another port";
  return "is not an address of this host";
}

Error not_bound(const Address& address, const std::string& option, const std::string& why) {
  return {Errc::unavailable,
          option + ": " + address.host + " port " + std::to_string(address.port) + " " + why};
}

int port_of(int listener) {
  sockaddr_storage bound{};
  socklen_t size = sizeof bound;
  getsockname(listener, reinterpret_cast<sockaddr*>(&bound), &size);
  return ntohs(bound.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(bound).sin6_port
                                           : reinterpret_cast<const sockaddr_in&>(bound).sin_port);
}

Result<int> listen_at_port(Address& address, const std::string& option) {
  const AddressList list = looked_up(address, AI_PASSIVE);
  int reason = EADDRNOTAVAIL;
  for (const addrinfo* one = list.get(); one != nullptr; one = one->ai_next) {
    const int listener = socket(one->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (listener < 0) continue;
    // A port whose last connections are just ending may be taken. Another server's may not.
    const int yes = 1;
    setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (bind(listener, one->ai_addr, one->ai_addrlen) == 0 &&
        listen(listener, waiting_in_kernel) == 0) {
      address.port = port_of(listener);
      return listener;
    }
    reason = errno;
    close(listener);
  }
  return tl::unexpected(not_bound(address, option, why_not_bound(reason)));
}

bool answers(const sockaddr_un& name) {
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const bool is_connected =
      connect(socket, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
  const bool is_refused = !is_connected && errno == ECONNREFUSED;
  close(socket);
  return !is_refused;
}

Result<int> listen_at_path(const Address& address, const std::string& option) {
  const std::string what = option + " unix:" + address.path + ": ";
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  address.path.copy(name.sun_path, sizeof name.sun_path - 1);
  struct stat there {};
  if (lstat(address.path.c_str(), &there) == 0) {
    if (!S_ISSOCK(there.st_mode)) return fail(Errc::unavailable, what + "another file is there");
    if (answers(name)) return fail(Errc::unavailable, what + "another server listens there");
    unlink(address.path.c_str());
  }
  const int listener = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  // Until the mode is set, nobody else may connect.
  fchmod(listener, S_IRUSR | S_IWUSR);
  if (listener >= 0 && bind(listener, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0 &&
      chmod(address.path.c_str(), socket_mode) == 0 && listen(listener, waiting_in_kernel) == 0)
    return listener;
  const std::string reason = std::strerror(errno);
  close(listener);
  return fail(Errc::unavailable, what + reason);
}

}  // namespace

AddressList looked_up(const Address& address, int flags) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = flags | AI_NUMERICSERV;
  addrinfo* list = nullptr;
  const std::string port = std::to_string(address.port);
  const bool is_known = getaddrinfo(address.host.c_str(), port.c_str(), &hints, &list) == 0;
  return AddressList(is_known ? list : nullptr, freeaddrinfo);
}

Result<Address> parse_address(const std::string& text, const std::string& option) {
  Address address;
  if (text.starts_with(unix_prefix)) {
    address.path = text.substr(unix_prefix.size());
    if (!address.path.empty() && address.path.size() < sizeof(sockaddr_un::sun_path))
      return address;
    return fail(Errc::input, option + " " + text + ": unix:PATH needs a path of 1 to " +
                                 std::to_string(sizeof(sockaddr_un::sun_path) - 1) + " bytes");
  }
  const std::size_t colon = text.rfind(':');
  std::string port = text;
  if (colon != std::string::npos) {
    address.host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']') {
      address.host = address.host.substr(1, address.host.size() - 2);
    }
  }
  address.port = system::number_of<int>(port).value_or(-1);
  if (address.host.empty() || address.port < 0 || address.port > 65535) {
    return fail(Errc::input, option + " " + text + ": PORT, HOST:PORT or unix:PATH is expected");
  }
  return address;
}

std::string url_of(const Address& address, bool is_encrypted) {
  if (!address.path.empty()) return std::string(unix_prefix) + address.path;
  const bool is_v6 = address.host.find(':') != std::string::npos;
  return (is_encrypted ? "https://" : "http://") +
         (is_v6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port) +
         "/";
}

std::string counted_address(const std::string& address) {
  in6_addr v6{};
  if (inet_pton(AF_INET6, address.c_str(), &v6) != 1) return address;
  std::fill(std::begin(v6.s6_addr) + 8, std::end(v6.s6_addr), std::uint8_t{0});
  std::array<char, INET6_ADDRSTRLEN> text{};
  return inet_ntop(AF_INET6, &v6, text.data(), text.size());
}

std::string address_of_peer(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  char text[INET6_ADDRSTRLEN] = "";
  if (getpeername(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return "";
  if (address.ss_family == AF_INET) {
    inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in&>(address).sin_addr, text, sizeof text);
  } else if (address.ss_family == AF_INET6) {
    const in6_addr& v6 = reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
    if (IN6_IS_ADDR_V4MAPPED(&v6)) {
      inet_ntop(AF_INET, &v6.s6_addr[12], text, sizeof text);
    } else {
      inet_ntop(AF_INET6, &v6, text, sizeof text);
    }
  }
  return text;
}

Result<int> open_listener(Address& address, const std::string& option) {
  return address.path.empty() ? listen_at_port(address, option) : listen_at_path(address, option);
}

}  // namespace mirocup::web
