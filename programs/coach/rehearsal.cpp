// SPDX-License-Identifier: MIT
#include "programs/coach/rehearsal.hpp"

#include "core/replay/recorded.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirocup::coach {

namespace {

constexpr double recorded_s = 0.3;  // that a team which is not at hand drives as recorded

// Sets the draws of futures apart from the other uses of a leg's seed.
constexpr std::uint64_t domain = 0x636f616368000000ULL;

Result<server::TeamSeat> seat(const server::TeamChoice& choice, const match::Leg& leg, Team team) {
  MIROCUP_TRY(auto seat, server::TeamSeat::take_trusted(choice, leg.briefing(team)));
  const auto ready = seat.wait_until_ready();
  if (ready) return seat;
  const auto* fault = std::get_if<match::Fault>(&ready.error());
  return fail(Errc::input,
              choice.library + ": " + (fault != nullptr ? fault->text : "it cannot be started"));
}

match::Answer ask(server::TeamSeat& seat, const match::Observation& observation) {
  seat.controller().post(observation);
  return seat.controller().collect();
}

}  // namespace

std::uint32_t ticks_of(double seconds, const match::Leg& leg) {
  return static_cast<std::uint32_t>(std::ceil(seconds / leg.setup().control_period - 1e-9));
}

Rehearsal::Rehearsal(const record::MatchRecord& record, Team team)
    : recording_(record.recording),
      team_(team),
      leg_(record.recording.setup, match::TickLogs::dropped) {}

Result<std::unique_ptr<Rehearsal>> Rehearsal::begin(const record::MatchRecord& record,
                                                    const Cast& cast) {
  std::unique_ptr<Rehearsal> all(new Rehearsal(record, cast.team));
  for (const Team team : both_teams) {
    const int i = index_of(team);
    if (cast.own[i]) {
      MIROCUP_TRY(all->own_[i], seat(*cast.own[i], all->leg_, team));
    }
    MIROCUP_TRY(all->stand_in_[i], seat(cast.stand_in, all->leg_, team));
  }
  MIROCUP_TRY(all->substitute_, seat(cast.substitute, all->leg_, cast.team));
  if (cast.keeper) {
    MIROCUP_TRY(all->keeper_, seat(*cast.keeper, all->leg_, cast.team));
  }
  return all;
}

void Rehearsal::follow(std::uint32_t tick) {
  const int robots = leg_.field().robots_per_team;
  const double limit = leg_.setup().parameters.wheel_speed_limit;
  const auto end = std::min<std::size_t>(tick, recording_.ticks.size());
  while (leg_.tick() < end && !leg_.is_over()) {
    const match::Snapshot now = leg_.view();
    for (const Team team : both_teams) {
      const int i = index_of(team);
      if (!decides(team)) continue;
      const match::Answer answer = ask(*own_[i], observe(now, team, robots));
      const auto* command = std::get_if<match::Command>(&answer);
      if (command == nullptr ||
          check(*command, robots, limit).command != recording_.ticks[leg_.tick()].commands[i])
        own_[i].reset();
    }
    advance(replay::recorded_answers(recording_, leg_.tick()));
  }
}

void Rehearsal::go_before(std::uint32_t goal) {
  std::uint32_t tick = goal - std::min(goal, ticks_of(studied_s, leg_));
  for (const match::LoggedDecision& d : recording_.decisions) {
    if (d.tick < goal && d.decision.restart != referee::Restart::none)
      tick = std::max(tick, d.tick + 1);
  }
  follow(tick);
  while (leg_.state() != match::State::PLAY && leg_.tick() < goal) follow(leg_.tick() + 1);
}

bool Rehearsal::is_without_goal(std::uint32_t goal, std::optional<int> robot, int number) {
  const auto recorded = static_cast<std::uint32_t>(recorded_s / leg_.setup().control_period + 0.5);
  const std::uint32_t recorded_end = std::min(leg_.tick() + recorded, goal);
  const std::uint32_t end =
      std::max(leg_.tick() + ticks_of(studied_s, leg_), goal + ticks_of(after_goal_s, leg_));
  const std::size_t before = leg_.decisions().size();
  const int in_goal = std::max(leg_.snapshot().counts[index_of(team_)].keeper, 0);
  leg_.redraw(mix_seed(mix_seed(mix_seed(leg_.setup().seed ^ domain) + goal) +
                       static_cast<std::uint64_t>(number)));
  while (leg_.state() == match::State::PLAY && leg_.tick() < end) {
    const bool is_recorded = leg_.tick() < recorded_end;
    match::ByTeam<match::Answer> answers;
    if (is_recorded) answers = replay::recorded_answers(recording_, leg_.tick());
    for (const Team team : both_teams) {
      const int i = index_of(team);
      const match::Observation seen = observe(leg_.view(), team, leg_.field().robots_per_team);
      if (decides(team) || !is_recorded) answers[i] = ask(own_[i] ? *own_[i] : *stand_in_[i], seen);
      if (robot && team == team_) substitute(*robot, in_goal, seen, answers[i]);
      if (!std::holds_alternative<match::Command>(answers[i])) return false;
    }
    advance(answers);
  }
  const auto& decisions = leg_.decisions();
  return std::none_of(
      decisions.begin() + static_cast<std::ptrdiff_t>(before), decisions.end(),
      [&](const match::LoggedDecision& d) {
        return (d.decision.verdict == referee::Verdict::GOAL && d.team != team_) ||
               (d.decision.restart == referee::Restart::PENALTY_KICK && d.taker != team_);
      });
}

void Rehearsal::substitute(int robot, int in_goal, match::Observation seen, match::Answer& answer) {
  const auto number = [&](int n) { return !keeper_ || (n != in_goal && n != 0) ? n : in_goal - n; };
  std::swap(seen.own[0], seen.own[number(0)]);
  seen.own_counts.keeper = number(seen.own_counts.keeper);
  const match::Answer other = ask(keeper_ && robot == in_goal ? *keeper_ : *substitute_, seen);
  auto* own = std::get_if<match::Command>(&answer);
  const auto* command = std::get_if<match::Command>(&other);
  if (own != nullptr && command != nullptr)
    own->wheels[robot] = command->wheels[number(robot)];
  else
    answer = match::Fault{};
}

void Rehearsal::show_in(web::ColumnEncoder& film) {
  film_ = &film;
  film.add(web::frame_of(leg_.snapshot(), leg_.field().robots_per_team, film.last()));
}

void Rehearsal::advance(const match::ByTeam<match::Answer>& answers) {
  leg_.advance(answers);
  if (film_ != nullptr) show_in(*film_);
}

}  // namespace mirocup::coach
