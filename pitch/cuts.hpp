// SPDX-License-Identifier: MIT
//
// Which windows of a recording are simulated, and where they begin.
//
// A window begins where its motion depends on what pictures tell: nothing touches, and wheels hold.
// A robot that has just slid or been hit has a sideways speed that a camera hardly sees, and which
// would pass for a lag of its motors. Whether wheels hold is judged by pictures before the window.
// Their noise is not that of the window's own, so the choice does not bend what is found.
#pragma once

#include "pitch/windows.hpp"

#include <vector>

namespace mirocup::pitch {

// Returns windows of the ball alone, of up to two seconds: its slowing down shows best in long
// windows.
std::vector<Window> rolls(const Footage& footage, const simulator::Parameters& parameters);

// Returns windows of one robot alone whose commands are known, of up to half a second.
std::vector<Window> drives(const Footage& footage, const simulator::Parameters& parameters);

// Returns windows of two or three bodies that touch each other soon after the start, of up to half
// a second.
std::vector<Window> meetings(const Footage& footage, const simulator::Parameters& parameters);

}  // namespace mirocup::pitch
