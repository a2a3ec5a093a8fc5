// SPDX-License-Identifier: MIT
//
// Pages that change while they are looked at, over HTTP: pages at the paths that the site knows, what
// has changed at /events, and matches of this host that are being watched below /live/NAME/. No request
// changes anything. A path is looked up, never joined to that of a folder.
#pragma once

#include "core/base/error.hpp"
#include "server/web/address.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace mirocup::web {

struct Page {
  std::string type;    // MIME
  std::string policy;  // content security policy; "": the page has its own
  std::string bytes;
};

// Threads: all three are called from several at once.
struct Site {
  // What stands at a path ("/index.html", "/" included); nothing if nothing does.
  std::function<std::optional<Page>(const std::string& path)> page;

  // Server-sent events for a viewer that has seen version `seen` (0: none), which becomes the present
  // one; "" if it is.
  std::function<std::string(std::uint64_t& seen)> news;

  // The port of this host at which the match of that name is watched; nothing if it is not.
  std::function<std::optional<int>(const std::string& name)> match;
};

class SiteServer {
 public:
  // `option` is the one that named the address, for errors.
  static Result<std::unique_ptr<SiteServer>> open(const Address& address, const std::string& option,
                                                  Site site);
  ~SiteServer();
  SiteServer(const SiteServer&) = delete;
  SiteServer& operator=(const SiteServer&) = delete;

  std::string url() const;

 private:
  struct Impl;  // keeps the HTTP library out of here
  explicit SiteServer(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

// Does a match answer that is watched at this port of this host?
bool is_watched_at(int port);

}  // namespace mirocup::web
