// SPDX-License-Identifier: MIT
//
// A request to a server and its reply, without the HTTP library, so that tests of replies need no
// connection.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mirocup::web {

struct Request {
  std::string method;            // "GET", "PUT", ...
  std::string path;              // without the query, percent signs decoded
  std::string address;           // address of the other end of the connection; "": a Unix socket
  bool is_encrypted = false;     // encrypted on the way to this server or to a trusted proxy
  bool is_from_proxy = false;    // true: from a trusted proxy, which names the viewer
  std::string viewer = address;  // the viewer's address, from a trusted proxy or `address`

  std::multimap<std::string, std::string> query{};
  std::multimap<std::string, std::string> headers{};  // names in lower case

  // Returns the value of a header or of a part of the query; "" if no value or several values
  // exist. So this server and a proxy in front of it cannot read different values.
  std::string header(const std::string& name) const { return only(headers, name); }
  std::string asked(const std::string& name) const { return only(query, name); }

  bool is_reading() const { return method == "GET" || method == "HEAD"; }

 private:
  static std::string only(const std::multimap<std::string, std::string>& all,
                          const std::string& name) {
    return all.count(name) == 1 ? all.find(name)->second : "";
  }
};

// Returns the way from the page at a path to the top of its site, "../" for each folder. A link
// that begins with it holds below any path at which a proxy shows the site.
inline std::string root_of(std::string_view path) {
  std::string root;
  for (auto left = std::ranges::count(path, '/'); left > 1; --left) root += "../";
  return root;
}

// Reads the body of a request in parts and gives them to `take`. Returns false if `take` returned
// false, or if the connection broke before the end of the body. May be called at most once. Without
// a call the server does not ask for the body.
using Body = std::function<bool(const std::function<bool(std::string_view part)>& take)>;

// News for a viewer: whole server-sent events.
struct EventBatch {
  std::string text;  // "": no news
  bool is_last = false;
};

struct Reply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string bytes = {};
  std::vector<std::pair<std::string, std::string>> headers = {};
  bool is_for_ever = false;  // true: the path never has other bytes, so browsers may keep them

  // If set, the reply is a stream of events instead of `bytes`. The server calls this function
  // about 30 times a second.
  std::function<EventBatch()> events = {};

  // If set, the reply is a stream of events that this function writes with `write`, until `write`
  // returns false or the stream has ended.
  std::function<void(const std::function<bool(std::string_view part)>& write)> passed_events = {};

  // True if the sender has shown who it is. Under load its stream comes before the streams of
  // strangers.
  bool is_for_known = false;
};

}  // namespace mirocup::web
