// SPDX-License-Identifier: MIT
//
// The client of a league's desk: hands a file in over HTTP and asks for the state of the file's
// check.
#pragma once

#include "core/base/error.hpp"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace mirocup::web {

using Json = nlohmann::ordered_json;

// The answer of the server.
struct DeskReply {
  int status = 0;  // 0: no server has answered
  Json json;       // null if the reply is not a JSON object
  // The text of the key "error" in `json`. Without this key: a sentence with the status or, if no
  // server has answered, with the reason.
  std::string error;
};

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

  // Asks for the team of the token, and whether the team may hand in now.
  DeskReply about();
  // Hands in a file.
  DeskReply put(const std::string& name, const std::string& bytes);
  // Pins the entry with a number, or "latest".
  DeskReply pin(const std::string& entry);
  // Asks for the state of an entry.
  DeskReply entry(int number);
  // Asks for the team's friendlies, and for its progress in friendlies.
  DeskReply friendlies();

 private:
  struct Impl;  // keeps the HTTP library out of this header
  explicit HandInClient(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace mirocup::web
