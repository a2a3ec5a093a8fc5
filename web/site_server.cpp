// SPDX-License-Identifier: MIT
#include "web/site_server.hpp"

#include "web/http/client.hpp"

#include <chrono>
#include <limits>

namespace mirocup::web {

namespace {

constexpr std::string_view live = "/live/";
constexpr std::string_view events = "/events";

// A client of the server of a match on this host.
HttpClient client_of(int port, ClientOptions limits = {}) {
  limits.connect_time = std::chrono::seconds(1);
  limits.patience = std::chrono::seconds(5);
  return HttpClient::open("http://127.0.0.1:" + std::to_string(port), limits).value();
}

// Answers with the live page of a match, from the server of that match.
Reply page_of_match(int port) {
  Answer page = client_of(port).ask("GET", "/");
  if (page.status != 200) return {.status = 404};
  return {.type = "text/html; charset=utf-8", .bytes = std::move(page.body)};
}

// Passes the events of a match on until the match or the viewer is gone.
Reply events_of_match(int port) {
  return {.passed_events = [port](const std::function<bool(std::string_view)>& write) {
    const ClientOptions whole_match{.max_answer = std::numeric_limits<std::size_t>::max(),
                                    .time = std::chrono::hours(1000)};
    (void)client_of(port, whole_match).ask("GET", "/events", "", write);
  }};
}

Reply only(const char* method) {
  return {.status = 405, .headers = {{"Allow", method}}};
}

}  // namespace

struct SiteServer::Impl {
  Impl(Site shown, ServerOptions options)
      : site(std::move(shown)),
        http([this](const Request& request, const Body& body) { return answer(request, body); },
             std::move(options)) {}

  // A proxy may pass the whole path on, or the path without the base.
  Reply answer(Request request, const Body& body) {
    const std::string& base = site.base;
    if (!base.empty() && request.path == base)
      return {.status = 308, .headers = {{"Location", base + "/"}}};
    if (!base.empty() && request.path.starts_with(base + "/")) request.path.erase(0, base.size());
    if (site.control && request.path == "/control") return control(request, body);
    if (site.desk) {
      if (auto reply = site.desk(request, body)) return std::move(*reply);
    }
    if (!request.is_reading()) return only("GET");
    if (request.path == events) {
      return {.events = [this, seen = std::uint64_t{0}]() mutable {
        return EventBatch{site.news(seen), false};
      }};
    }
    if (request.path.starts_with(live)) return of_match(request.path.substr(live.size()));
    auto page = site.page(request.path);
    if (!page) return {.status = 404};
    Reply reply{.type = std::move(page->type), .bytes = std::move(page->bytes)};
    if (!page->policy.empty())
      reply.headers.emplace_back("Content-Security-Policy", std::move(page->policy));
    return reply;
  }

  Reply control(const Request& request, const Body& body) {
    if (request.method != "POST") return only("POST");
    std::string text;
    const bool is_whole = body([&text](std::string_view part) {
      text += part;
      return true;
    });
    return {.status = !is_whole ? 400 : site.control(text) ? 204 : 403};
  }

  // `rest` follows "/live/": "NAME/" or "NAME/events".
  Reply of_match(const std::string& rest) {
    const std::string name = rest.substr(0, rest.find('/'));
    const std::string_view what = std::string_view(rest).substr(name.size());
    if (what != "/" && what != events) return {.status = 404};
    const auto port = site.match(name);
    if (port) return what == "/" ? page_of_match(*port) : events_of_match(*port);
    // A leg that is over has its replay.
    const std::string replay = "replays/" + name + ".html";
    if (what != "/" || !site.page("/" + replay)) return {.status = 404};
    return {.status = 302, .headers = {{"Location", "../../" + replay}}};
  }

  Site site;
  HttpServer http;  // the first to go: its threads use the other
};

SiteServer::SiteServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SiteServer::~SiteServer() = default;

Result<std::unique_ptr<SiteServer>> SiteServer::open(const Address& address,
                                                     const std::string& option, Site site,
                                                     ServerOptions options) {
  options.proxy.is_unix_socket = !address.path.empty();
  auto impl = std::make_unique<Impl>(std::move(site), std::move(options));
  MIROCUP_TRY_VOID(impl->http.listen(address, option));
  return std::unique_ptr<SiteServer>(new SiteServer(std::move(impl)));
}

std::string SiteServer::url() const {
  return impl_->http.url();
}

bool is_watched_at(int port) {
  return client_of(port).ask("HEAD", "/").status == 200;
}

}  // namespace mirocup::web
