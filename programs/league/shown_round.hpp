// SPDX-License-Identifier: MIT
//
// A round that `mirocup league show` shows on a projector: the page, the recorded legs, the table
// after each leg, and the commands of a remote. The league is read once, so the page does not show
// legs that are played later.
//
// Threads: all public functions may be called by any thread at any time.
#pragma once

#include "record/match_record.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/publish/rounds.hpp"
#include "web/site_server.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace mirocup::league {

class ShownRound {
 public:
  // `round` is the key of a round ("r3", "k1"); "": the last round with a played leg. `key` is the
  // secret of the remote. `at_once`: number of legs side by side, until the remote changes the
  // number. Errors: Errc::input if the league lacks the round, or no leg of the round has a record.
  static Result<ShownRound> of(system::Files& files, const LeagueStore& store,
                               const std::string& round, std::string key, int at_once);

  // The functions of web::Site.
  std::optional<web::Page> page(const std::string& path);
  std::string news(std::uint64_t& seen);
  bool control(const std::string& body);

  const std::string& title() const { return title_; }
  std::size_t legs() const { return legs_.size(); }

 private:
  struct Leg {
    Json about;          // about the leg, for the programme
    std::string record;  // path of the record
    std::string page;    // path of the leg's replay page, if the league was published
  };

  ShownRound(system::Files& files, std::string key, int at_once)
      : files_(&files), key_(std::move(key)), at_once_(at_once) {}
  Result<void> read(const LeagueStore& store, const std::string& round);
  std::optional<web::Page> leg(const Leg& leg);
  std::optional<Json> data_of(const Leg& leg, const record::MatchRecord& record);

  system::Files* files_;
  std::string key_;
  int at_once_;
  std::string league_;
  std::string title_;
  std::vector<Leg> legs_;
  std::vector<std::string> standings_;  // HTML of the table after 0, 1, … legs
  std::vector<std::string> next_;       // fixtures of the next round, in words
  std::string champion_;                // HTML; "": the league is not over after this round

  // Members on the heap, so that the round can be moved before it is served.
  struct Commands {
    std::mutex mutex;  // guards `given`
    std::vector<std::string> given;
  };
  std::unique_ptr<Commands> commands_ = std::make_unique<Commands>();
};

}  // namespace mirocup::league
