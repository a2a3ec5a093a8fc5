// SPDX-License-Identifier: MIT
//
// The build compiles this, and the page links it to a team, which is a WebAssembly module of its
// own. teams.js copies the structures of strategy.h into and out of the module's memory, and
// answers its calls.
#include "mirocup/strategy.h"

#include <cstddef>
#include <cstring>

#define EXPORT(name) __attribute__((export_name(#name)))
#define IMPORT(name) __attribute__((import_module("mirocup"), import_name(#name)))

extern "C" {
IMPORT(log) void mirocup_seat_log(const char* text);
IMPORT(parameter) double mirocup_seat_parameter(const char* name, double fallback);
// `kind`: 0 line, 1 circle, 2 polygon, 3 text.
IMPORT(draw)
void mirocup_seat_draw(int kind, const char* layer, uint32_t colour, const double* numbers,
                       int count, const char* text);
}

namespace {

mirocup_setup setup;
mirocup_observation now;
mirocup_command command;
mirocup_placement placement;
void* team;

bool has_place() {
  const mirocup_strategy* strategy = mirocup_entry();
  return strategy->size > offsetof(mirocup_strategy, place) && strategy->place != nullptr;
}

}  // namespace

extern "C" {
// Where the structures are: 0 the setup, 1 the observation, 2 the command, 3 the placement.
EXPORT(at) void* mirocup_seat_at(int what) {
  void* const places[]{&setup, &now, &command, &placement};
  return places[what];
}

// 1 if the team takes part in this version of strategy.h, and 2 more if it has place().
EXPORT(version) int mirocup_seat_version() {
  return mirocup_entry()->abi_version == MIROCUP_ABI_VERSION ? 1 + 2 * has_place() : 0;
}

// Begins a leg with the copied setup; 0 if the team refuses to play.
EXPORT(create) int mirocup_seat_create() {
  setup.host = nullptr;
  setup.log = [](void*, const char* text) { mirocup_seat_log(text); };
  setup.parameter = [](void*, const char* name, double fallback) {
    return mirocup_seat_parameter(name, fallback);
  };
  setup.draw_line = [](void*, const char* layer, uint32_t colour, double x1, double y1, double x2,
                       double y2) {
    const double numbers[]{x1, y1, x2, y2};
    mirocup_seat_draw(0, layer, colour, numbers, 4, "");
  };
  setup.draw_circle = [](void*, const char* layer, uint32_t colour, double x, double y,
                         double radius) {
    const double numbers[]{x, y, radius};
    mirocup_seat_draw(1, layer, colour, numbers, 3, "");
  };
  setup.draw_polygon = [](void*, const char* layer, uint32_t colour, const double* points,
                          int32_t corners) {
    mirocup_seat_draw(2, layer, colour, points, 2 * corners, "");
  };
  setup.draw_text = [](void*, const char* layer, uint32_t colour, double x, double y,
                       const char* text) {
    const double numbers[]{x, y};
    mirocup_seat_draw(3, layer, colour, numbers, 2, text);
  };
  team = mirocup_entry()->create(&setup);
  return team != nullptr;
}
EXPORT(decide) void mirocup_seat_decide() {
  std::memset(&command, 0, sizeof command);
  mirocup_entry()->decide(team, &now, &command);
}
EXPORT(place) void mirocup_seat_place() {
  mirocup_entry()->place(team, &now, &placement);
}
}
