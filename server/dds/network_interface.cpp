// SPDX-License-Identifier: MIT
#include "server/dds/network_interface.hpp"

#include "system/descriptor.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <ifaddrs.h>
#include <linux/filter.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace mirocup::dds {

namespace {

constexpr std::size_t max_addresses = 64;  // so that every jump of the filter fits a byte
constexpr std::uint32_t destination = 16;  // offset of the destination in an IPv4 header, bytes
constexpr std::uint32_t whole_packet = ~0U;

// Returns the IPv4 addresses of an interface in host byte order.
std::vector<std::uint32_t> addresses_of(const std::string& interface) {
  in_addr one{};
  if (inet_pton(AF_INET, interface.c_str(), &one) == 1) return {ntohl(one.s_addr)};
  std::vector<std::uint32_t> addresses;
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return addresses;
  for (const ifaddrs* a = all; a != nullptr; a = a->ifa_next) {
    if (a->ifa_addr == nullptr || a->ifa_addr->sa_family != AF_INET || interface != a->ifa_name) {
      continue;
    }
    addresses.push_back(ntohl(reinterpret_cast<const sockaddr_in*>(a->ifa_addr)->sin_addr.s_addr));
  }
  freeifaddrs(all);
  if (addresses.size() > max_addresses) addresses.resize(max_addresses);
  return addresses;
}

std::vector<sock_filter> filter_for(const std::vector<std::uint32_t>& addresses) {
  const auto offset = static_cast<std::uint32_t>(SKF_NET_OFF) + destination;
  std::vector<sock_filter> program{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offset)};
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    const auto to_accept = static_cast<std::uint8_t>(addresses.size() - i);
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, addresses[i], to_accept, 0));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, 0));
  program.push_back(BPF_STMT(BPF_RET | BPF_K, whole_packet));
  return program;
}

std::string text_of(in_addr address) {
  char text[INET_ADDRSTRLEN] = "";
  inet_ntop(AF_INET, &address, text, sizeof text);
  return text;
}

bool is_datagram_socket(int descriptor) {
  int type = 0;
  int family = 0;
  socklen_t size = sizeof type;
  if (getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) != 0) return false;
  size = sizeof family;
  getsockopt(descriptor, SOL_SOCKET, SO_DOMAIN, &family, &size);
  return type == SOCK_DGRAM && family == AF_INET;
}

}  // namespace

std::vector<int> open_descriptors() {
  std::vector<int> open;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", none)) {
    open.push_back(std::stoi(entry.path().filename().string()));
  }
  // The list contains the descriptor that the folder was read with, which is closed by now.
  std::erase_if(open, [](int descriptor) { return fcntl(descriptor, F_GETFD) < 0; });
  std::sort(open.begin(), open.end());
  return open;
}

void bind_to_interface(const std::vector<int>& before, const std::string& interface) {
  const auto addresses = addresses_of(interface);
  if (addresses.empty()) return;
  auto program = filter_for(addresses);
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  for (const int descriptor : open_descriptors()) {
    if (std::binary_search(before.begin(), before.end(), descriptor)) continue;
    if (!is_datagram_socket(descriptor)) continue;
    setsockopt(descriptor, SOL_SOCKET, SO_ATTACH_FILTER, &filter, sizeof filter);
    // Cyclone lets other processes share the port of a socket that may multicast.
    const int none = 0;
    setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &none, sizeof none);
    setsockopt(descriptor, SOL_SOCKET, SO_REUSEPORT, &none, sizeof none);
  }
}

std::string own_address_towards(const std::string& address, const std::string& interface) {
  if (!interface.empty()) {
    const auto own = addresses_of(interface);
    return own.empty() ? "" : text_of({htonl(own.front())});
  }
  sockaddr_in there{};
  there.sin_family = AF_INET;
  there.sin_port = htons(1);  // any: nothing is sent
  if (inet_pton(AF_INET, address.c_str(), &there.sin_addr) != 1) return "";
  const system::Descriptor probe(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_in own{};
  socklen_t size = sizeof own;
  if (connect(probe.get(), reinterpret_cast<const sockaddr*>(&there), sizeof there) != 0 ||
      getsockname(probe.get(), reinterpret_cast<sockaddr*>(&own), &size) != 0) {
    return "";
  }
  return text_of(own.sin_addr);
}

bool interface_is_up(const std::string& interface) {
  in_addr wanted{};
  const bool is_address = inet_pton(AF_INET, interface.c_str(), &wanted) == 1;
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return true;
  bool is_up = false;
  for (const ifaddrs* a = all; a != nullptr; a = a->ifa_next) {
    if (a->ifa_addr == nullptr || a->ifa_addr->sa_family != AF_INET) continue;
    const auto* own = reinterpret_cast<const sockaddr_in*>(a->ifa_addr);
    const bool is_this =
        is_address ? own->sin_addr.s_addr == wanted.s_addr : interface == a->ifa_name;
    constexpr unsigned works = IFF_UP | IFF_RUNNING;
    if (is_this && (a->ifa_flags & works) == works) is_up = true;
  }
  freeifaddrs(all);
  return is_up;
}

}  // namespace mirocup::dds
