// SPDX-License-Identifier: MIT
//
// The camera above the field: the leg as both teams and programs on the network see it.
//
// One camera sees for everybody. It measures positions and headings with noise and delay. While a
// body is lost, its last pose is held and the age of that pose counts up. Velocities are not
// measured: they are differences of the poses that were seen. Referee, pages and records use the
// true state.
#pragma once

#include "core/base/random.hpp"
#include "core/match/conditions.hpp"
#include "core/match/snapshot.hpp"

#include <array>

namespace mirocup::match {

class Camera {
 public:
  // `robots` is the number of robots of a team; `period` is the control period, s.
  Camera(const Conditions& conditions, std::uint64_t seed, int robots, double period);

  // Draws from another seed from now on.
  void redraw(std::uint64_t seed);

  // Takes the picture of a tick. To be called once a tick with the truth. `were_placed` is true if
  // bodies were put down since the last picture, so that changes since that picture are not motion.
  void look(const Snapshot& truth, bool were_placed);

  // Returns the truth of the latest look(), but with the bodies as the camera sees them.
  const Snapshot& view() const { return view_; }

 private:
  // One sighting of a body; the pose in the field's frame, m and rad.
  struct Sighting {
    Vec2 position{0.0, 0.0};
    double heading = 0.0;
    std::uint32_t tick = 0;     // in which the picture was taken
    std::uint32_t placing = 0;  // the number of placings before the picture
    bool exists = false;
  };
  struct Body {
    Random noise, loss;
    bool is_lost = false;
    Sighting last;
    Vec2 velocity{0.0, 0.0};  // m/s, from the last two sightings
    double turn = 0.0;        // rad/s
  };
  // The truth of one tick, as far as a camera sees it.
  struct Picture {
    std::uint32_t tick = 0;
    std::uint32_t placing = 0;
    Team left = Team::blue;
    simulator::BallState ball;
    ByTeam<std::array<ObservedRobot, max_robots_per_team>> robots;
  };

  bool is_seen(Body& body);
  void see(Body& body, const Picture& picture, const Vec2& position, double heading, End end);
  int age_of(const Body& body, std::uint32_t tick) const;

  Conditions conditions_;
  int robots_;
  double period_;
  std::uint32_t placings_ = 0;
  int taken_ = 0;  // number of pictures taken
  // Picture n, from 0, is at [n % (delay in ticks + 1)].
  std::array<Picture, max_delay_ticks + 1> pictures_;
  Body ball_;
  ByTeam<std::array<Body, max_robots_per_team>> bodies_;
  Snapshot view_;
};

}  // namespace mirocup::match
