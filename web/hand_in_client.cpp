// SPDX-License-Identifier: MIT
#include "web/hand_in_client.hpp"

#include "record/json_reader.hpp"
#include "system/text.hpp"

#include <httplib.h>

#include <algorithm>

namespace mirocup::web {

namespace {

constexpr int connect_seconds = 10;
constexpr int answer_seconds = 60;
constexpr std::size_t max_answer = 8u << 20;  // bytes
constexpr std::size_t part = 64u << 10;       // bytes sent at once

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

DeskReply reply_of(const httplib::Result& result, const std::string& body) {
  DeskReply reply;
  if (!result) {
    reply.error = "the server does not answer: " + words_of(result.error());
    return reply;
  }
  reply.status = result->status;
  record::ParsedJson parsed = record::parse_json(body);
  if (!parsed.problem && parsed.value.is_object()) reply.json = std::move(parsed.value);
  const bool has_error =
      reply.json.is_object() && reply.json.contains("error") && reply.json["error"].is_string();
  reply.error = has_error ? reply.json["error"].get<std::string>()
                          : "the server answers with status " + std::to_string(reply.status);
  return reply;
}

}  // namespace

struct HandInClient::Impl {
  explicit Impl(const std::string& url) : client(url) {}

  DeskReply get(const std::string& path) {
    std::string body;
    const auto result = client.Get(path, headers, [&body](const char* bytes, std::size_t count) {
      body.append(bytes, count);
      return body.size() <= max_answer;
    });
    return reply_of(result, body);
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

DeskReply HandInClient::about() {
  return impl_->get("/api/v1/team");
}

DeskReply HandInClient::put(const std::string& name, const std::string& bytes) {
  const auto give = [&bytes](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
    return sink.write(bytes.data() + offset, std::min(length, part));
  };
  const auto result =
      impl_->client.Put("/api/v1/entries?name=" + system::percent_coded(name), impl_->headers,
                        bytes.size(), give, "application/octet-stream");
  return reply_of(result, result ? result->body : "");
}

DeskReply HandInClient::pin(const std::string& entry) {
  const auto result = impl_->client.Put("/api/v1/pin?entry=" + system::percent_coded(entry),
                                        impl_->headers, "", "text/plain");
  return reply_of(result, result ? result->body : "");
}

DeskReply HandInClient::friendlies() {
  return impl_->get("/api/v1/friendlies");
}

DeskReply HandInClient::entry(int number) {
  return impl_->get("/api/v1/entries/" + std::to_string(number));
}

}  // namespace mirocup::web
