// SPDX-License-Identifier: MIT
//
// Identification: the numbers of a pitch with which the simulator moves robots and ball as a
// recording shows them.
//
// Least squares over windows (windows.hpp). The unknowns are the numbers of the pitch, and the
// state of each body at the start of each window. Steps are those of Levenberg and Marquardt. The
// states are eliminated window by window (Schur's complement), so a step solves a small system for
// each window, and one system whose unknowns are the numbers of the pitch. The reduced equations of
// a window are its information about these numbers; the sum over all windows is the inverse of
// their covariance.
//
// The method is robust: pictures far from the simulation get less weight (Huber), and in the end
// pictures beyond five standard deviations get none. Windows that no state explains, for example
// because a hand moves a robot, are dropped and counted.
#pragma once

#include "labs/pitch/camera_log.hpp"
#include "labs/pitch/unknowns.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mirocup::pitch {

// A number with its interval of 95 %.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

struct Identified {
  Guess guess;  // numbers that are not known are those of `start`
  // An empty entry: the recordings do not determine the number.
  std::array<std::optional<Estimate>, unknown_count> known;
  // The reason for each empty entry of `known`, a sentence.
  std::array<std::string, unknown_count> why_not;
  // True: turning and driving have the same lag.
  bool has_one_lag = true;
  bool has_brake = false;  // true: the motors brake with a separate lag
  Estimate deceleration;   // of the ball at 0.5 m/s, m/s^2; only if has_deceleration
  bool has_deceleration = false;
  Estimate position_noise;  // m
  Estimate heading_noise;   // rad
  double unseen = 0.0;      // share of the bodies that a picture misses, in the mean
  double outliers = 0.0;    // share of the sights that were dropped as wrong
  int windows = 0;          // number of windows that the fit used
  int unexplained = 0;      // number of windows that no state explains
};

// Identifies a pitch from one or several recordings of it. The search begins at `start`.
// Errc::input if no window has a body that moves by known commands or a ball that rolls.
Result<Identified> identify(const std::vector<CameraLog>& recordings, const Guess& start);

}  // namespace mirocup::pitch
