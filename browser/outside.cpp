// SPDX-License-Identifier: MIT
//
// A team outside of the module: its calls go to the program that runs the module, with pointers
// into the module's memory (browser/workbench/teams.js).
#include "browser/game.hpp"

#define MIROCUP_OUTSIDE(name) __attribute__((import_module("outside"), import_name(#name)))

extern "C" {
MIROCUP_OUTSIDE(create) void* mirocup_outside_create(const mirocup_setup* setup);
MIROCUP_OUTSIDE(decide)
void mirocup_outside_decide(void* team, const mirocup_observation* now, mirocup_command* command);
MIROCUP_OUTSIDE(destroy) void mirocup_outside_destroy(void* team);
MIROCUP_OUTSIDE(place)
void mirocup_outside_place(void* team, const mirocup_observation* now, mirocup_placement* places);
}

namespace mirocup::browser {

const mirocup_strategy* outside_team(bool has_place) {
  static constexpr mirocup_strategy team{
      MIROCUP_ABI_VERSION,    sizeof(mirocup_strategy), "mine",
      mirocup_outside_create, mirocup_outside_decide,   mirocup_outside_destroy,
      mirocup_outside_place};
  static constexpr mirocup_strategy without_place{
      MIROCUP_ABI_VERSION,    sizeof(mirocup_strategy), "mine", mirocup_outside_create,
      mirocup_outside_decide, mirocup_outside_destroy,  nullptr};
  return has_place ? &team : &without_place;
}

}  // namespace mirocup::browser
