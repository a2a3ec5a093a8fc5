// SPDX-License-Identifier: MIT
//
// The live page of one match over HTTP: the page at / and its events at /events. No request changes
// anything, and the server reads no file.
//
// Threads: the server runs in separate threads, with a lower priority than the match. A viewer that
// does not read blocks its own thread only, and is dropped after a few seconds. Only the thread of
// the match may call the functions.
#pragma once

#include "core/base/error.hpp"
#include "web/http/address.hpp"
#include "web/live_feed.hpp"
#include "web/page.hpp"

#include <memory>
#include <string>

namespace mirocup::web {

class LiveServer {
 public:
  // `about` is the last line of the page. Errc::unavailable if the address is in use or does not
  // belong to this host.
  static Result<std::unique_ptr<LiveServer>> open(const Address& address, const match::Leg& match,
                                                  const match::ByTeam<std::string>& names,
                                                  const std::string& about);
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  std::string url() const;

  // To be called after every tick.
  void publish(const match::Leg& match);

  // Sends the result to the viewers, and waits at most 1.5 s for them to receive it.
  void close(const match::Leg& match);

 private:
  struct Impl;  // keeps the HTTP library in one file
  explicit LiveServer(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace mirocup::web
