// SPDX-License-Identifier: MIT
//
// A server for pages and streams of events, with limits for connections, requests, time and bodies.
// Each connection has one request and, once it may enter, a thread with a lower priority than
// matches.
#pragma once

#include "core/base/error.hpp"
#include "system/tls.hpp"
#include "web/http/address.hpp"
#include "web/http/entrance.hpp"
#include "web/http/exchange.hpp"
#include "web/http/request.hpp"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

namespace mirocup::web {

// The proxies between this server and its viewers: how the server recognises a proxy, and which
// headers of a proxy it trusts.

// The trusted proxies; by default none.
struct ProxyTrust {
  std::set<std::string> addresses = {};

  // The value that trusted proxies send in the header X-Mirocup-Proxy. An address alone proves
  // nothing, because all programs of a computer share it. "": there are no proxies.
  std::string secret = {};

  // True if this server listens at a Unix socket: any program that may open it counts as the proxy.
  bool is_unix_socket = false;
};

// Finds out whether the request comes from a trusted proxy, and for which viewer (X-Forwarded-For,
// X-Forwarded-Proto).
void apply(const ProxyTrust& trust, Request& request);

struct ServerOptions {
  BodyLimits bodies = {};
  EntranceLimits entrance = {.capacity = connection_capacity()};
  ProxyTrust proxy = {};
  std::optional<system::TlsServer> tls = {};  // empty: connections are not encrypted
};

// Answers a request. Several threads call a handler at the same time.
using Handler = std::function<Reply(const Request& request, const Body& body)>;

class HttpServer {
 public:
  HttpServer(Handler handler, ServerOptions options);
  ~HttpServer();  // ends all connections and waits for its threads
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  // Listens at the address and serves requests from now on. Errors are those of open_listener().
  Result<void> listen(const Address& address, const std::string& option);

  int port() const { return address_.port; }
  std::string url() const { return url_of(address_, options_.tls.has_value()); }

  // Returns the number of viewers to which the server is sending events.
  int viewers() const;

 private:
  void accept_all();
  bool accept_one();  // false if no connection has come
  void begin(int connection);
  void end(int connection);
  void end_or_let_in();
  void serve(int connection);
  void answer(int connection);
  void send_reply(Exchange& exchange, int connection, Reply& reply);
  void send_events(Exchange& exchange, Reply& reply);
  void set_stage(int connection, Stage stage);

  const Handler handler_;
  const ServerOptions options_;
  Address address_;
  int listener_ = -1;
  int wake_ = -1;  // an eventfd, written when a connection has ended or the server ends
  std::atomic<bool> is_closed_{false};
  std::thread thread_;

  mutable std::mutex mutex_;  // guards the members below
  Entrance entrance_;
  int threads_ = 0;
  std::condition_variable thread_ended_;
};

}  // namespace mirocup::web
