// SPDX-License-Identifier: MIT
//
// A site over HTTP whose pages change while they are shown. The server has the site's pages at
// their paths, the changes at /events, and the live pages of matches on this host below
// /live/NAME/. Once a match is over, its address leads to /replays/NAME.html. No request changes
// anything, unless the site takes commands or has a desk. Paths of requests are looked up in the
// site, never joined to the path of a folder.
#pragma once

#include "core/base/error.hpp"
#include "web/http/server.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace mirocup::web {

struct Page {
  std::string type;    // MIME
  std::string policy;  // content security policy; "": the page contains its policy
  std::string bytes;
  bool is_for_ever = false;  // true: the path never has other bytes
};

// The content of a site. Several threads call its functions at the same time.
struct Site {
  // Returns the page at a path, which starts with "/"; nothing if the site lacks the path.
  std::function<std::optional<Page>(const std::string& path)> page;

  // Returns the server-sent events for a viewer that has version `seen` (0: no version); "" if
  // `seen` is the present version. Sets `seen` to the present version.
  std::function<std::string(std::uint64_t& seen)> news;

  // Returns the port of this host at which a match has its live page; nothing if the match has no
  // live page.
  std::function<std::optional<int>(const std::string& name)> match;

  // The path at which a proxy shows the site, "/spring"; "": there is none, or the proxy cuts it
  // off.
  std::string base = {};

  // Handles the body of a request to /control; returns false if the request is not allowed. Without
  // this function, /control is a path like any other.
  std::function<bool(const std::string& body)> control = {};

  // If set, the server first calls this function with each request, of any method. If the function
  // returns nothing, the server looks for the path in the pages.
  std::function<std::optional<Reply>(const Request& request, const Body& body)> desk = {};
};

class SiteServer {
 public:
  // The error names `option`, which gave the address: Errc::unavailable if the address is in use or
  // does not belong to this host.
  static Result<std::unique_ptr<SiteServer>> open(const Address& address, const std::string& option,
                                                  Site site, ServerOptions options = {});

  std::string url() const { return http_.url(); }

 private:
  SiteServer(Site site, ServerOptions options);
  Reply answer(Request request, const Body& body);
  Reply control(const Request& request, const Body& body);
  Reply of_match(const std::string& rest);

  const Site site_;
  HttpServer http_;  // the first to go: its threads use the other
};

// True if a live page answers at this port of this host. Waits at most some seconds.
bool is_watched_at(int port);

}  // namespace mirocup::web
