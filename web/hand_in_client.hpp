// SPDX-License-Identifier: MIT
//
// The client of a league's desk: hands a file in over HTTP and asks for the state of the file's
// check.
#pragma once

#include "core/base/error.hpp"

#include <memory>
#include <string>

namespace mirocup::web {

// The answer of the server.
struct DeskReply {
  int status = 0;    // 0: no server has answered
  std::string body;  // at most 8 MiB
  // The text of the key "error" in `body`. Without this key: a sentence with the status or, if no
  // server has answered, with the reason.
  std::string error;
  bool is_refused = false;  // by a league, which says why in `error`
};

// A server's answer is cut off at 8 MiB, and after two minutes and the time for which a file is
// sent at 32 KiB/s; then no server has answered.
class HandInClient {
 public:
  // `url` is the address of the league, "https://host:8443". `authority` is a file with the
  // certificate that signed the server's certificate; "": the certificates of the system.
  // Errc::input if `url` is not an address.
  static Result<std::unique_ptr<HandInClient>> open(const std::string& url,
                                                    const std::string& token,
                                                    const std::string& authority);
  ~HandInClient();
  HandInClient(const HandInClient&) = delete;
  HandInClient& operator=(const HandInClient&) = delete;

  DeskReply get(const std::string& path);
  // Sends bytes, or only the path.
  DeskReply put(const std::string& path, const std::string& bytes = "");

 private:
  struct Impl;  // keeps the HTTP library out of this header
  explicit HandInClient(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace mirocup::web
