// SPDX-License-Identifier: MIT
#include "pitch/as_seen.hpp"

#include "core/replay/playback.hpp"

namespace mirocup::pitch {

namespace {

Frame frame_of(const match::Leg& leg, const match::ByTeam<match::DrivenCommand>& answers,
               bool drives) {
  const match::Snapshot now = leg.snapshot();
  const int robots = leg.field().robots_per_team;
  Frame frame;
  frame.t = now.time;
  frame.ball = now.ball.position;
  for (int team = 0; team < 2; ++team) {
    for (int i = 0; i < robots; ++i) {
      const match::ObservedRobot& robot = now.robots[team][i];
      frame.robots[team].push_back(SeenPose{robot.position, robot.heading});
      frame.commands[team].push_back(drives ? answers[team].speeds(i)
                                            : simulator::WheelSpeeds{0.0, 0.0});
    }
  }
  return frame;
}

}  // namespace

Result<Recording> as_seen(const replay::Recording& leg, const std::string& path) {
  replay::Playback playback(leg);
  Recording recording;
  recording.path = path;
  recording.league = leg.setup.league;
  recording.robots = playback.leg().field().robots_per_team;
  recording.period = leg.setup.control_period;
  recording.pitch = leg.setup.pitch_name;
  do {
    // Answers take effect one tick later.
    const bool drives = playback.leg().snapshot().state == match::State::PLAY;
    recording.frames.push_back(frame_of(playback.leg(), playback.leg().answers(), drives));
  } while (!playback.leg().is_over() && playback.advance());
  if (const auto& other = playback.divergence()) {
    return fail(Errc::damaged, path + ": it cannot be played again: tick " +
                                   std::to_string(other->tick) + ": " + other->what);
  }
  return recording;
}

}  // namespace mirocup::pitch
