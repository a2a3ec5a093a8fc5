// SPDX-License-Identifier: MIT
//
// What the HTTP servers of this room have in common: how they listen, how much patience they have with
// a viewer, and how they send events. Only they include this; it brings the HTTP library.
#pragma once

#include "core/base/error.hpp"
#include "server/web/address.hpp"

#include <httplib.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>

namespace mirocup::web {

class HttpServer {
 public:
  HttpServer();
  ~HttpServer();  // answers nobody any more
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  // The routes, to be set before it listens.
  httplib::Server& server() { return server_; }

  // Takes the address and answers there from now on, in threads of a lower priority. `option` is the
  // one that named the address. Errc::unavailable if it cannot be had.
  Result<void> listen(const Address& address, const std::string& option);

  std::string url() const;

  // Events for one viewer until the last has been sent. `next` is asked again and again; it gives
  // whole events or "".
  struct EventBatch {
    std::string text;
    bool is_last = false;
  };
  void send_events(httplib::Response& response, std::function<EventBatch()> next);

  // So many are being sent events.
  int viewers() const { return viewers_; }

 private:
  Address address_;
  std::atomic<int> viewers_{0};
  std::atomic<bool> is_closed_{false};
  httplib::Server server_;
  std::thread thread_;
};

}  // namespace mirocup::web
