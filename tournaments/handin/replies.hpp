// SPDX-License-Identifier: MIT
//
// The replies of the HTTP API: JSON, logs, replays; after a failure, {"error"} with a sentence.
#pragma once

#include "system/files.hpp"
#include "web/http/request.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace mirocup::league {

// The reply to a request; as an error, one that refuses it.
using ReplyOrRefusal = tl::expected<web::Reply, web::Reply>;

// Why a request is refused.
struct Refusal {
  int status = 401;
  std::string why;        // a sentence
  std::int64_t wait = 0;  // s until the sender may try again; 0: no wait
};
tl::unexpected<Refusal> refused(int status, std::string why);
web::Reply reply_to(const Refusal& refusal);

web::Reply json_reply(int status, const nlohmann::ordered_json& json);
web::Reply problem_reply(int status, const std::string& why);

// Shows a page of the desk, which takes content and sends forms nowhere else.
web::Reply desk_reply(int status, std::string html);

// Shows a log as it may be printed; an empty one if there is none.
web::Reply log_reply(system::Files& files, const std::string& path);

// Shows the page of a replay, or says that it could not be made.
web::Reply replay_reply(std::optional<std::string> page);

// Return a 503 without the reason, which a stranger may not learn.
Refusal refusal_of_host(const Error&);
web::Reply host_failed(const Error&);

// The same for the staff, which is told the reason, as the host is.
web::Reply host_failed_for_staff(const Error& error);

// Leads a browser that has sent a form to another page.
web::Reply moved_to(const std::string& address, const std::string& cookie = "");

// Returns the number in a text of digits alone, at least 1; nothing for any other text.
std::optional<int> number_of(std::string_view text);

}  // namespace mirocup::league
