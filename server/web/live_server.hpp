// SPDX-License-Identifier: MIT
//
// The live page of one match over HTTP: the page at /, its events at /events, and nothing else. No
// request changes anything, no file is read.
//
// Threads: its own, at a lower priority than the match. A viewer that does not take what it is sent
// holds up its own thread only, and is dropped after a few seconds.
#pragma once

#include "core/base/error.hpp"
#include "server/web/address.hpp"
#include "server/web/live_feed.hpp"
#include "server/web/page.hpp"

#include <memory>
#include <string>

namespace mirocup::web {

class LiveServer {
 public:
  // `about` is the last line of the page. Errc::unavailable if the address cannot be had.
  static Result<std::unique_ptr<LiveServer>> open(const Address& address, const match::Leg& match,
                                                  const match::ByTeam<std::string>& names,
                                                  const std::string& about);
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  std::string url() const;

  // After every tick.
  void publish(const match::Leg& match);

  // Tells the viewers how the match ended, and waits a moment for them to take it.
  void close(const match::Leg& match);

 private:
  struct Impl;  // keeps the HTTP library in one file
  explicit LiveServer(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace mirocup::web
