// SPDX-License-Identifier: MIT
#include "labs/training/episode.hpp"

#include "core/replay/recording.hpp"
#include "system/digest.hpp"

#include <algorithm>

namespace mirocup::training {

void Episode::add_tick(const match::Leg& leg) {
  const auto robots = static_cast<std::size_t>(leg.field().robots_per_team);
  for (const match::DrivenCommand& command : leg.answers()) {
    for (std::size_t i = 0; i < robots; ++i) {
      wheels.insert(wheels.end(), command.wheels[i].begin(), command.wheels[i].end());
    }
  }
  const auto& asked = leg.placement_requests();
  if (asked.size() > requests.size()) {
    requests.insert(requests.end(), asked.begin() + static_cast<std::ptrdiff_t>(requests.size()),
                    asked.end());
  }
}

match::ByTeam<match::Answer> Episode::answers(std::uint32_t tick, int robots) const {
  match::ByTeam<match::Answer> answers;
  auto at = std::lower_bound(requests.begin(), requests.end(), tick,
                             [](const match::LoggedPlacementRequest& request, std::uint32_t t) {
                               return request.tick < t;
                             });
  const std::int16_t* wheel = wheels.data() + 4 * static_cast<std::size_t>(robots) * tick;
  for (const Team team : both_teams) {
    match::DrivenCommand driven;
    for (int i = 0; i < robots; ++i) {
      driven.wheels[static_cast<std::size_t>(i)] = {wheel[0], wheel[1]};
      wheel += 2;
    }
    auto& command = answers[index_of(team)].emplace<match::Command>();
    for (int i = 0; i < robots; ++i) command.wheels[static_cast<std::size_t>(i)] = driven.speeds(i);
  }
  for (; at != requests.end() && at->tick == tick; ++at) {
    std::get<match::Command>(answers[index_of(at->team)]).placement = at->request;
  }
  return answers;
}

namespace {

record::TeamInfo team_info(const Side& side, system::Files& files) {
  record::TeamInfo info;
  info.kind = record::TeamKind::plugin;
  info.name = side.learns() ? "agent" : side.mates;
  if (side.learns() || side.library.empty()) return info;
  const auto bytes = files.read_named(side.library, system::size_limit::entry);
  if (bytes) info.sha256 = system::sha256(*bytes);
  info.parameters = side.parameters;
  if (side.mates.find('/') == std::string::npos && side.mates.find(".so") == std::string::npos) {
    info.kind = record::TeamKind::house;
  }
  return info;
}

}  // namespace

Result<void> save_record(const Config& config, const Episode& episode, const std::string& path) {
  MIROCUP_TRY(const auto setup, setup_of(config, episode.seed));
  if (const std::string problem = match::problem_with(setup.parameters); !problem.empty()) {
    return fail(
        Errc::input,
        "no record can be made, because no robot fits the \"pitch\" of this episode: " + problem);
  }
  match::Leg leg(setup);
  const int robots = leg.field().robots_per_team;
  const std::uint32_t ticks = episode.ticks(robots);
  replay::StateTrace trace;
  while (!leg.is_over() && leg.tick() < ticks) {
    leg.advance(episode.answers(leg.tick(), robots));
    trace.add(leg);
  }
  if (!leg.is_over() && !episode.faults.empty()) leg.forfeit(episode.faults);
  if (!leg.is_over()) {
    leg.declare_void("an episode of training, cut after " + std::to_string(ticks) + " ticks");
  }
  system::Disk disk;
  record::MatchRecord record;
  record.software = record::this_software();
  record.isolation = "none";
  for (const Team team : both_teams) {
    record.teams[index_of(team)] = team_info(config.sides[index_of(team)], disk);
    record.budget[index_of(team)].bad_commands = leg.bad_values()[index_of(team)];
  }
  record.recording = replay::record(leg, std::move(trace));
  return record::save(disk, path, record);
}

}  // namespace mirocup::training
