// SPDX-License-Identifier: MIT
//
// The engine of rSim, which rSoccer's VSS environment steps: ODE, set up as rSim sets it up, with
// the same bodies, joints, surfaces, solver and steps. The numbers are those of its sources
// (robocin/rSim). What it plays is not compared, only its cost.
#pragma once

#include <memory>

namespace mirocup::bench {

class RsimEngine {
 public:
  RsimEngine();
  ~RsimEngine();

  // False if this program was built without ODE.
  static bool is_built_in();

  // Plays one step of the environment, 25 ms in five steps of the engine, with random wheel speeds.
  void step();

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace mirocup::bench
