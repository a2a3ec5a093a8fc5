// SPDX-License-Identifier: MIT
#include "web/site_server.hpp"

#include "web/http_server.hpp"

namespace mirocup::web {

namespace {

constexpr const char* this_host = "127.0.0.1";
constexpr int match_timeout_s = 5;       // for a match that sends nothing
constexpr int upload_seconds = 10 * 60;  // 32 MiB take that long at 0.5 Mbit/s

httplib::Client client_of(int port) {
  httplib::Client client(this_host, port);
  client.set_connection_timeout(1);
  client.set_read_timeout(match_timeout_s);
  return client;
}

// Answers with the live page of a match, from the server of that match.
void pass_page(int port, httplib::Response& response) {
  auto client = client_of(port);
  const auto answer = client.Get("/");
  if (!answer || answer->status != 200) {
    response.status = 404;
    return;
  }
  response.set_content(answer->body, "text/html; charset=utf-8");
}

// Passes the events of a match on until the match or the viewer is gone.
void pass_events(int port, httplib::Response& response) {
  response.set_chunked_content_provider(
      "text/event-stream", [port](std::size_t, httplib::DataSink& sink) {
        auto client = client_of(port);
        (void)client.Get("/events", [&sink](const char* bytes, std::size_t count) {
          return sink.write(bytes, count);
        });
        sink.done();
        return true;
      });
}

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

Request request_of(const httplib::Request& from, bool is_encrypted) {
  Request request{.method = from.method,
                  .path = from.path,
                  .address = from.remote_addr,
                  .is_encrypted = is_encrypted};
  for (const auto& [name, value] : from.params) request.query.emplace(name, value);
  for (const auto& [name, value] : from.headers) request.headers.emplace(lower_case(name), value);
  return request;
}

}  // namespace

struct SiteServer::Impl {
  explicit Impl(Site shown) : site(std::move(shown)) {}

  void set_routes() {
    http.server().Get("/events", [this](const httplib::Request&, httplib::Response& response) {
      http.send_events(response, [this, seen = std::uint64_t{0}]() mutable {
        return EventBatch{site.news(seen), false};
      });
    });
    const auto pass = [this](void (*how)(int, httplib::Response&)) {
      return [this, how](const httplib::Request& request, httplib::Response& response) {
        const auto port = site.match(request.matches[1]);
        if (port) return how(*port, response);
        response.status = 404;
      };
    };
    http.server().Get("/live/([^/]+)/",
                      [this](const httplib::Request& request, httplib::Response& response) {
                        const std::string name = request.matches[1];
                        if (const auto port = site.match(name)) return pass_page(*port, response);
                        // A leg that is over has its replay.
                        const std::string replay = "/replays/" + name + ".html";
                        if (site.page(replay)) return response.set_redirect(replay);
                        response.status = 404;
                      });
    http.server().Get("/live/([^/]+)/events", pass(pass_events));
    if (site.control) {
      http.server().Post("/control",
                         [this](const httplib::Request& request, httplib::Response& response) {
                           response.status = site.control(request.body) ? 204 : 403;
                         });
    }
    const auto with_body = [this](const httplib::Request& request, httplib::Response& response,
                                  const httplib::ContentReader& reader) {
      const Body body = [&reader](const std::function<bool(std::string_view)>& take) {
        return reader([&take](const char* bytes, std::size_t count) {
          return take(std::string_view(bytes, count));
        });
      };
      if (!ask_desk(request, response, body)) response.status = 404;
    };
    // The library asks handlers that read the body first: they would take /control from a site.
    if (site.desk) {
      http.server().Put(".*", with_body);
      http.server().Post(".*", with_body);
      http.server().Delete(".*", with_body);
    }
    http.server().Get(".*", [this](const httplib::Request& request, httplib::Response& response) {
      if (ask_desk(request, response, [](const auto&) { return true; })) return;
      const auto page = site.page(request.path);
      if (!page) {
        response.status = 404;
        return;
      }
      if (!page->policy.empty()) response.set_header("Content-Security-Policy", page->policy);
      response.set_content(page->bytes, page->type);
    });
  }

  // Returns false if the desk has no such path.
  bool ask_desk(const httplib::Request& from, httplib::Response& response, const Body& body) {
    if (!site.desk) return false;
    auto reply = site.desk(request_of(from, http.server().is_encrypted()), body);
    if (!reply) return false;
    response.status = reply->status;
    for (const auto& [name, value] : reply->headers) response.set_header(name, value);
    if (reply->events) {
      http.send_events(response, std::move(reply->events));
    } else {
      response.set_content(std::move(reply->bytes), reply->type);
    }
    return true;
  }

  Site site;
  HttpServer http;  // the first to go: its threads use the other
};

SiteServer::SiteServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SiteServer::~SiteServer() = default;

Result<std::unique_ptr<SiteServer>> SiteServer::open(const Address& address,
                                                     const std::string& option, Site site,
                                                     SiteLimits limits) {
  auto impl = std::make_unique<Impl>(std::move(site));
  if (limits.max_upload > 0) impl->http.server().allow_uploads(limits.max_upload, upload_seconds);
  if (limits.tls) impl->http.server().encrypt(std::move(*limits.tls));
  impl->set_routes();
  MIROCUP_TRY_VOID(impl->http.listen(address, option));
  return std::unique_ptr<SiteServer>(new SiteServer(std::move(impl)));
}

std::string SiteServer::url() const {
  return impl_->http.url();
}

bool is_watched_at(int port) {
  auto client = client_of(port);
  const auto answer = client.Head("/");
  return answer && answer->status == 200;
}

}  // namespace mirocup::web
