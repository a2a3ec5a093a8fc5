// SPDX-License-Identifier: MIT
//
// Who steers a team: a library in its own process, the same in this one, or somebody on the
// network.
#pragma once

#include "plugins/host/process_controller.hpp"
#include "plugins/host/trusted_controller.hpp"
#include "server/app/interrupt.hpp"
#include "server/dds/match_server.hpp"
#include "server/record/match_record.hpp"

#include <memory>
#include <span>
#include <string>

namespace mirocup::app {

// What the command line says of a team: "dds:NAME", the path of a library, or a house team's name.
struct TeamChoice {
  record::TeamInfo info;
  std::string library;                        // for a DDS team ""
  std::string network_name;                   // of a DDS team: what it calls itself
  std::optional<plugins::SealedEntry> entry;  // what the library was when it was chosen
  std::optional<match::Fault> fault;          // of a library that cannot be one
};

Result<TeamChoice> choose_team(const std::string& text);

// How teams in processes of their own are treated; the bell is for one match.
struct ProcessTerms {
  plugins::Isolation isolation = plugins::Isolation::T2;
  plugins::Budget budget;
  std::optional<plugins::Deadline> deadline;
  std::shared_ptr<plugins::Doorbell> bell = std::make_shared<plugins::Doorbell>();
};

// One team's place in a match.
class TeamSeat {
 public:
  // Starts what has to be started. An error is the host's; a team's own fault comes out of
  // wait_until_ready().
  static Result<TeamSeat> take_in_process(const TeamChoice& choice, const match::Briefing& briefing,
                                          const ProcessTerms& terms);
  static Result<TeamSeat> take_trusted(const TeamChoice& choice, const match::Briefing& briefing);
  static Result<TeamSeat> take_on_network(const TeamChoice& choice, const match::Briefing& briefing,
                                          dds::MatchServer& server, const dds::JoinTerms& patience);

  // Returns when the team can play, or why it never will: a fault of its own, or the host's.
  tl::expected<void, match::Answer> wait_until_ready();

  match::Controller& controller() { return *controller_; }
  const record::TeamInfo& info() const { return info_; }
  record::BudgetReport budget_report() const;
  // What happened between the server and the team, if it plays over the network.
  std::optional<record::NetworkReport> network_report() const;
  // The process that the team plays in, or null.
  const plugins::ProcessController* process() const { return process_; }
  std::string output() { return process_ != nullptr ? process_->output() : std::string(); }

 private:
  explicit TeamSeat(record::TeamInfo info) : info_(std::move(info)) {}

  record::TeamInfo info_;
  std::unique_ptr<match::Controller> owned_;
  match::Controller* controller_ = nullptr;
  plugins::ProcessController* process_ = nullptr;
  dds::Seat* network_ = nullptr;
  std::optional<match::Fault> load_fault_;
};

// Keeps this process, and those that it starts, on one core. A match and its teams take turns: there
// handing over costs a microsecond, across cores fifty.
void stay_on_this_core();

// Until both teams, blue first, can play; a match whose teams cannot is void or forfeited. Returns
// early if it is interrupted.
void wait_until_ready(std::span<TeamSeat> seats, match::Leg& match, Interrupt& interrupt);

}  // namespace mirocup::app
