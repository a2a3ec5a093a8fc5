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

web::Reply host_failed(const Error&) {
  return problem_reply(503, "this server cannot do that now; try again later");
}

std::optional<int> number_of(std::string_view text) {
  const auto number = system::number_of<int>(text);
  return number.value_or(0) < 1 ? std::nullopt : number;
}

}  // namespace mirocup::league
