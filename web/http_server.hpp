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

// The library's server, but a request has at most 64 KiB in all and arrives within ten seconds, and
// asks for a whole page: the library itself takes headers, lines and bodies without end, and a
// thousand ranges of one page at once. A PUT may have a larger body where the server takes uploads.
class BoundedServer : public httplib::Server {
 public:
  // Answers the one request of a connection; the connection stays open.
  bool answer(socket_t connection);

  // Takes bodies of PUT up to that size, bytes, within that time, s. The body is asked for
  // ("100 Continue") when it is read: a client that waits for that does not send in vain.
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

  // Binds to the address and serves requests from now on, in threads of a lower priority. `option`
  // is the one that named the address, for the error: Errc::unavailable if the address is in use or
  // not of this host.
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
