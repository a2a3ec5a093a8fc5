// SPDX-License-Identifier: MIT
//
// The site of `mirocup league serve`: the pages that publish would write, made from the present
// journal; records and replays; and the legs that are being played. The class only reads the
// league's folder.
//
// Threads: all public functions may be called by any thread at any time.
#pragma once

#include "tournaments/handin/portal_league.hpp"
#include "tournaments/publish/replay_pages.hpp"
#include "tournaments/publish/site.hpp"
#include "web/page.hpp"
#include "web/playground.hpp"
#include "web/site_server.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <set>

namespace mirocup::league {

class ServedLeague final : public PortalLeague {
 public:
  ServedLeague(system::Files& files, LeagueStore store) : files_(files), store_(std::move(store)) {}

  // The functions of web::Site.
  std::optional<web::Page> page(const std::string& path);
  std::string news(std::uint64_t& seen);
  std::optional<int> match(const std::string& name);

  // From now on the pages link to the form for hand-ins.
  void offer_hand_in() { takes_hand_ins_ = true; }

  // The functions of PortalLeague. Without note_own_write() they may return data of half a second
  // ago.
  HandInTerms hand_in_terms(const std::string& team, const std::string& now) override;
  std::vector<OwnLeg> legs_of(Viewer viewer, const std::string& team) override;
  std::string digest_of(const std::string& team) override;
  std::optional<std::string> own_replay(const std::string& name, const record::Whose& whose,
                                        const std::string& links) override;
  std::optional<std::string> replay_of(const std::string& record, const record::Whose& whose,
                                       const std::string& root) override;
  Json sheets_of(const std::string& team) override;
  std::string shown_name_of(const std::string& team) override;
  std::string time_in_words(const std::string& utc) override;
  std::map<std::string, int> booked_entries() override;
  std::vector<std::string> neighbours_of(const std::string& team) override;
  bool has_drills() const override { return store_.state().file.league == RobotLeague::small; }
  void note_own_write() override { has_written_ = true; }

 private:
  // A leg that is being played and can be watched.
  struct LiveLeg {
    std::string name;  // name of the leg's record, without ".json"
    Json about;        // for page/league.js
    int port = 0;

    bool operator==(const LiveLeg&) const = default;
  };

  void poll();
  void notice_edits();
  bool open_again();
  std::vector<LiveLeg> find_live_legs() const;
  void begin_pages();
  void note_what_is_shown();
  SeenState seen_by(Viewer viewer);
  const web::Page* page_of_site(const std::string& path);
  bool are_pages_fresh() const;
  std::optional<web::Page> replay(const std::string& stem);
  Json part_of(const std::string& record);
  std::optional<std::string> made_page(const std::string& record, const record::Whose& whose,
                                       const Json& part, const std::string& root,
                                       const std::string& commands = "");
  std::optional<web::Page> file(const std::string& path) const;
  const std::vector<web::WorkbenchFile>& workbench();
  std::optional<web::Page> workbench_page(const std::string& name);
  std::optional<web::Page> module_page(const std::string& name);
  std::optional<web::Page> commands_page(const std::string& stem);
  std::optional<web::Page> page_of_closing_round(const std::string& name);
  std::optional<web::Proof> proof(const std::string& root, const std::string& commands_file = "");
  const PageParts& parts();

  system::Files& files_;
  std::atomic<bool> has_written_{false};  // since the last look at the folder
  std::mutex mutex_;                      // guards all members up to replaying_
  LeagueStore store_;
  std::string config_;  // the last text of league.json
  bool takes_hand_ins_ = false;
  std::chrono::steady_clock::time_point polled_at_{};
  std::uint64_t version_ = 0;  // grows with each change of the pages or of the live legs
  std::size_t lines_ = 0;      // number of lines of the journal
  std::vector<LiveLeg> live_legs_;
  std::uint64_t teams_version_ = 0;     // grows when teams or their names change
  std::uint64_t version_of_pages_ = 0;  // teams_version_ when the pages were made
  std::size_t lines_of_pages_ = 0;      // lines_ when the pages were made
  std::chrono::steady_clock::time_point pages_rest_until_{};
  std::unique_ptr<Site> site_;  // the site of the released part; null before the first page
  std::string shown_;           // differs after each change of what the site shows
  std::string said_;            // the texts of teams.json and notice.txt
  KnownLegs legs_;
  std::map<std::string, web::Page> pages_;     // pages of site_ that were asked for, by path
  std::set<std::string> records_;              // names of records without .json
  std::vector<web::WorkbenchFile> workbench_;  // empty before the first request

  std::mutex replaying_;  // held while a replay page is made; pages are made one at a time
  std::once_flag parts_made_;
  PageParts parts_;  // of the pages of this program; set by parts()
};

}  // namespace mirocup::league
