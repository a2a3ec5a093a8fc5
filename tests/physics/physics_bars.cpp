// SPDX-License-Identifier: MIT
//
// Prints every bar of the physics: scene, what was measured, the bar, ok or missed. Exit 0 if all
// are met. Usage: physics_bars [--small] [SCENE...]; the full sizes take half an hour.
#include "tests/physics/bars.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace mirocup::scenes;

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  Size size = Size::full;
  std::vector<std::string> wanted;
  for (const std::string& argument : arguments) {
    const bool known = std::any_of(kinds().begin(), kinds().end(),
                                   [&](const Kind& kind) { return argument == kind.name; });
    if (argument == "--small") {
      size = Size::small;
    } else if (known) {
      wanted.push_back(argument);
    } else {
      std::fprintf(stderr, "usage: physics_bars [--small] [SCENE...]\nscenes:");
      for (const Kind& kind : kinds()) std::fprintf(stderr, " %s", kind.name);
      std::fprintf(stderr, "\n");
      return 2;
    }
  }
  bool all_met = true;
  for (const Kind& kind : kinds()) {
    const bool skipped =
        !wanted.empty() && std::find(wanted.begin(), wanted.end(), kind.name) == wanted.end();
    if (skipped) continue;
    const std::clock_t begin = std::clock();
    for (const Bar& bar : kind.measure(size)) {
      std::printf("%-44s %-52s %10.2e  bar %8.1e  %s\n", bar.scene.c_str(), bar.measure.c_str(),
                  bar.measured, bar.limit, bar.met() ? "ok" : "missed");
      all_met = all_met && bar.met();
    }
    std::printf("# %s: %.1f s of CPU time\n", kind.name,
                static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    std::fflush(stdout);
  }
  return all_met ? 0 : 1;
}
