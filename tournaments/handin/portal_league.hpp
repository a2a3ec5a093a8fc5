// SPDX-License-Identifier: MIT
//
// The league that a portal serves: what the portal asks of it. In the class itself the league has
// no legs and no pages, and names and times stay as they are.
//
// Threads: all functions may be called by any thread at any time.
#pragma once

#include "tournaments/handin/own_legs.hpp"
#include "tournaments/league/submission.hpp"

namespace mirocup::league {

class PortalLeague {
 public:
  virtual ~PortalLeague() = default;

  // Calls league::hand_in_terms(). `now` is UTC.
  virtual HandInTerms hand_in_terms(const std::string& team, const std::string& now) = 0;

  // Returns the decided legs of a team that a viewer, the team or the staff, may see.
  virtual std::vector<OwnLeg> legs_of(Viewer, const std::string& /*team*/) { return {}; }

  // Returns a team's digest of the last night as part of a page of the desk; "" if the night is
  // hidden, or if there was no night.
  virtual std::string digest_of(const std::string& /*team*/) { return {}; }

  // Returns the replay page of a leg that a team may see, by the name of its record. The page shows
  // the kept thoughts and the output of the given teams. `links` is HTML that follows the links to
  // the league. Returns nothing if the leg has no page.
  virtual std::optional<std::string> own_replay(const std::string& /*name*/, const record::Whose&,
                                                const std::string& /*links*/) {
    return std::nullopt;
  }

  // Returns the page that replays the record at a path, with the thoughts and output of the teams
  // in `whose`; nothing if the page cannot be made. `root`: web::root_of() its address.
  virtual std::optional<std::string> replay_of(const std::string& /*record*/, const record::Whose&,
                                               const std::string& /*root*/) {
    return std::nullopt;
  }

  // Returns sheets_of_team(); null if sheets.json cannot be read, which the staff page says.
  virtual Json sheets_of(const std::string& /*team*/) { return {}; }

  // Returns the name that pages show for a team.
  virtual std::string shown_name_of(const std::string& team) { return team; }

  // Returns a time of a book, "2026-11-25T01:02:03Z", in the league's time zone.
  virtual std::string time_in_words(const std::string& utc) { return utc; }

  // Returns the teams against which a friendly can be played, and the number of the entry with
  // which they play by the journal; 0: none yet.
  virtual std::map<std::string, int> booked_entries() { return {}; }

  // Returns the neighbours of a team in the table that visitors see, the team above first; none
  // before the start.
  virtual std::vector<std::string> neighbours_of(const std::string& /*team*/) { return {}; }

  // True if entries try drills: the league has the field of the drills.
  virtual bool has_drills() const { return false; }

  // Called when this program has written to the league's folder, before anybody gets the answer:
  // what the other functions return from now on shows it.
  virtual void note_own_write() {}
};

}  // namespace mirocup::league
