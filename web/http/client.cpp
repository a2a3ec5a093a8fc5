// SPDX-License-Identifier: MIT
#include "web/http/client.hpp"

#include "system/descriptor.hpp"
#include "web/http/connection.hpp"

#include <algorithm>
#include <array>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <cerrno>
#include <csignal>
#include <poll.h>
#include <sys/socket.h>

namespace mirocup::web {

namespace {

namespace http = boost::beast::http;
using std::chrono::steady_clock;

constexpr std::size_t longest_head = 64u << 10;    // bytes of status line and headers
constexpr std::size_t slowest_upload = 32u << 10;  // bytes per second

constexpr const char* refused = "the connection was refused, or there is no such computer";
constexpr const char* not_reached = "it cannot be reached within the time limit";
constexpr const char* not_tls = "it does not speak https; try http://, or another port";
constexpr const char* not_trusted =
    "this computer does not trust its certificate; --ca names a further authority";
constexpr const char* broken = "the connection broke, or the server expects https; try https://";
constexpr const char* too_much = "the server's answer is too long or takes too long";

// While it lives, writing to a broken connection does not end the program.
class NoBrokenPipe {
 public:
  NoBrokenPipe() {
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  ~NoBrokenPipe() {
    const timespec none{};
    while (sigtimedwait(&signal_, nullptr, &none) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoBrokenPipe(const NoBrokenPipe&) = delete;
  NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;

 private:
  sigset_t signal_{};
  sigset_t before_{};
};

// Connects to the first address of a server that accepts. Otherwise sets the reason.
system::Descriptor connected(const Address& server, std::chrono::seconds most,
                             std::string& reason) {
  reason = refused;
  const AddressList list = looked_up(server);
  for (const addrinfo* one = list.get(); one != nullptr; one = one->ai_next) {
    system::Descriptor end(
        socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    int error = connect(end.get(), one->ai_addr, one->ai_addrlen) == 0 ? 0 : errno;
    if (error == EINPROGRESS) {
      pollfd waiting{.fd = end.get(), .events = POLLOUT, .revents = 0};
      if (poll(&waiting, 1, static_cast<int>(most.count() * 1000)) == 0) reason = not_reached;
      socklen_t size = sizeof error;
      if (waiting.revents == 0 || getsockopt(end.get(), SOL_SOCKET, SO_ERROR, &error, &size) != 0)
        continue;
    }
    if (error == 0) return end;
  }
  return system::Descriptor();
}

// True for a host or a path that needs no coding in a request.
bool is_plain(const std::string& text) {
  return std::ranges::none_of(text, [](unsigned char c) {
    return c <= ' ' || c >= 0x7f || c == '?' || c == '#' || c == '@';
  });
}

}  // namespace

Result<HttpClient> HttpClient::open(const std::string& url, ClientOptions options) {
  std::string host = url;
  const bool is_encrypted = host.starts_with("https://");
  const std::size_t begin = is_encrypted ? 8 : host.starts_with("http://") ? 7 : 0;
  host.erase(0, begin);
  HttpClient client;
  const std::size_t path = std::min(host.find('/'), host.size());
  client.base_ = host.substr(path);
  while (client.base_.ends_with('/')) client.base_.pop_back();
  host.erase(path);
  if (begin == 0 || !is_plain(client.base_) || host.empty() || !is_plain(host))
    return fail(Errc::input, url + ": an address like https://league.example:8443 is expected");
  client.host_header_ = host;
  const std::size_t colon = host.rfind(':');
  if (colon == std::string::npos || host.ends_with(']')) host += is_encrypted ? ":443" : ":80";
  const auto address = parse_address(host, url);
  if (!address || !address->path.empty())
    return fail(Errc::input, url + " is no address of a server");
  client.address_ = *address;
  if (is_encrypted) {
    MIROCUP_TRY(client.tls_, system::TlsClient::load(options.authority));
  }
  client.options_ = std::move(options);
  return client;
}

Answer HttpClient::ask(const std::string& method, const std::string& path, std::string_view body,
                       const std::function<bool(std::string_view part)>& take) const {
  const NoBrokenPipe guard;
  std::string request = method + ' ' + base_ + path + " HTTP/1.1\r\nHost: " + host_header_ +
                        "\r\nConnection: close\r\nAccept: */*\r\n";
  if (!options_.token.empty()) request += "Authorization: Bearer " + options_.token + "\r\n";
  if (!body.empty()) request += "Content-Type: application/octet-stream\r\n";
  if (!body.empty() || method == "PUT" || method == "POST")
    request += "Content-Length: " + std::to_string(body.size()) + "\r\n";
  request += "\r\n";
  request += body;

  Answer answer;
  const auto end = steady_clock::now() + options_.time +
                   std::chrono::seconds(static_cast<std::int64_t>(body.size() / slowest_upload));
  const auto socket = connected(address_, options_.connect_time, answer.error);
  std::optional<system::TlsConnection> tls;
  if (socket.is_open() && tls_) {
    auto agreed = tls_->connect(socket.get(), address_.host,
                                static_cast<int>(options_.patience.count() * 1000));
    if (agreed) tls = std::move(*agreed);
    if (!agreed)
      answer.error = agreed.error() == system::TlsRefusal::not_trusted ? not_trusted : not_tls;
  }
  if (socket.is_open() && (tls || !tls_)) {
    Connection connection(socket.get(), tls);
    connection.allow_sending(options_.patience, end);
    // A server that does not want the whole request may still say why.
    (void)connection.send(request);
    connection.allow(options_.max_answer,
                     std::chrono::ceil<std::chrono::seconds>(end - steady_clock::now()),
                     options_.patience);
    receive(connection, method == "HEAD", take, answer);
  }
  if (answer.status == 0 && answer.error != too_much)
    answer.error = "the server does not answer: " + answer.error;
  return answer;
}

void HttpClient::receive(Connection& connection, bool is_head,
                         const std::function<bool(std::string_view part)>& take,
                         Answer& answer) const {
  http::response_parser<http::string_body> parser;
  parser.header_limit(longest_head);
  parser.body_limit(options_.max_answer);
  parser.eager(true);
  parser.skip(is_head);
  answer.error = broken;
  std::string& body = parser.get().body();
  std::string buffer;
  std::array<char, 16384> part;
  while (!parser.is_done()) {
    const auto asked_at = steady_clock::now();
    const std::size_t count = connection.receive(part.data(), part.size());
    boost::beast::error_code error;
    buffer.append(part.data(), count);
    if (count > 0) {
      buffer.erase(0, parser.put({buffer.data(), buffer.size()}, error));
    } else if (connection.is_at_limit() || steady_clock::now() - asked_at >= options_.patience) {
      error = http::error::body_limit;
    } else if (!parser.got_some()) {
      error = http::error::end_of_stream;
    } else {
      parser.put_eof(error);
    }
    if (error == http::error::header_limit || error == http::error::body_limit) {
      answer.error = too_much;
      return;
    }
    if (error && error != http::error::need_more) return;
    if (take && !body.empty()) {
      if (!take(body)) return;
      body.clear();
    }
  }
  answer.status = static_cast<int>(parser.get().result_int());
  answer.body = std::move(body);
  answer.error.clear();
}

}  // namespace mirocup::web
