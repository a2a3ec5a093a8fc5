// SPDX-License-Identifier: MIT
//
// One match on this host: a leg, the seats of its teams, the network, the viewers, and the data for
// the record.
#pragma once

#include "core/match/leg.hpp"
#include "core/replay/recording.hpp"
#include "plugins/host/process_controller.hpp"
#include "record/match_record.hpp"
#include "record/thoughts_file.hpp"
#include "server/network.hpp"
#include "server/pace/pacer.hpp"
#include "server/seats.hpp"
#include "system/interrupt.hpp"
#include "web/live_server.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::server {

struct SessionTerms {
  NetworkTerms network;
  bool thoughts = false;  // true: keeps the shapes that the teams draw
  bool trusted = false;   // true: libraries play in this process
  std::string isolation;  // "T1" or "T2"; "": the strongest that this system allows
  // True: the team keeps its present name instead of the name that its library gives.
  match::ByTeam<bool> keeps_name{};
  // The files for the output of programs that the match starts.
  match::ByTeam<std::string> logs{"/dev/null", "/dev/null"};
};

// A match. Call the functions below this class in their order, each once. Threads: one.
struct Session {
  // `factor`: simulated seconds per second; if empty, the match plays as fast as possible.
  Session(SessionTerms terms, const match::Setup& setup, std::optional<double> factor);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  SessionTerms terms;
  system::Interrupt interrupt;  // must come before all members that may start a thread
  match::Leg leg;
  double speed;  // factor of real time; 0: as fast as possible
  pace::SteadyWallClock clock;
  pace::Pacer pacer;
  Network network;
  std::shared_ptr<plugins::Doorbell> bell = std::make_shared<plugins::Doorbell>();
  std::shared_ptr<plugins::MemoryWitness> memory = std::make_shared<plugins::MemoryWitness>();
  std::vector<TeamSeat> seats;  // blue, yellow
  std::string isolation = "network";
  std::unique_ptr<web::LiveServer> live;  // null unless the leg is watched
  match::ByTeam<record::ThoughtsWriter> thoughts;
  replay::StateTrace trace;
  std::optional<record::PlayedOnFrom> from;  // the record that this leg continues
};

// Plays the recorded ticks before `until`. So the leg remembers everything on which later ticks
// depend: counts of the laws, disturbances, the camera's view, commands on their way. `path` names
// the record in errors. Errc::damaged if the record is not reproduced.
Result<void> play_past(Session& session, const record::MatchRecord& past, std::uint32_t until,
                       const std::string& path);

// Starts the teams, blue first, and waits until they can play. A team that can never play makes the
// leg void or forfeited.
Result<void> seat_teams(Session& session, const match::ByTeam<TeamChoice>& teams);

// Shows the leg in browsers at [HOST:]PORT ("": any free port), and prints the address.
Result<void> open_live_page(Session& session, const std::string& where);

// Plays the leg to its end. Errc::interrupted if a signal came; then the leg has no result.
Result<void> play(Session& session);

record::MatchRecord record_of(const Session& session);

}  // namespace mirocup::server
