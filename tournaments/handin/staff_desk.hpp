// SPDX-License-Identifier: MIT
//
// The page of a league's staff at the desk: the teams and their hand-ins, a form for each act, the
// list of decisions, the grades. Each act has the effect of the `league` command with the same name
// (league/acts.hpp).
//
// Threads: any. The league is opened for each request. Errors are failures of the host.
#pragma once

#include "tournaments/handin/doorkeeper.hpp"
#include "tournaments/handin/own_legs.hpp"
#include "tournaments/league/folder.hpp"
#include "web/http/form.hpp"
#include "web/http/request.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mirocup::league {

using web::Form;
using web::value_of;

class StaffDesk {
 public:
  StaffDesk(system::Files& files, Folder folder, std::function<std::int64_t()> now)
      : files_(files), folder_(std::move(folder)), now_(std::move(now)) {}

  struct Shown {
    int done = 0;           // the number of the decision just written; 0: none
    std::string said = {};  // the answer to the sent form
    int status = 200;       // status of the reply
    Form given = {};        // the values that the forms show at first: of a sent form, or a leg
    std::string root = {};  // web::root_of() the address of the page
  };

  // Returns the page for the staff; a tutor gets the page without forms.
  Result<web::Reply> page(const Visitor& reader, const Shown& shown) const;

  // Returns the link, from the top of the site, to the page whose forms name the given leg.
  static std::string decision_path(const OwnLeg& leg);

  // Returns the page of a team's legs, which links to their replays with the thoughts of both
  // teams, and to the logs of the team. `legs` are the legs of the team.
  Result<web::Reply> legs_of(const Visitor& reader, const std::string& team,
                             const std::vector<OwnLeg>& legs) const;

  // Performs the act of a form of the page, signed by the visitor if the visitor has a name. `root`
  // is web::root_of() the address of the form.
  Result<web::Reply> act(const Visitor& visitor, const Form& form, const std::string& root) const;

  // Returns grades.csv.
  Result<web::Reply> grades() const;

 private:
  system::Files& files_;
  Folder folder_;
  std::function<std::int64_t()> now_;
};

}  // namespace mirocup::league
