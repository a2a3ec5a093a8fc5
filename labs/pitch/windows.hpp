// SPDX-License-Identifier: MIT
//
// Windows: short pieces of a recording, each with a few bodies that meet no other body. The state
// of each body at the start of its window is unknown, and the simulator moves the body from this
// state. So errors of the model show within a window and do not add up over the recording.
#pragma once

#include "core/simulator/world.hpp"
#include "labs/pitch/camera_log.hpp"
#include "labs/pitch/unknowns.hpp"

#include <Eigen/Core>

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace mirocup::pitch {

// The frames `first` to `last` of a recording, and the bodies that met only each other in these
// frames. Bodies have the numbers of the recording; the ball has the number 2 * robots, and is the
// last of the list.
struct Window {
  int first = 0, last = 0;
  std::vector<int> bodies;
  // True: wheels may slide at the start, so sideways speeds are also unknown.
  bool may_slide = false;
};

// The recording in flat arrays for windows, without obvious outliers.
class Footage {
 public:
  explicit Footage(const CameraLog& recording);

  struct Sight {
    bool is_seen = false;
    Vec2 position{0.0, 0.0};
    double heading = 0.0;  // without jumps by 2 pi
  };
  // A command that holds from `t` on.
  struct Told {
    double t;
    simulator::WheelSpeeds wheels;
  };

  int bodies() const { return static_cast<int>(sights_.size()); }
  int ball() const { return bodies() - 1; }
  int frames() const { return static_cast<int>(times_.size()); }
  double time(int frame) const { return times_[frame]; }
  const Sight& sight(int body, int frame) const { return sights_[body][frame]; }
  const std::vector<Told>& told(int body) const { return told_[body]; }
  const field::Field& field() const { return field_; }
  double usual_period() const { return period_; }

  // A body's state at a frame: position and velocity of a line or a parabola through the pictures
  // near the frame.
  struct FittedState {
    simulator::BodyState state;
    double misfit = 0.0;  // m: root mean square residual of the pictures, per degree of freedom
    // Variances of a coordinate and of its velocity, and their covariance, for a noise of 1 m.
    double position = 0.0, both = 0.0, velocity = 0.0;
  };
  // Fits |count| pictures in a row. The picture at `frame` is the first of them if `count` is
  // positive, the last if `count` is negative. `degree` is 1 for a line, 2 for a parabola. Returns
  // nothing if less than half of the pictures, or fewer than degree + 2, show the body.
  std::optional<FittedState> state_at(int body, int frame, int count, int degree) const;

  // True if, between the frames `first` and `last`, a hand moves a body (faster than any robot
  // can), or the camera pauses.
  bool is_broken(int first, int last) const;

  // Returns the camera's noise of a coordinate, m, estimated robustly from third differences, in
  // which motion hardly shows; 0 if too few pictures exist.
  double position_noise() const;

 private:
  void leave_out_outliers(int body);
  void find_breaks();

  field::Field field_;
  double period_;
  std::vector<double> times_;
  std::vector<std::vector<Sight>> sights_;  // [body][frame]
  std::vector<std::vector<Told>> told_;     // [body]
  std::vector<int> breaks_;                 // breaks_[f]: number of breaks before frame f
};

// Simulates windows under one guess. The object keeps a world for each kind of window.
class Rerun {
 public:
  Rerun(const Footage& footage, const Guess& guess) : footage_(footage), guess_(guess) {}

  // Sets the bodies to `start`, and calls see(frame, index in window.bodies, state) for each body
  // in each later frame of the window. If `statistics` is given, records the impacts with times
  // since the first frame. A robot whose commands are not known keeps its first wheel speeds.
  template <class See>
  void play(const Window& window, const std::vector<simulator::BodyState>& start, See see,
            simulator::RunStatistics* statistics = nullptr) {
    simulator::World& world = world_for(window);
    world.set_statistics(statistics);
    begin(world, window, start);
    double t = footage_.time(window.first);
    for (int frame = window.first + 1; frame <= window.last; ++frame) {
      if (statistics != nullptr) statistics->origin = t - footage_.time(window.first);
      advance(world, window, t, footage_.time(frame));
      t = footage_.time(frame);
      for (std::size_t i = 0; i < window.bodies.size(); ++i) see(frame, i, state(world, window, i));
    }
  }

 private:
  simulator::World& world_for(const Window& window);
  void begin(simulator::World& world, const Window& window,
             const std::vector<simulator::BodyState>& start);
  void advance(simulator::World& world, const Window& window, double from, double to) const;
  simulator::BodyState state(const simulator::World& world, const Window& window,
                             std::size_t i) const;

  const Footage& footage_;
  Guess guess_;
  // Wheel speeds of robots with unknown commands.
  std::array<simulator::WheelSpeeds, simulator::max_robots> kept_{};
  std::map<std::pair<int, bool>, std::unique_ptr<simulator::World>> worlds_;
};

}  // namespace mirocup::pitch
