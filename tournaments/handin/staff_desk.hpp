// SPDX-License-Identifier: MIT
//
// The page of a league's staff at the desk: the teams and their hand-ins, a form for each act, the
// list of decisions, the grades. Each act is that of the command of the same name
// (league/acts.hpp).
//
// Threads: any. The league is opened for each request.
#pragma once

#include "tournaments/handin/form.hpp"
#include "tournaments/handin/own_legs.hpp"
#include "tournaments/handin/tokens.hpp"
#include "tournaments/league/folder.hpp"
#include "web/http/request.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mirocup::league {

class StaffDesk {
 public:
  StaffDesk(system::Files& files, Folder folder, std::function<std::int64_t()> now)
      : files_(files), folder_(std::move(folder)), now_(std::move(now)) {}

  // Returns the page for the staff, or for a tutor without forms. `done` is the number of a
  // decision that was just written, or 0; `said` is a sentence for the top of the page; `status` is
  // that of the reply.
  web::Reply page(Role reader, int done = 0, const std::string& said = "", int status = 200) const;

  // Returns the page of a team's legs, which links to their replays with the thoughts of both
  // teams, and to the logs of the team. `legs` are those of the team.
  web::Reply legs_of(const std::string& team, const std::vector<OwnLeg>& legs) const;

  // Performs the act of a form of the page.
  web::Reply act(const Form& form) const;

  // Returns grades.csv.
  web::Reply grades() const;

 private:
  system::Files& files_;
  Folder folder_;
  std::function<std::int64_t()> now_;
};

}  // namespace mirocup::league
