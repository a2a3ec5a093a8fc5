// SPDX-License-Identifier: MIT
#include "server/web/site_server.hpp"

#include "server/web/http_server.hpp"

namespace mirocup::web {

namespace {

constexpr const char* this_host = "127.0.0.1";
constexpr int timeout_s = 5;  // for a match that sends nothing

httplib::Client client_of(int port) {
  httplib::Client client(this_host, port);
  client.set_connection_timeout(1);
  client.set_read_timeout(timeout_s);
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

}  // namespace

struct SiteServer::Impl {
  explicit Impl(Site shown) : site(std::move(shown)) {}

  void set_routes() {
    http.server().Get("/events", [this](const httplib::Request&, httplib::Response& response) {
      http.send_events(response, [this, seen = std::uint64_t{0}]() mutable {
        return HttpServer::EventBatch{site.news(seen), false};
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
    http.server().Get(".*", [this](const httplib::Request& request, httplib::Response& response) {
      const auto page = site.page(request.path);
      if (!page) {
        response.status = 404;
        return;
      }
      if (!page->policy.empty()) response.set_header("Content-Security-Policy", page->policy);
      response.set_content(page->bytes, page->type);
    });
  }

  Site site;
  HttpServer http;  // the first to go: its threads use the other
};

SiteServer::SiteServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SiteServer::~SiteServer() = default;

Result<std::unique_ptr<SiteServer>> SiteServer::open(const Address& address,
                                                     const std::string& option, Site site) {
  auto impl = std::make_unique<Impl>(std::move(site));
  impl->set_routes();
  if (auto listens = impl->http.listen(address, option); !listens)
    return tl::unexpected(listens.error());
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
