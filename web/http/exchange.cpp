// SPDX-License-Identifier: MIT
#include "web/http/exchange.hpp"

#include "system/text.hpp"
#include "web/http/form.hpp"

#include <algorithm>
#include <array>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/status.hpp>
#include <limits>

namespace mirocup::web {

namespace {

namespace http = boost::beast::http;
using namespace std::chrono_literals;

constexpr std::size_t max_head = 64u << 10;  // bytes of line and headers
constexpr std::size_t max_target = 8192;     // bytes
constexpr auto request_time = 10s;
constexpr auto patience = 5s;                              // for a viewer that sends nothing
constexpr auto upload_time = std::chrono::seconds(10min);  // 32 MiB take that long at 0.5 Mbit/s
constexpr auto upload_patience = 20s;                      // for a student's wireless network

// A line that begins with a space continues a header. Beast joins the two, some proxies do not.
bool has_folded_line(std::string_view head) {
  return head.find("\n ") != std::string_view::npos || head.find("\n\t") != std::string_view::npos;
}

bool is_number(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::string status_line(int status, bool is_for_ever = false) {
  const auto reason = http::obsolete_reason(http::int_to_status(static_cast<unsigned>(status)));
  return "HTTP/1.1 " + std::to_string(status) + " " + std::string(reason.data(), reason.size()) +
         "\r\nConnection: close\r\nX-Content-Type-Options: nosniff\r\nCache-Control: " +
         (is_for_ever ? "max-age=31536000, immutable\r\n" : "no-store\r\n");
}

}  // namespace

Reply plain_reply(int status, const std::string& why) {
  return {.status = status, .bytes = why + "\n"};
}

struct Exchange::Parser : http::request_parser<http::buffer_body> {};

Exchange::Exchange(Connection& connection, const BodyLimits& limits)
    : connection_(connection), limits_(limits), parser_(std::make_unique<Parser>()) {
  parser_->header_limit(max_head);
  // Handlers say in their own words what is too large, and receive_body() counts.
  parser_->body_limit(std::numeric_limits<std::uint64_t>::max());
  connection_.allow(max_head + limits_.max_body, request_time, patience);
}

Exchange::~Exchange() = default;

bool Exchange::fill_buffer() {
  std::array<char, 16384> part;
  const std::size_t count = connection_.receive(part.data(), part.size());
  buffer_.append(part.data(), count);
  return count > 0;
}

std::pair<std::optional<Reply>, bool> Exchange::receive_head() {
  while (!parser_->is_header_done()) {
    boost::beast::error_code error;
    parsed_ += parser_->put({buffer_.data() + parsed_, buffer_.size() - parsed_}, error);
    if (error && error != http::error::need_more) {
      if (error == http::error::header_limit)
        return {plain_reply(431, "the headers are too long"), true};
      return {plain_reply(400, "this is no request: " + error.message()), true};
    }
    if (parser_->is_header_done()) break;
    if (buffer_.size() > max_head) return {plain_reply(431, "the headers are too long"), true};
    if (error && !fill_buffer()) return {std::nullopt, false};
  }
  auto refused = objection();
  if (!refused) fill_request();
  buffer_.erase(0, parsed_);
  parsed_ = 0;
  return {std::move(refused), true};
}

// What a proxy before this server might understand in another way.
std::optional<Reply> Exchange::objection() {
  const auto& head = parser_->get();
  request_.method = std::string(head.method_string().data(), head.method_string().size());
  for (const auto& field : head) {
    request_.headers.emplace(
        system::lower_case({field.name_string().data(), field.name_string().size()}),
        std::string(field.value().data(), field.value().size()));
  }
  is_http_1_0_ = head.version() == 10;
  const auto& headers = request_.headers;
  if (head.version() != 10 && head.version() != 11) return plain_reply(505, "HTTP/1.1 is expected");
  if (has_folded_line(std::string_view(buffer_).substr(0, parsed_)))
    return plain_reply(400, "a header is folded over two lines");
  if (headers.count("host") > 1 || (!is_http_1_0_ && !headers.contains("host")))
    return plain_reply(400, "exactly one Host header is expected");
  const std::size_t lengths = headers.count("content-length");
  if (lengths > 1 || (lengths == 1 && !is_number(headers.find("content-length")->second)))
    return plain_reply(400, "one number is expected as Content-Length");
  if (headers.contains("transfer-encoding")) {
    if (lengths > 0) return plain_reply(400, "two lengths are given");
    if (is_http_1_0_ || system::lower_case(request_.header("transfer-encoding")) != "chunked")
      return plain_reply(400, "Transfer-Encoding can only be chunked");
  }
  if (headers.contains("content-encoding"))
    return plain_reply(415, "send the file as it is, without Content-Encoding");
  if (headers.contains("expect") && system::lower_case(request_.header("expect")) != "100-continue")
    return plain_reply(417, "Expect can only be 100-continue");
  if (head.target().size() > max_target) return plain_reply(414, "the address is too long");
  return std::nullopt;
}

void Exchange::fill_request() {
  const auto target = parser_->get().target();
  const std::string_view whole(target.data(), target.size());
  const std::size_t mark = std::min(whole.find('?'), whole.size());
  request_.path = decoded(whole.substr(0, mark), false);
  add_form_values(whole.substr(std::min(mark + 1, whole.size())), request_.query);
}

bool Exchange::has_unread_body() const {
  return parser_->is_header_done() && !parser_->is_done();
}

bool Exchange::receive_body(const std::function<bool(std::string_view part)>& take) {
  const bool is_upload = request_.method == "PUT" && limits_.max_upload > 0;
  const std::size_t most = is_upload ? limits_.max_upload : limits_.max_body;
  if (is_upload) connection_.allow(most + max_head, upload_time, upload_patience);
  if (buffer_.empty() && has_unread_body() && request_.headers.contains("expect") &&
      !connection_.send("HTTP/1.1 100 Continue\r\n\r\n"))
    return false;
  std::string part(64u << 10, '\0');
  std::size_t received = 0;
  while (!parser_->is_done()) {
    auto& body = parser_->get().body();
    body.data = part.data();
    body.size = part.size();
    boost::beast::error_code error;
    const std::size_t used = parser_->put({buffer_.data(), buffer_.size()}, error);
    buffer_.erase(0, used);
    const std::size_t count = part.size() - body.size;
    received += count;
    // One byte more is given, so that the handler can tell that there was too much.
    if (count > 0 && !take(std::string_view(part).substr(0, count))) return false;
    if (received > most) return false;
    if (error && error != http::error::need_buffer && error != http::error::need_more) return false;
    if (error == http::error::need_more || buffer_.empty()) {
      if (parser_->is_done()) break;
      // The head of a chunk is short.
      if (buffer_.size() > max_head || !fill_buffer()) return false;
    }
  }
  // Nobody needs headers behind the chunks, which Beast reads less strictly than those before them.
  const auto& fields = parser_->get();
  return std::distance(fields.begin(), fields.end()) ==
         static_cast<std::ptrdiff_t>(request_.headers.size());
}

bool Exchange::send(const Reply& reply) {
  std::string text = status_line(reply.status, reply.is_for_ever);
  if (!reply.bytes.empty()) text += "Content-Type: " + reply.type + "\r\n";
  text += "Content-Length: " + std::to_string(reply.bytes.size()) + "\r\n";
  for (const auto& [name, value] : reply.headers) text += name + ": " + value + "\r\n";
  text += "\r\n";
  if (request_.method != "HEAD") text += reply.bytes;
  return connection_.send(text);
}

bool Exchange::begin_events() {
  // nginx passes on at once what has this header, and keeps other answers for slow viewers.
  return connection_.send(status_line(200) + "Content-Type: text/event-stream\r\n" +
                          "X-Accel-Buffering: no\r\n" +
                          (is_http_1_0_ ? "" : "Transfer-Encoding: chunked\r\n") + "\r\n");
}

bool Exchange::send_events(std::string_view part) {
  if (part.empty()) return true;
  if (is_http_1_0_) return connection_.send(part);
  return connection_.send(system::formatted("%zx\r\n", part.size()) + std::string(part) + "\r\n");
}

void Exchange::end_events() {
  if (!is_http_1_0_) connection_.send("0\r\n\r\n");
}

}  // namespace mirocup::web
