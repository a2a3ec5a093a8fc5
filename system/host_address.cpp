// SPDX-License-Identifier: MIT
#include "system/host_address.hpp"

#include <arpa/inet.h>
#include <array>
#include <chrono>
#include <future>
#include <netdb.h>
#include <thread>

namespace mirocup::system {

namespace {

Result<std::string> resolved(const std::string& host) {
  addrinfo wanted{};
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  if (const int why = getaddrinfo(host.c_str(), nullptr, &wanted, &found); why != 0)
    return fail(Errc::unavailable, host + ": no address is known: " + gai_strerror(why));
  std::array<char, INET_ADDRSTRLEN> text{};
  inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(found->ai_addr)->sin_addr, text.data(),
            text.size());
  freeaddrinfo(found);
  return std::string(text.data());
}

}  // namespace

Result<std::string> address_of(const std::string& host, double seconds) {
  in_addr address{};
  if (inet_pton(AF_INET, host.c_str(), &address) == 1) return host;
  std::packaged_task<Result<std::string>()> task([host] { return resolved(host); });
  std::future<Result<std::string>> answer = task.get_future();
  std::thread(std::move(task)).detach();
  if (answer.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready)
    return answer.get();
  return fail(Errc::unavailable, host + ": no address is known after " +
                                     std::to_string(static_cast<int>(seconds)) + " s");
}

}  // namespace mirocup::system
