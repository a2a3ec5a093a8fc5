// SPDX-License-Identifier: MIT
//
// The common part of LiveServer and SiteServer: listening, limits for viewers and uploads,
// encryption, server-sent events. Only their sources include this header, because it includes the
// HTTP library.
#pragma once

#include "core/base/error.hpp"
#include "system/tls.hpp"
#include "web/address.hpp"
#include "web/request.hpp"

#include <httplib.h>
#undef _res  // a macro of <resolv.h>, and the name of parameters in Eigen

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace mirocup::web {

// The library's server with limits: a request has at most 64 KiB in all, arrives within ten
// seconds, and gets whole pages. The library itself accepts headers, lines and bodies without end,
// and a thousand ranges of one page at once. If the server takes uploads, a PUT may have a larger
// body.
class BoundedServer : public httplib::Server {
 public:
  // Answers the one request of a connection; the connection stays open.
  bool answer(socket_t connection);

  // Accepts bodies of PUT up to that size, bytes, within that time, s. The server asks for the body
  // ("100 Continue") only when it reads it, so that a client that waits for this does not send in
  // vain.
  void allow_uploads(std::size_t size, int seconds);

  // Encrypts all connections from now on.
  void encrypt(system::TlsServer tls) { tls_ = std::move(tls); }
  bool is_encrypted() const { return tls_.has_value(); }

 private:
  bool process_and_close_socket(socket_t connection) override;

  std::size_t max_upload_ = 0;  // bytes; 0: none is taken
  int upload_seconds_ = 0;
  std::optional<system::TlsServer> tls_;
};

class HttpServer {
 public:
  HttpServer();
  ~HttpServer();  // ends all connections and waits for its threads
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  // For setting the routes, before listen().
  BoundedServer& server() { return server_; }

  // Binds to the address and serves requests from now on, in threads of a lower priority. The error
  // names `option`, which gave the address: Errc::unavailable if the address is in use or not of
  // this host.
  Result<void> listen(const Address& address, const std::string& option);

  std::string url() const;

  // Sends events to one viewer until the last has been sent. Calls `next` in a thread of this
  // server about 30 times a second.
  void send_events(httplib::Response& response, std::function<EventBatch()> next);

  // Returns the number of viewers to which the server is sending events.
  int viewers() const { return viewers_; }

 private:
  Address address_;
  std::atomic<int> viewers_{0};
  std::atomic<bool> is_closed_{false};
  BoundedServer server_;
  std::thread thread_;
};

}  // namespace mirocup::web
