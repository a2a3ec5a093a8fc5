// SPDX-License-Identifier: MIT
#include "tournaments/handin/replies.hpp"

#include "record/json_reader.hpp"
#include "system/number_of.hpp"

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
  const auto number = system::number_of<int>(text);
  return number.value_or(0) < 1 ? std::nullopt : number;
}

}  // namespace mirocup::league
