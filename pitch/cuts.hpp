// SPDX-License-Identifier: MIT
//
// Chooses the windows of a recording that are simulated, and where they begin.
//
// A window begins where pictures tell all that its motion depends on: nothing touches, and wheels
// hold. A robot that has just slid or been hit has a sideways speed that a camera hardly sees, and
// that would pass for a lag of its motors. Pictures before the window decide whether wheels hold.
// Their noise is independent of the noise in the window, so the choice does not bias the numbers.
#pragma once

#include "pitch/windows.hpp"

#include <vector>

namespace mirocup::pitch {

// Returns windows of the ball alone, of up to two seconds: long windows show best how it slows
// down.
std::vector<Window> rolls(const Footage& footage, const simulator::Parameters& parameters);

// Returns windows of one robot alone whose commands are known, of up to half a second.
std::vector<Window> drives(const Footage& footage, const simulator::Parameters& parameters);

// Returns windows of two or three bodies that touch each other soon after the start, of up to half
// a second.
std::vector<Window> meetings(const Footage& footage, const simulator::Parameters& parameters);

}  // namespace mirocup::pitch
