// SPDX-License-Identifier: MIT
#include "tournaments/handin/replies.hpp"

#include "record/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <charconv>

namespace mirocup::league {

web::Reply json_reply(int status, const nlohmann::ordered_json& json) {
  return {.status = status, .type = "application/json", .bytes = record::json_text(json) + "\n"};
}

web::Reply problem_reply(int status, const std::string& why) {
  return json_reply(status, {{"error", why}});
}

web::Reply host_failed(const Error&) {
  return problem_reply(503, "this server cannot do that now; try again later");
}

std::optional<int> number_of(std::string_view text) {
  int number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || number < 1) return {};
  return number;
}

}  // namespace mirocup::league
