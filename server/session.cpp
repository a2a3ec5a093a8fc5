// SPDX-License-Identifier: MIT
#include "server/session.hpp"

#include "core/replay/recorded.hpp"
#include "plugins/host/sandbox/probe.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace mirocup::server {

namespace {

// At full speed a match polls for an interrupt only this often, because polling is a system call.
constexpr std::uint32_t ticks_between_polls = 16;

Result<plugins::ProcessTerms> process_terms(Session& s) {
  plugins::ProcessTerms terms;
  terms.bell = s.bell;
  terms.memory = s.memory;
  terms.meanwhile = [&network = s.network] { network.stand_by(); };
  terms.keeps_thoughts = s.terms.thoughts;
  // Tests of teams that are never ready need not wait as long as a league does.
  if (const char* limit = std::getenv("MIROCUP_START_LIMIT")) {
    terms.budget.start_cpu = std::max(1, std::atoi(limit));
    terms.budget.start_wall = 3.0 * terms.budget.start_cpu;
  }
  MIROCUP_TRY(const auto strongest, plugins::strongest_isolation());
  const auto wanted = from_string<plugins::Isolation>(s.terms.isolation);
  terms.isolation = wanted.value_or(strongest);
  if (terms.isolation > strongest)
    return fail(Errc::unavailable, "--isolation " + s.terms.isolation + ": this system allows " +
                                       std::string(to_string(strongest)) +
                                       " only: " + plugins::why_no_t2());
  if (s.pacer.period() > 0.0) {
    terms.deadline.emplace();
    terms.deadline->tick = s.pacer.period();
  }
  return terms;
}

Result<TeamSeat> take_seat(Session& s, const TeamChoice& choice, Team team) {
  const int i = index_of(team);
  if (record::is_on_network(choice.info.kind))
    return s.network.take_seat(choice, team,
                               {.leg = s.leg,
                                .period = s.pacer.period(),
                                .interrupt = s.interrupt,
                                .log = s.terms.logs[i]});
  const match::Briefing briefing = s.leg.briefing(team);
  if (s.terms.trusted) {
    s.isolation = to_string(plugins::Isolation::none);
    return TeamSeat::take_trusted(choice, briefing, s.terms.thoughts);
  }
  MIROCUP_TRY(const auto terms, process_terms(s));
  s.isolation = to_string(terms.isolation);
  return TeamSeat::take_in_process(choice, briefing, terms);
}

// A library that is called team.so is told from another one by the name that it exports, unless
// both export the same, as two versions of a team do.
void use_own_names(Session& s) {
  const auto name_of = [&](Team team) {
    const TeamSeat& seat = s.seats[index_of(team)];
    const bool is_asked =
        seat.info().kind == record::TeamKind::plugin && !s.terms.keeps_name[index_of(team)];
    const std::string own = is_asked ? seat.own_name() : std::string();
    return own.empty() ? seat.info().name : own;
  };
  const std::string blue = name_of(Team::blue);
  const std::string yellow = name_of(Team::yellow);
  if (blue == yellow) return;
  s.seats[0].rename(blue);
  s.seats[1].rename(yellow);
}

match::ByTeam<std::string> names_of(const Session& s) {
  return {s.seats[0].info().name, s.seats[1].info().name};
}

// Keeps what the teams drew in their answers to a tick.
void keep_thoughts(Session& s, std::uint32_t tick) {
  for (const Team team : both_teams) {
    const plugins::ThoughtsPage* page = s.seats[index_of(team)].thoughts();
    if (page == nullptr) continue;
    record::ThoughtsWriter& writer = s.thoughts[index_of(team)];
    plugins::ThoughtReader reader(*page);
    while (const auto thought = reader.next()) writer.add(tick, *thought);
    writer.count_left_out(page->left_out);
  }
}

Result<void> interrupted() {
  return fail(Errc::interrupted, "interrupted; nothing was decided");
}

}  // namespace

Session::Session(SessionTerms its_terms, const match::Setup& setup, std::optional<double> factor)
    : terms(std::move(its_terms)),
      leg(setup),
      speed(factor.value_or(0.0)),
      pacer(clock, setup.control_period, factor),
      network(terms.network) {}

Result<void> play_past(Session& s, const record::MatchRecord& past, std::uint32_t until,
                       const std::string& path) {
  const replay::Recording& recording = past.recording;
  while (s.leg.tick() < until) {
    const std::uint32_t tick = s.leg.tick();
    s.leg.advance(replay::recorded_answers(recording, tick));
    s.trace.add(s.leg);
    if (s.leg.log().back().hash == recording.ticks[tick].hash && !s.leg.is_over()) continue;
    if (record::has_other_behaviour(past)) {
      return tl::unexpected(record::behaviour_mismatch(path, past, tick));
    }
    return fail(Errc::damaged, path + ": played again, it differs from tick " +
                                   std::to_string(tick) + " on; see mirocup verify");
  }
  s.from = record::PlayedOnFrom{.tick = until,
                                .state_hash = recording.state_hash,
                                .teams = {past.teams[0].name, past.teams[1].name}};
  return {};
}

Result<void> seat_teams(Session& s, const match::ByTeam<TeamChoice>& teams) {
  MIROCUP_TRY_VOID(s.network.open(teams));
  if (!s.network.is_open() && s.pacer.period() == 0.0) stay_on_this_core();
  for (const Team team : both_teams) {
    MIROCUP_TRY(auto seat, take_seat(s, teams[index_of(team)], team));
    s.seats.push_back(std::move(seat));
  }
  s.network.announce(s.leg, names_of(s), s.speed);
  wait_until_ready(s.seats, s.leg, &s.interrupt);
  use_own_names(s);
  return {};
}

Result<void> open_live_page(Session& s, const std::string& where) {
  MIROCUP_TRY(const auto address, web::parse_address(where.empty() ? "0" : where, "--watch"));
  const match::Setup& setup = s.leg.setup();
  MIROCUP_TRY(s.live,
              web::LiveServer::open(address, s.leg, names_of(s),
                                    std::string(to_string(setup.league)) + " league, rules " +
                                        std::string(to_string(setup.rules.preset)) + ", seed " +
                                        std::to_string(setup.seed)));
  std::cerr << "mirocup: watch at " << s.live->url() << '\n';
  return {};
}

Result<void> play(Session& s) {
  while (!s.leg.is_over()) {
    const std::uint32_t tick = s.leg.tick();
    const bool polls_now = s.pacer.period() > 0.0 || tick % ticks_between_polls == 0;
    if (polls_now && s.interrupt.is_asked_for()) return interrupted();
    s.pacer.wait_for(tick, [&s] { s.network.stand_by(); });
    s.network.publish(s.leg);
    s.leg.advance(s.seats[0].controller(), s.seats[1].controller());
    if (s.terms.thoughts) keep_thoughts(s, tick);
    s.trace.add(s.leg);
    if (s.live) s.live->publish(s.leg);
  }
  s.network.close(s.leg);
  const bool is_void = s.leg.outcome().kind == match::OutcomeKind::void_;
  return is_void && s.interrupt.is_asked_for() ? interrupted() : Result<void>();
}

record::MatchRecord record_of(const Session& s) {
  record::MatchRecord record;
  record.software = record::this_software();
  record.isolation = s.isolation;
  for (const Team team : both_teams) {
    const int i = index_of(team);
    record.teams[i] = s.seats[i].info();
    record.budget[i] = s.seats[i].budget_report();
    record.budget[i].late_ticks = s.leg.late_ticks()[i];
    record.budget[i].bad_commands = s.leg.bad_values()[i];
    record.network[i] = s.seats[i].network_report();
  }
  if (s.pacer.period() > 0.0) record.pace = {s.pacer.period(), s.pacer.lateness()};
  record.from = s.from;
  record.recording = replay::record(s.leg, s.trace);
  return record;
}

}  // namespace mirocup::server
