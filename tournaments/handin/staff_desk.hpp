// SPDX-License-Identifier: MIT
//
// The page of those who run a league, at the desk in the network: the teams and what they have
// handed in, a form for each act, the list of decisions, the grades. Each act is that of the
// command of the same name (league/acts.hpp).
//
// Threads: any. The league is opened for each request.
#pragma once

#include "tournaments/handin/own_legs.hpp"
#include "tournaments/handin/tokens.hpp"
#include "tournaments/league/folder.hpp"
#include "web/request.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mirocup::league {

class StaffDesk {
 public:
  StaffDesk(system::Files& files, Folder folder, std::function<std::int64_t()> now)
      : files_(files), folder_(std::move(folder)), now_(std::move(now)) {}

  // Returns the page as the staff reads it, or a tutor, who has no forms. `done` is the number of a
  // decision that was just written, or 0; `said` a sentence that stands on top, and `status` that
  // of the reply.
  web::Reply page(Role reader, int done = 0, const std::string& said = "", int status = 200) const;

  // Returns the page of a team's legs, which links to their replays with what both teams drew, and
  // to what the team printed. `legs` are those of the team.
  web::Reply legs_of(const std::string& team, const std::vector<OwnLeg>& legs) const;

  // Performs what a form of the page asks for: the body as a browser sends it.
  web::Reply act(const std::string& form) const;

  // Returns grades.csv.
  web::Reply grades() const;

 private:
  system::Files& files_;
  Folder folder_;
  std::function<std::int64_t()> now_;
};

}  // namespace mirocup::league
