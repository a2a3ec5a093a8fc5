// SPDX-License-Identifier: MIT
//
// The common state of the parts of the portal: the book of a league, the league itself, and
// the host's options.
#pragma once

#include "tournaments/handin/entry_report.hpp"
#include "tournaments/handin/portal_league.hpp"

#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::league {

struct PortalOptions {
  Quota quota = {};
  std::string team_header = {};         // in which a trusted proxy names the team: see Doorkeeper
  int max_waiting = 4;                  // the most hand-ins of one team without an answer
  int max_uploads = 2;                  // the most files that one team may send at once
  std::vector<std::string> house = {};  // the house teams for friendlies, without "house:"
  std::function<std::int64_t()> now;    // s since 1970
};

struct DeskState {
  DeskState(system::Files& disk, Folder place, PortalLeague& served, PortalOptions given, Book kept)
      : files(disk),
        folder(std::move(place)),
        league(served),
        options(std::move(given)),
        costs(files, folder),
        book(std::move(kept)) {}

  HandInTerms terms_of(const std::string& team) const {
    return league.hand_in_terms(team, utc_text(options.now()));
  }

  system::Files& files;
  const Folder folder;
  PortalLeague& league;
  const PortalOptions options;
  LegCosts costs;
  std::atomic<std::uint64_t> version{1};  // grows with each change that a team may see

  std::mutex mutex;  // guards the members below
  Book book;
  std::map<std::pair<std::string, int>, CheckStep> steps;  // of the running checks
};

}  // namespace mirocup::league
