// SPDX-License-Identifier: MIT
#include "server/seats.hpp"

#include "plugins/host/elf.hpp"
#include "plugins/host/file_advice.hpp"
#include "plugins/host/host_program.hpp"
#include "system/digest.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/process_set.hpp"
#include "system/text.hpp"

#include <filesystem>
#include <sched.h>

namespace mirocup::server {

namespace {

// dlopen() searches for a name without a slash in the system's folders.
std::string with_slash(const std::string& path) {
  return path.find('/') == std::string::npos ? "./" + path : path;
}

match::Fault no_load(std::string why) {
  return {match::FaultCode::no_load, std::move(why)};
}

}  // namespace

Result<TeamChoice> choose_team(const std::string& text) {
  TeamChoice choice;
  for (const auto kind : {record::TeamKind::dds, record::TeamKind::firasim}) {
    const std::string prefix = std::string(to_string(kind)) + ":";
    if (!text.starts_with(prefix)) continue;
    choice.network_name = text.substr(prefix.size());
    choice.info = {choice.network_name, kind, std::nullopt};
    if (choice.network_name.empty())
      return fail(Errc::input, prefix + " needs a name, as in " + prefix + "NAME");
    if (kind == record::TeamKind::dds && choice.network_name.size() > dds::max_team_name)
      return fail(Errc::input, "\"" + text + "\": the name of a team on the network has at most " +
                                   std::to_string(dds::max_team_name) + " bytes");
    return choice;
  }
  choice.library = system::house_team(text);
  if (!choice.library.empty()) {
    choice.info = {text, record::TeamKind::house, std::nullopt};
  } else if (std::error_code none;
             std::filesystem::exists(std::filesystem::symlink_status(text, none))) {
    choice.library = with_slash(text);
    choice.info = {std::filesystem::path(text).stem().string(), record::TeamKind::plugin,
                   std::nullopt};
  } else {
    return fail(Errc::input, "\"" + text + "\" is neither a file nor a house team: " +
                                 system::joined(system::house_teams(), ", "));
  }
  auto entry = plugins::SealedEntry::open(choice.library);
  if (entry) {
    choice.info.sha256 = system::sha256(entry->bytes());
    if (!entry->is_python()) {
      const auto library = plugins::read_shared_library(entry->bytes());
      if (!library) {
        const std::string known = plugins::advice_on_file(entry->bytes());
        // A library that turns out to be none loses the leg; a source or an archive is a mistake
        // of the command.
        if (!known.empty() && !choice.library.ends_with(".so"))
          return fail(Errc::input, text + ": " + known);
        choice.fault = no_load(choice.library + ": " + (known.empty() ? library.error() : known));
      }
    }
    choice.entry = std::move(*entry);
  } else if (entry.error().code == Errc::input) {
    choice.fault = no_load(entry.error().what);
  } else {
    return tl::unexpected(entry.error());
  }
  return choice;
}

Result<TeamSeat> TeamSeat::take_in_process(const TeamChoice& choice,
                                           const match::Briefing& briefing,
                                           const plugins::ProcessTerms& terms) {
  TeamSeat seat(choice.info);
  seat.load_fault_ = choice.fault;
  if (choice.fault) return seat;
  MIROCUP_TRY(const auto program, plugins::host_program(*choice.entry));
  MIROCUP_TRY(auto process, plugins::ProcessController::start(program, *choice.entry, briefing,
                                                              choice.info.parameters, terms));
  seat.process_ = process.get();
  seat.controller_ = process.get();
  seat.owned_ = std::move(process);
  return seat;
}

Result<TeamSeat> TeamSeat::take_trusted(const TeamChoice& choice, const match::Briefing& briefing,
                                        bool keeps_thoughts) {
  TeamSeat seat(choice.info);
  seat.load_fault_ = choice.fault;
  if (choice.fault) return seat;
  plugins::tell_of_crashes();
  MIROCUP_TRY(const auto module,
              choice.entry->is_python() ? plugins::python_module() : std::string());
  auto controller = plugins::TrustedController::load(
      choice.library, briefing, choice.info.parameters, keeps_thoughts, module);
  if (!controller) {
    seat.load_fault_ = controller.error();
    return seat;
  }
  seat.trusted_ = controller->get();
  seat.controller_ = controller->get();
  seat.owned_ = std::move(*controller);
  return seat;
}

Result<TeamSeat> TeamSeat::take_on_network(const TeamChoice& choice,
                                           const match::Briefing& briefing,
                                           dds::MatchServer& server,
                                           const dds::JoinTerms& patience) {
  TeamSeat seat(choice.info);
  MIROCUP_TRY(auto network, server.add_seat(briefing, choice.network_name, patience));
  seat.network_ = network;
  seat.controller_ = network;
  return seat;
}

Result<TeamSeat> TeamSeat::take_at_firasim(const TeamChoice& choice, const match::Leg& leg,
                                           Team team, firasim::Server& server,
                                           const firasim::Terms& terms) {
  TeamSeat seat(choice.info);
  seat.firasim_ = server.add_seat(leg.briefing(team), choice.network_name, terms);
  seat.firasim_server_ = &server;
  seat.firasim_leg_ = &leg;
  seat.controller_ = seat.firasim_;
  return seat;
}

tl::expected<void, match::Answer> TeamSeat::wait_until_ready() {
  if (load_fault_) return tl::unexpected<match::Answer>(*load_fault_);
  if (process_ != nullptr) return process_->wait_until_ready();
  if (network_ != nullptr) return network_->wait_until_ready();
  if (firasim_ != nullptr) return firasim_server_->wait_until_ready(*firasim_, *firasim_leg_);
  return {};
}

std::string TeamSeat::own_name() const {
  std::string name;
  if (process_ != nullptr) name = process_->team_name();
  if (trusted_ != nullptr) name = trusted_->team_name();
  return name.size() > plugins::max_own_name || system::printable(name) != name ? "" : name;
}

match::TeamParameters TeamSeat::unknown_parameters() const {
  std::uint32_t asked = 0;
  if (process_ != nullptr) asked = process_->asked_parameters();
  if (trusted_ != nullptr) asked = trusted_->asked_parameters();
  return plugins::not_asked_for(info_.parameters, asked);
}

const plugins::ThoughtsPage* TeamSeat::thoughts() {
  if (process_ != nullptr) return process_->thoughts();
  return trusted_ != nullptr ? trusted_->thoughts() : nullptr;
}

record::BudgetReport TeamSeat::budget_report() const {
  record::BudgetReport report;
  if (process_ != nullptr) {
    report.cpu_seconds = process_->cpu_seconds();
    report.slowest_tick_ms = process_->slowest_tick_ms();
    report.bank_seconds = process_->bank_seconds();
  }
  return report;
}

void stay_on_this_core() {
  system::stay_on(sched_getcpu());
}

namespace {

// What no team sent counts for each: it may have been meant for any.
record::NetworkReport report_of(const firasim::Seat& seat, const firasim::Counts& strangers) {
  const firasim::Counts& own = seat.counts();
  record::DatagramCounts datagrams = own;
  datagrams.malformed += strangers.malformed;
  datagrams.replacements += strangers.replacements;
  return {{.in_step = own.in_time,
           .late = own.held,
           .late_driven = own.held,
           .duplicate = own.repeated,
           .ahead = 0,
           .foreign = own.foreign + strangers.foreign},
          own.senders,
          seat.absences(),
          seat.answers(),
          datagrams};
}

}  // namespace

std::optional<record::NetworkReport> TeamSeat::network_report() const {
  if (firasim_ != nullptr) return report_of(*firasim_, firasim_server_->strangers());
  if (network_ == nullptr) return std::nullopt;
  return record::NetworkReport{network_->commands(), network_->processes(), network_->absences(),
                               network_->answers()};
}

void wait_until_ready(std::span<TeamSeat> seats, match::Leg& match, system::Interrupt* interrupt) {
  std::vector<match::TeamFault> faults;
  for (const Team team : both_teams) {
    const auto ready = seats[index_of(team)].wait_until_ready();
    if (interrupt != nullptr && interrupt->is_asked_for()) return;
    if (ready) continue;
    if (const auto* failure = std::get_if<match::HostFailure>(&ready.error())) {
      match.declare_void(failure->text);
      return;
    }
    faults.push_back({team, std::get<match::Fault>(ready.error())});
  }
  // Nobody wins who is not there.
  if (faults.size() == 1) {
    const Team other = opponent_of(faults[0].team);
    if (!seats[index_of(other)].is_there()) {
      faults.push_back({other,
                        {match::FaultCode::disconnected,
                         "the team had joined, but was gone before the leg began"}});
    }
  }
  if (!faults.empty()) match.forfeit(std::move(faults));
}

}  // namespace mirocup::server
