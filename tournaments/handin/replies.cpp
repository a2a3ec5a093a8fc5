// SPDX-License-Identifier: MIT
#include "tournaments/handin/replies.hpp"

#include "record/json_reader.hpp"
#include "system/number_of.hpp"
#include "system/printable.hpp"

#include <utility>

namespace mirocup::league {

web::Reply json_reply(int status, const nlohmann::ordered_json& json) {
  return {.status = status, .type = "application/json", .bytes = record::json_text(json) + "\n"};
}

web::Reply problem_reply(int status, const std::string& why) {
  return json_reply(status, {{"error", why}});
}

tl::unexpected<Refusal> refused(int status, std::string why) {
  return tl::unexpected(Refusal{status, std::move(why)});
}

web::Reply reply_to(const Refusal& refusal) {
  web::Reply reply = problem_reply(refusal.status, refusal.why);
  if (refusal.status == 401) reply.headers.emplace_back("WWW-Authenticate", "Bearer");
  if (refusal.wait > 0) reply.headers.emplace_back("Retry-After", std::to_string(refusal.wait));
  return reply;
}

web::Reply desk_reply(int status, std::string html) {
  constexpr const char* policy =
      "default-src 'none'; style-src 'self'; script-src 'self'; connect-src 'self'; "
      "form-action 'self'; base-uri 'none'; frame-ancestors 'none'";
  return {.status = status,
          .type = "text/html; charset=utf-8",
          .bytes = std::move(html),
          .headers = {{"Content-Security-Policy", policy}}};
}

web::Reply log_reply(system::Files& files, const std::string& path) {
  const auto log = files.read_if_there(path, {.max_size = system::size_limit::log});
  if (!log) return host_failed(log.error());
  return {.status = 200, .bytes = system::printable(log->value_or(""), system::LineEnds::kept)};
}

web::Reply replay_reply(std::optional<std::string> page) {
  if (!page) return problem_reply(503, "the replay cannot be made here");
  return {.status = 200, .type = "text/html; charset=utf-8", .bytes = std::move(*page)};
}

Refusal refusal_of_host(const Error&) {
  return {503, "this server cannot do that now; try again later"};
}

web::Reply host_failed(const Error& error) {
  return reply_to(refusal_of_host(error));
}

web::Reply host_failed_for_staff(const Error& error) {
  return {.status = 503, .bytes = error.what + "\n"};
}

web::Reply moved_to(const std::string& address, const std::string& cookie) {
  web::Reply reply{.status = 303, .headers = {{"Location", address}}};
  if (!cookie.empty()) reply.headers.emplace_back("Set-Cookie", cookie);
  return reply;
}

std::optional<int> number_of(std::string_view text) {
  const auto number = system::number_of<int>(text);
  return number.value_or(0) < 1 ? std::nullopt : number;
}

}  // namespace mirocup::league
