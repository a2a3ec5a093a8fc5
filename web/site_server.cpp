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

SiteServer::SiteServer(Site site, ServerOptions options)
    : site_(std::move(site)),
      http_([this](const Request& request, const Body& body) { return answer(request, body); },
            std::move(options)) {}

// A proxy may pass the whole path on, or the path without the base.
Reply SiteServer::answer(Request request, const Body& body) {
  const std::string& base = site_.base;
  if (!base.empty() && request.path == base)
    return {.status = 308, .headers = {{"Location", base + "/"}}};
  if (!base.empty() && request.path.starts_with(base + "/")) request.path.erase(0, base.size());
  if (site_.control && request.path == "/control") return control(request, body);
  if (site_.desk) {
    if (auto reply = site_.desk(request, body)) return std::move(*reply);
  }
  if (!request.is_reading()) return only("GET");
  if (request.path == events) {
    return {.events = [this, seen = std::uint64_t{0}]() mutable {
      return EventBatch{site_.news(seen), false};
    }};
  }
  if (request.path.starts_with(live)) return of_match(request.path.substr(live.size()));
  auto page = site_.page(request.path);
  if (!page) return {.status = 404};
  Reply reply{.type = std::move(page->type),
              .bytes = std::move(page->bytes),
              .is_for_ever = page->is_for_ever};
  if (!page->policy.empty())
    reply.headers.emplace_back("Content-Security-Policy", std::move(page->policy));
  return reply;
}

Reply SiteServer::control(const Request& request, const Body& body) {
  if (request.method != "POST") return only("POST");
  std::string text;
  const bool is_whole = body([&text](std::string_view part) {
    text += part;
    return true;
  });
  return {.status = !is_whole ? 400 : site_.control(text) ? 204 : 403};
}

// `rest` follows "/live/": "NAME/" or "NAME/events".
Reply SiteServer::of_match(const std::string& rest) {
  const std::string name = rest.substr(0, rest.find('/'));
  const std::string_view what = std::string_view(rest).substr(name.size());
  if (what != "/" && what != events) return {.status = 404};
  const auto port = site_.match(name);
  if (port) return what == "/" ? page_of_match(*port) : events_of_match(*port);
  // A leg that is over has its replay.
  const std::string replay = "replays/" + name + ".html";
  if (what != "/" || !site_.page("/" + replay)) return {.status = 404};
  return {.status = 302, .headers = {{"Location", "../../" + replay}}};
}

Result<std::unique_ptr<SiteServer>> SiteServer::open(const Address& address,
                                                     const std::string& option, Site site,
                                                     ServerOptions options) {
  options.proxy.is_unix_socket = !address.path.empty();
  std::unique_ptr<SiteServer> server(new SiteServer(std::move(site), std::move(options)));
  MIROCUP_TRY_VOID(server->http_.listen(address, option));
  return server;
}

bool is_watched_at(int port) {
  return client_of(port).ask("HEAD", "/").status == 200;
}

}  // namespace mirocup::web
