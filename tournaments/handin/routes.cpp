// SPDX-License-Identifier: MIT
#include "tournaments/handin/routes.hpp"

#include "system/text.hpp"
#include "tournaments/handin/replies.hpp"

#include <algorithm>

namespace mirocup::league {

std::optional<std::vector<std::string_view>> match_path(std::string_view pattern,
                                                        std::string_view path) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t star = pattern.find('*');
    if (star == std::string_view::npos)
      return path == pattern ? std::optional(parts) : std::nullopt;
    if (path.substr(0, star) != pattern.substr(0, star)) return std::nullopt;
    path.remove_prefix(star);
    pattern.remove_prefix(star + 1);
    const bool is_rest = pattern == "*";
    const std::size_t end = is_rest ? path.size() : std::min(path.find('/'), path.size());
    if (!is_rest && end == 0) return std::nullopt;
    parts.push_back(path.substr(0, end));
    if (is_rest) return parts;
    path.remove_prefix(end);
  }
}

std::optional<web::Reply> refused_role(Who who, const Visitor& visitor) {
  const Role role = visitor.role;
  if (who == Who::team && role != Role::team)
    return problem_reply(403, "a staff token cannot do this for a team");
  if ((who == Who::grader || who == Who::staff) && role == Role::team)
    return problem_reply(403, "this is for the staff only");
  if (who == Who::grader && !sees_grades(role))
    return problem_reply(403, "the grades are for the staff and tutors only");
  if (who == Who::staff && !decides(role))
    return problem_reply(403, "a tutor's token reads what the staff reads, and decides nothing");
  return std::nullopt;
}

web::Reply use_reply(const web::Request& request, const std::vector<std::string_view>& methods) {
  std::vector<std::string_view> fitting;
  for (const std::string_view method : methods)
    if (method != "GET") fitting.push_back(method);
  if (fitting.empty() || request.is_reading()) fitting = methods;
  web::Reply reply = problem_reply(405, "use " + system::joined(fitting, " or "));
  reply.headers.emplace_back("Allow", system::joined(methods, ", "));
  return reply;
}

}  // namespace mirocup::league
