// SPDX-License-Identifier: MIT
#include "web/hand_in_client.hpp"

#include "record/json_reader.hpp"

#include <httplib.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>

namespace mirocup::web {

namespace {

constexpr int connect_seconds = 10;
constexpr int answer_seconds = 60;
constexpr std::size_t max_answer = 8u << 20;  // bytes, with headers, also after decompression
constexpr auto longest_answer = std::chrono::minutes(2);
constexpr auto watch_interval = std::chrono::milliseconds(10);
constexpr std::size_t slowest_upload = 32u << 10;  // bytes per second

bool is_url(const std::string& url) {
  const std::size_t begin = url.starts_with("https://") ? 8 : url.starts_with("http://") ? 7 : 0;
  return begin > 0 && url.size() > begin && url.find('/', begin) == std::string::npos;
}

// The library's names of errors are no words for users.
std::string words_of(httplib::Error error) {
  switch (error) {
    case httplib::Error::Connection:
      return "the connection was refused, or there is no such computer";
    case httplib::Error::ConnectionTimeout:
      return "it cannot be reached within the time limit";
    case httplib::Error::SSLConnection:
      return "it does not speak https; try http://, or another port";
    case httplib::Error::SSLServerVerification:
      return "this computer does not trust its certificate; --ca names a further authority";
    case httplib::Error::Read:
    case httplib::Error::Write:
      return "the connection broke, or the server expects https; try https://";
    default:
      return httplib::to_string(error);
  }
}

// Returns how many bytes a connection has received.
std::uint64_t received_by(int socket) {
  // The 17th word of tcp_info in <linux/tcp.h>, which excludes <netinet/tcp.h> of the library.
  std::array<std::uint64_t, 17> info{};
  socklen_t size = sizeof info;
  return getsockopt(socket, IPPROTO_TCP, TCP_INFO, info.data(), &size) == 0 ? info.back() : 0;
}

}  // namespace

struct HandInClient::Impl {
  explicit Impl(const std::string& url) : client(url) {}

  // Asks once. The library limits neither the headers nor the whole time, so a thread does.
  DeskReply ask(const char* method, const std::string& path, const std::string& bytes) {
    httplib::Request request;
    request.method = method;
    request.path = path;
    request.headers = headers;
    request.body = bytes;
    if (!bytes.empty()) request.headers.emplace("Content-Type", "application/octet-stream");
    DeskReply reply;
    request.content_receiver = [&reply](const char* part, std::size_t count, auto, auto) {
      reply.body.append(part, count);
      return reply.body.size() <= max_answer;
    };
    const auto end = std::chrono::steady_clock::now() + longest_answer +
                     std::chrono::seconds(bytes.size() / slowest_upload);
    std::atomic<bool> is_cut = false;
    std::jthread guard([&](const std::stop_token& is_over) {
      for (; !is_over.stop_requested(); std::this_thread::sleep_for(watch_interval)) {
        if (received_by(client.socket()) <= max_answer && std::chrono::steady_clock::now() < end)
          continue;
        is_cut = true;
        client.stop();
      }
    });
    const httplib::Result result = client.send(request);
    guard.request_stop();
    guard.join();
    if (!result) {
      const bool is_long = is_cut || reply.body.size() > max_answer;
      reply.error = is_long ? "the server's answer is too long or takes too long"
                            : "the server does not answer: " + words_of(result.error());
      return reply;
    }
    reply.status = result->status;
    reply.error = record::text_in(record::parse_json(reply.body).value, "error");
    reply.is_refused = !reply.error.empty() && reply.status < 500;
    if (reply.error.empty())
      reply.error = "the server answers with status " + std::to_string(reply.status);
    return reply;
  }

  httplib::Client client;
  httplib::Headers headers;
};

HandInClient::HandInClient(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HandInClient::~HandInClient() = default;

Result<std::unique_ptr<HandInClient>> HandInClient::open(const std::string& url,
                                                         const std::string& token,
                                                         const std::string& authority) {
  std::string address = url;
  while (address.ends_with('/')) address.pop_back();
  if (!is_url(address))
    return fail(Errc::input, url + ": an address like https://league.example:8443 is expected");
  auto impl = std::make_unique<Impl>(address);
  if (!impl->client.is_valid()) return fail(Errc::input, url + " is no address of a server");
  impl->client.set_connection_timeout(connect_seconds);
  impl->client.set_read_timeout(answer_seconds);
  impl->client.set_write_timeout(answer_seconds);
  impl->client.enable_server_certificate_verification(true);
  if (!authority.empty()) impl->client.set_ca_cert_path(authority);
  impl->headers = {{"Authorization", "Bearer " + token}};
  return std::unique_ptr<HandInClient>(new HandInClient(std::move(impl)));
}

DeskReply HandInClient::get(const std::string& path) {
  return impl_->ask("GET", path, "");
}

DeskReply HandInClient::put(const std::string& path, const std::string& bytes) {
  return impl_->ask("PUT", path, bytes);
}

}  // namespace mirocup::web
