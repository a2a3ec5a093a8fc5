// SPDX-License-Identifier: MIT
//
// A stand-in for camera and radio, so that the example runs without a pitch: robots that drive on a
// table, without laws and with hardly any physics. Each picture advances the time of the table by
// one period.
#pragma once

#include "camera_and_radio.hpp"
#include "core/field/field.hpp"
#include "core/simulator/model/parameters.hpp"

namespace pitch {

class Table final : public Camera, public Radio {
 public:
  Table(const mirocup::field::Field& field, const mirocup::simulator::Parameters& robots,
        double period);

  Picture next_picture() override;
  void send(int colour, const mirocup::match::Command& command) override;

 private:
  struct Robot {
    Place place;
    double forward = 0.0;  // m/s
    double turn = 0.0;     // rad/s
    mirocup::simulator::WheelSpeeds wheels{};
  };
  void drive(Robot& robot) const;
  void push_ball(const Robot& robot);
  void roll_ball();
  Place inside(Place place, double margin) const;

  mirocup::field::Field field_;
  mirocup::simulator::Parameters parameters_;
  double period_;
  std::array<std::array<Robot, mirocup::max_robots_per_team>, 2> robots_{};
  Place ball_;
  mirocup::Vec2 ball_speed_{0.0, 0.0};
};

}  // namespace pitch
