// SPDX-License-Identifier: MIT
//
// The pitch of a leg: the physics of its robots, its ball and its floor, and how often its robots
// are commanded. The field itself is the league's (core/field).
//
// Three presets stand for platforms that teams know. pitch_spec.cpp states the source of each of
// their numbers. Other pitches come from files (record/pitch_json.hpp), for example those
// that `mirocup identify` writes.
#pragma once

#include "core/base/names.hpp"
#include "core/match/conditions.hpp"
#include "core/simulator/model/parameters.hpp"

#include <optional>
#include <string>

namespace mirocup::match {

enum class PitchPreset {
  mirosot,    // the robots of the paper: the defaults of simulator::Parameters
  vsss,       // the cubes of FIRASim, the simulator of Very Small Size Soccer
  simurosot,  // the robots of the SimuroSot 5 v 5 program
};

struct PitchSpec {
  std::string name{"mirosot"};
  std::string source;  // a sentence: where the numbers come from
  simulator::Parameters parameters;
  std::optional<double> control_period;  // s; empty: that of the rules
  std::optional<Conditions> conditions;  // empty: those of the leg
  // s: from a command to its first effect on the pitch of a recording. A leg has a delay of its own
  // (one tick), so this is for comparisons with recordings only.
  double command_delay = 0.0;
};

PitchSpec pitch_of(PitchPreset preset);

// Returns a sentence that says why no leg can be played with these parameters, or "". The limits
// are those of robots that fit on a field: sizes, masses, lags and speeds, and an outline that lies
// within the square of robot_side, with which the referee judges.
std::string problem_with(const simulator::Parameters& parameters);

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<match::PitchPreset>{"mirosot", "vsss",
                                                                                "simurosot"};

}  // namespace mirocup
