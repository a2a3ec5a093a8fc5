// SPDX-License-Identifier: MIT
//
// A client of HTTP servers, with limits of bytes and time. Each request has a connection of its
// own. The client follows no redirection and uses no proxy.
#pragma once

#include "core/base/error.hpp"
#include "system/tls.hpp"
#include "web/http/address.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::web {

class Connection;

struct ClientOptions {
  std::string token = {};             // sent as bearer token; "": no token
  std::string authority = {};         // PEM file of the certificates that sign; "": the system's
  std::size_t max_answer = 8u << 20;  // bytes, with headers
  std::chrono::seconds connect_time{10};  // for each address of the server
  std::chrono::seconds patience{60};      // with a server that sends or takes nothing
  // For a request and its answer. A body has further time: 1 s for each 32 KiB.
  std::chrono::seconds time{120};
};

struct Answer {
  int status = 0;  // 0: no server has answered within the limits
  std::string body = {};
  std::string error = {};  // without a status: the reason, in a sentence
};

class HttpClient {
 public:
  // `url` is the address of a server, "https://host:8443", or of a path below which it answers,
  // "https://host/spring". Errc::input if `url` is not an address,
  // or if the file of the authority has no certificate.
  static Result<HttpClient> open(const std::string& url, ClientOptions options = {});

  // Sends a request and receives its answer. If `take` is set, it gets the body in parts in place
  // of Answer::body, and returns false to end the request.
  Answer ask(const std::string& method, const std::string& path, std::string_view body = "",
             const std::function<bool(std::string_view part)>& take = {}) const;

 private:
  HttpClient() = default;
  void receive(Connection& connection, bool is_head,
               const std::function<bool(std::string_view part)>& take, Answer& answer) const;

  Address address_;
  std::string host_header_;
  std::string base_;  // precedes the path of each request
  ClientOptions options_;
  std::optional<system::TlsClient> tls_;  // of an https server
};

}  // namespace mirocup::web
