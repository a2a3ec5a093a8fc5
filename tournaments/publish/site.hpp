// SPDX-License-Identifier: MIT
//
// The league as a folder of pages that work without a server, and as files for other programs. Its
// content depends only on the league's state: equal results give equal bytes, in any order of legs
// and on any machines.
//
// The files are index.html, crosstable.html, a page for each round below rounds/ and for each team
// below teams/, the style sheet and the script of these pages, and the files of exports() and
// statistics_exports(). publish_legs() makes the replay pages and the statistics of each leg.
#pragma once

#include "tournaments/publish/front_page.hpp"
#include "tournaments/publish/league_statistics.hpp"
#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/night.hpp"
#include "tournaments/publish/site_file.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

// The data from which a site is made.
struct SiteSource {
  LeagueState state;
  KnownLegs legs = {};                           // of the played legs; optional
  std::optional<Night> night = {};               // adds night.html and digests/
  std::function<std::string()> playground = {};  // makes playground.html; null: no playground
  std::string closing_page = "../final/site/index.html";  // of the closing round, from index.html
};

// Returns style.css, for pages that stand beside no league.
std::string site_style();

// Makes each file of the site only when a caller asks for the file. Threads: any number at a time.
class Site {
 public:
  explicit Site(SiteSource source);
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;

  // Returns the names of all files of the site, paths inside site/, in alphabetical order.
  std::vector<std::string> names() const;

  // Makes a file. Returns nothing if the site has no file of that name.
  std::optional<std::string> file(const std::string& name) const;

  const LeagueState& state() const { return source_.state; }
  const Overview& overview() const { return overview_; }

 private:
  FileMakers makers();

  const SiteSource source_;
  const Overview overview_;
  const LegReports reports_;
  SiteContent content_;
  FileMakers makers_;
};

// Returns the table as lines of text for a terminal.
std::string table_text(const LeagueState& state);

}  // namespace mirocup::league
