// SPDX-License-Identifier: MIT
//
// One request on a connection and its reply: the only code that knows the HTTP library of the
// server, Boost.Beast. Beast parses. This class also refuses requests that Beast accepts but that a
// proxy could read in another way.
#pragma once

#include "web/http/connection.hpp"
#include "web/http/request.hpp"

#include <memory>
#include <optional>
#include <string>

namespace mirocup::web {

struct BodyLimits {
  std::size_t max_body = 4u << 10;  // bytes
  std::size_t max_upload = 0;       // the most bytes of the body of a PUT; 0: max_body
};

class Exchange {
 public:
  Exchange(Connection& connection, const BodyLimits& limits);
  ~Exchange();
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  // Receives the line and the headers of the request into request(). Returns a reply if the server
  // refuses the request because of its head. The second value is false if the connection broke
  // before the end of the head.
  std::pair<std::optional<Reply>, bool> receive_head();

  Request& request() { return request_; }

  // Reads the body as a web::Body does. Before this call a client that waits for "100 Continue"
  // does not get this reply.
  bool receive_body(const std::function<bool(std::string_view part)>& take);

  // True if the head of the request is complete, but the body is not yet read to its end.
  bool has_unread_body() const;

  // Sends a whole reply.
  bool send(const Reply& reply);

  // Send the head of a stream of events, then its parts, then its end.
  bool begin_events();
  bool send_events(std::string_view part);
  void end_events();

 private:
  struct Parser;
  std::optional<Reply> objection();
  void fill_request();
  bool fill_buffer();

  Connection& connection_;
  const BodyLimits limits_;
  Request request_;
  // Received bytes that are not yet parsed. Until the head is complete, its parsed bytes also stay.
  std::string buffer_;
  std::size_t parsed_ = 0;  // parsed bytes of buffer_
  bool is_http_1_0_ = false;
  std::unique_ptr<Parser> parser_;  // keeps the HTTP library out of this header
};

// Returns the reply of this server to a request that no handler has seen, or that failed.
Reply plain_reply(int status, const std::string& why);

}  // namespace mirocup::web
