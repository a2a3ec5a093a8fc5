// SPDX-License-Identifier: MIT
//
// The seats of the two teams of a leg. A team is a library or a file of Python, in a separate
// process or in this process, or a program on the network.
#pragma once

#include "plugins/host/process_controller.hpp"
#include "plugins/host/trusted_controller.hpp"
#include "record/match_record.hpp"
#include "server/dds/match_server.hpp"
#include "server/firasim/server.hpp"
#include "system/interrupt.hpp"

#include <cassert>
#include <memory>
#include <span>
#include <string>

namespace mirocup::server {

// A team from the command line.
struct TeamChoice {
  record::TeamInfo info;
  std::string library;       // path of the library or Python file; "" for a team on the network
  std::string network_name;  // the name of a team on the network; "" for other teams
  std::optional<plugins::SealedEntry> entry;  // the bytes of the file at the time of choose_team()
  std::optional<match::Fault> fault;          // the fault of a file that cannot be loaded
};

// Reads a team. `text` is "dds:NAME", "firasim:NAME", the path of a library or of a file of Python,
// or the name of a house team. If a file cannot be loaded, this is not an error: the choice has a
// fault of the team.
Result<TeamChoice> choose_team(const std::string& text);

// The place of one team in a leg: starts and asks a team of any kind.
class TeamSeat {
 public:
  // Each function starts the team or makes its seat on the network, and does not wait until the
  // team is ready. An error is a failure of the host; wait_until_ready() returns faults of the
  // team. A library gets the parameters of `choice.info`.
  static Result<TeamSeat> take_in_process(const TeamChoice& choice, const match::Briefing& briefing,
                                          const plugins::ProcessTerms& terms);
  static Result<TeamSeat> take_trusted(const TeamChoice& choice, const match::Briefing& briefing,
                                       bool keeps_thoughts = false);
  static Result<TeamSeat> take_on_network(const TeamChoice& choice, const match::Briefing& briefing,
                                          dds::MatchServer& server, const dds::JoinTerms& patience);
  // `server` and `leg` must outlive the seat.
  static Result<TeamSeat> take_at_firasim(const TeamChoice& choice, const match::Leg& leg,
                                          Team team, firasim::Server& server,
                                          const firasim::Terms& terms);

  // Waits until the team can play. The error says why the team can never play: a Fault of the team,
  // or a HostFailure.
  tl::expected<void, match::Answer> wait_until_ready();

  // False if a team on the network was ready and has left since.
  bool is_there() const { return network_ == nullptr || network_->is_there(); }

  // Returns the controller, which lives as long as the seat. Precondition: the team is ready.
  match::Controller& controller() {
    assert(controller_ != nullptr);
    return *controller_;
  }
  const record::TeamInfo& info() const { return info_; }

  // Returns the name that the library gives the team; "" if the team has no library, is not ready,
  // or has a name that cannot be printed on a line.
  std::string own_name() const;
  void rename(const std::string& name) { info_.name = name; }

  // Returns the given parameters that the team has not asked for so far.
  match::TeamParameters unknown_parameters() const;

  // Returns the shapes of the tick that the team answered last; null if shapes are not kept.
  const plugins::ThoughtsPage* thoughts();

  // Returns the team's budget without late_ticks and bad_commands, which the match counts.
  record::BudgetReport budget_report() const;

  // Returns the team's network statistics; nothing unless the team plays over the network.
  std::optional<record::NetworkReport> network_report() const;

  // Returns the process of the team; null if the team has no process of its own.
  const plugins::ProcessController* process() const { return process_; }

  // Returns the output of the team, each line with its tick; "" if the team has no process of its
  // own.
  std::string output() {
    return process_ != nullptr ? process_->output(plugins::Ticks::shown) : std::string();
  }

 private:
  explicit TeamSeat(record::TeamInfo info) : info_(std::move(info)) {}

  record::TeamInfo info_;
  std::unique_ptr<match::Controller> owned_;
  match::Controller* controller_ = nullptr;
  plugins::ProcessController* process_ = nullptr;
  plugins::TrustedController* trusted_ = nullptr;
  dds::Seat* network_ = nullptr;
  firasim::Seat* firasim_ = nullptr;
  firasim::Server* firasim_server_ = nullptr;
  const match::Leg* firasim_leg_ = nullptr;
  std::optional<match::Fault> load_fault_;
};

// Keeps this process and its children on the current core. A match and its teams take turns: the
// change from one process to the next takes 1 us on the same core, and 50 us between cores.
void stay_on_this_core();

// Waits until both teams can play, blue first. If a team can never play, the match becomes void or
// forfeited. Returns early after an interrupt, if `interrupt` is not null.
void wait_until_ready(std::span<TeamSeat> seats, match::Leg& match, system::Interrupt* interrupt);

}  // namespace mirocup::server
