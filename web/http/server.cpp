// SPDX-License-Identifier: MIT
#include "web/http/server.hpp"

#include "system/secret.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace mirocup::web {

namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr auto poll_interval = 33ms;
constexpr int polls_without_news = 150;  // 5 s
// A comment of server-sent events. Only by sending something is it noticed that a viewer is gone.
constexpr std::string_view sign_of_life = ":\n\n";
constexpr int look_interval_ms = 100;  // between two looks at who has taken too long
constexpr int accepted_at_once = 64;   // between two such looks
constexpr int tls_timeout_ms = 5000;
constexpr int lower_priority = 10;

Reply full() {
  Reply reply = plain_reply(503, "too many viewers: try again later");
  reply.headers.emplace_back("Retry-After", "10");
  return reply;
}

constexpr const char* secret_header = "x-mirocup-proxy";

// Returns the last address of a list, which the proxy next to this server has added.
std::string last_of(const std::string& list) {
  const std::size_t comma = list.rfind(',');
  std::string last = comma == std::string::npos ? list : list.substr(comma + 1);
  std::erase_if(last, [](char c) { return c == ' '; });
  return last;
}

bool is_proxy(const ProxyTrust& trust, const Request& request) {
  if (trust.is_unix_socket) return true;
  if (trust.secret.empty() || !trust.addresses.contains(request.address)) return false;
  return system::is_same_secret(trust.secret, request.header(secret_header));
}

}  // namespace

HttpServer::HttpServer(Handler handler, ServerOptions options)
    : handler_(std::move(handler)),
      options_(std::move(options)),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      entrance_(options_.entrance) {}

HttpServer::~HttpServer() {
  is_closed_ = true;
  eventfd_write(wake_, 1);
  if (thread_.joinable()) thread_.join();
  if (listener_ >= 0) close(listener_);
  if (!address_.path.empty() && listener_ >= 0) unlink(address_.path.c_str());
  std::unique_lock lock(mutex_);
  thread_ended_.wait(lock, [this] { return threads_ == 0; });
  lock.unlock();
  close(wake_);
}

Result<void> HttpServer::listen(const Address& address, const std::string& option) {
  Address bound = address;
  MIROCUP_TRY(listener_, open_listener(bound, option));
  address_ = bound;
  thread_ = std::thread([this] {
    // The threads that this one starts inherit the priority. Matches come first.
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), lower_priority);
    // Nor do they end the program when TLS writes to a viewer that is gone.
    sigset_t broken_pipe;
    sigemptyset(&broken_pipe);
    sigaddset(&broken_pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);
    accept_all();
  });
  return {};
}

int HttpServer::viewers() const {
  const std::lock_guard lock(mutex_);
  return entrance_.streams();
}

void HttpServer::accept_all() {
  while (!is_closed_) {
    std::array<pollfd, 2> waiting{pollfd{.fd = listener_, .events = POLLIN, .revents = 0},
                                  pollfd{.fd = wake_, .events = POLLIN, .revents = 0}};
    poll(waiting.data(), waiting.size(), look_interval_ms);
    eventfd_t ended = 0;
    if ((waiting[1].revents & POLLIN) != 0) eventfd_read(wake_, &ended);
    end_or_let_in();
    for (int i = 0; i < accepted_at_once && (waiting[0].revents & POLLIN) != 0; ++i) {
      if (!accept_one()) break;
    }
  }
  const std::lock_guard lock(mutex_);
  for (const int connection : entrance_.all()) end(connection);
}

bool HttpServer::accept_one() {
  const int connection = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  if (connection < 0) {
    // Out of files: those that are open have to end first.
    if (errno == EMFILE || errno == ENFILE) std::this_thread::sleep_for(poll_interval);
    return false;
  }
  const std::lock_guard lock(mutex_);
  const std::string address = counted_address(address_of_peer(connection));
  switch (entrance_.arrive(connection, address, steady_clock::now())) {
    case Stage::leaving:
      close(connection);
      break;
    case Stage::waiting:
      break;
    default:
      begin(connection);
  }
  return true;
}

// Requires the mutex.
void HttpServer::begin(int connection) {
  try {
    std::thread([this, connection] { serve(connection); }).detach();
    ++threads_;
  } catch (const std::system_error&) {
    entrance_.leave(connection);
    close(connection);
  }
}

// Requires the mutex.
void HttpServer::end(int connection) {
  if (entrance_.has_entered(connection)) {
    shutdown(connection, SHUT_RDWR);  // its thread closes it
  } else {
    entrance_.leave(connection);
    close(connection);
  }
}

void HttpServer::end_or_let_in() {
  const std::lock_guard lock(mutex_);
  const auto now = steady_clock::now();
  for (const int connection : entrance_.to_end(now)) end(connection);
  for (const int connection : entrance_.let_in(now)) begin(connection);
}

void HttpServer::serve(int connection) {
  answer(connection);
  const std::lock_guard lock(mutex_);
  entrance_.leave(connection);
  shutdown(connection, SHUT_RDWR);
  close(connection);
  eventfd_write(wake_, 1);
  --threads_;
  thread_ended_.notify_all();
}

void HttpServer::set_stage(int connection, Stage stage) {
  const std::lock_guard lock(mutex_);
  entrance_.set_stage(connection, stage, steady_clock::now());
}

void HttpServer::answer(int connection) {
  std::optional<system::TlsConnection> tls;
  if (options_.tls) {
    tls = options_.tls->accept(connection, tls_timeout_ms);
    if (!tls) return;
  }
  Connection stream(connection, tls);
  Exchange exchange(stream, options_.bodies);
  auto [refused, has_come] = exchange.receive_head();
  if (!has_come) return;
  Request& request = exchange.request();
  request.address = address_of_peer(connection);
  request.is_encrypted = tls.has_value();
  apply(options_.proxy, request);
  {
    const std::lock_guard lock(mutex_);
    if (request.is_from_proxy) entrance_.name(connection, counted_address(request.viewer));
    entrance_.set_stage(connection, Stage::answering, steady_clock::now());
  }
  const Body body = [&](const std::function<bool(std::string_view)>& take) {
    if (request.method == "PUT") set_stage(connection, Stage::uploading);
    const bool is_whole = exchange.receive_body(take);
    set_stage(connection, Stage::answering);
    return is_whole;
  };
  Reply reply = refused ? std::move(*refused) : Reply();
  if (!refused) {
    try {
      reply = handler_(request, body);
    } catch (const std::exception&) {
      reply = plain_reply(500, "this server has failed");
    }
  }
  send_reply(exchange, connection, reply);
  if (refused || exchange.has_unread_body()) stream.drain();
}

void HttpServer::send_reply(Exchange& exchange, int connection, Reply& reply) {
  if ((!reply.events && !reply.passed_events) || exchange.request().method == "HEAD") {
    exchange.send(reply);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    if (!entrance_.begin_stream(connection, reply.is_for_known, steady_clock::now()))
      reply = full();
  }
  if (!reply.events && !reply.passed_events) {
    exchange.send(reply);
  } else if (exchange.begin_events()) {
    send_events(exchange, reply);
  }
}

void HttpServer::send_events(Exchange& exchange, Reply& reply) {
  if (reply.passed_events) {
    reply.passed_events(
        [&](std::string_view part) { return !is_closed_ && exchange.send_events(part); });
    return exchange.end_events();
  }
  for (int silent = 0; !is_closed_;) {
    EventBatch batch = reply.events();
    silent = batch.text.empty() ? silent + 1 : 0;
    if (silent == polls_without_news) {
      batch.text = sign_of_life;
      silent = 0;
    }
    if (!exchange.send_events(batch.text)) return;
    if (batch.is_last) break;
    std::this_thread::sleep_for(poll_interval);
  }
  exchange.end_events();
}

void apply(const ProxyTrust& trust, Request& request) {
  request.viewer = request.address;
  request.is_from_proxy = is_proxy(trust, request);
  request.headers.erase(secret_header);
  if (!request.is_from_proxy) return;
  if (request.header("x-forwarded-proto") == "https") request.is_encrypted = true;
  const std::string named = last_of(request.header("x-forwarded-for"));
  if (!named.empty()) request.viewer = named;
}

}  // namespace mirocup::web
