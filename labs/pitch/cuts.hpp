// SPDX-License-Identifier: MIT
//
// Chooses the windows of a recording to simulate, and the start of each window.
//
// A window begins at a frame whose motion is known from pictures alone: no bodies touch, and wheels
// hold. A robot that has just slid or was hit has a sideways speed that a camera hardly sees, and
// that the fit would take for a lag of the motors. Pictures before the window decide whether wheels
// hold. The noise of those pictures is independent of the noise in the window, so the choice does
// not bias the numbers of the pitch.
#pragma once

#include "labs/pitch/windows.hpp"

#include <vector>

namespace mirocup::pitch {

// Returns windows of up to two seconds with the ball alone: long windows show best how the ball
// slows down.
std::vector<Window> rolls(const Footage& footage, const simulator::Parameters& parameters);

// Returns windows of up to half a second with one robot alone, whose commands are known.
std::vector<Window> drives(const Footage& footage, const simulator::Parameters& parameters);

// Returns windows of up to half a second in which two or three bodies touch each other soon after
// the start.
std::vector<Window> meetings(const Footage& footage, const simulator::Parameters& parameters);

}  // namespace mirocup::pitch
