#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# A new user has an installed mirocup and nothing else: makes a team in an empty folder, builds, tests and plays it. The sources
# and the build folder are hidden where the system allows it. Usage: install.sh ROOT BUILD
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")

if [[ ${3:-} != hidden ]]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  cmake --install "$build" --prefix "$folder/first" >/dev/null
  mv "$folder/first" "$folder/prefix"  # a prefix can be moved
  cp "$0" "$folder/install.sh"
  cd "$folder"
  if unshare --mount --map-root-user true 2>/dev/null; then
    unshare --mount --map-root-user ./install.sh "$root" "$build" hidden
  else
    ./install.sh "$root" "$build" hidden
  fi
  exit
fi

folder=$PWD
if [[ $(id -u) -eq 0 && $folder != "$root"* ]]; then
  mount -t tmpfs none "$root" 2>/dev/null && echo "the sources are hidden"
fi
cd /
mirocup() { env -i PATH=/usr/bin:/bin HOME=/ "$folder/prefix/bin/mirocup" "$@"; }

mirocup new "$folder/team"
cd "$folder/team"
env -i PATH=/usr/bin:/bin HOME=/ cmake --workflow --preset team
mirocup match --blue build/team.so --yellow idle --half 40 --record leg.json
mirocup verify leg.json
if [[ -e $folder/prefix/share/mirocup/browser/mirocup.wasm ]] && command -v node >/dev/null; then
  node "$folder/prefix/share/mirocup/browser/verify.mjs" leg.json
fi
grep -q '"winner": "blue"' leg.json
# A team that predicts: the library needs nothing but its header, and the sandbox takes it.
cat >predicts.cpp <<'END'
#include "mirocup/predict.hpp"
using namespace mirocup::strategy;
class Predicts : public Team {
 public:
  explicit Predicts(const Setup& setup) : Team(setup), simulator_(setup) {}
  void decide(const Observation& now, Command& command) override {
    Scene scene = scene_of(now);
    for (int tick = 0; tick < 5; ++tick) simulator_.advance(scene, command, command);
    Observation soon = now;
    show(scene, soon);
    command.wheels[1] = kick_to(setup(), soon, soon.own[1], {setup().half_length, 0.0});
  }
 private:
  Simulator simulator_;
};
MIROCUP_EXPORT_TEAM(Predicts, "predicts")
END
cat >>CMakeLists.txt <<'END'
add_library(predicts MODULE predicts.cpp)
target_link_libraries(predicts PRIVATE mirocup::predict)
set_target_properties(predicts PROPERTIES PREFIX "")
END
env -i PATH=/usr/bin:/bin HOME=/ cmake --workflow --preset team
mirocup check build/predicts.so

# A team in C, and one in Python, where Python was built in.
mirocup new "$folder/in C" --language c
(cd "$folder/in C" && env -i PATH=/usr/bin:/bin HOME=/ sh -ec \
  'cmake --preset team && cmake --build --preset team && build/team_test')
mirocup match --blue "$folder/in C/build/team.so" --yellow idle --half 5
if [[ -e $folder/prefix/libexec/mirocup/mirocup-python-host ]]; then
  mirocup new "$folder/in Python" --language python
  mirocup match --blue "$folder/in Python/team.py" --yellow idle --half 5
  # The interpreter keeps memory until its process ends, which is no leak.
  env -i PATH=/usr/bin:/bin HOME=/ ASAN_OPTIONS=detect_leaks=0 \
    "$folder/prefix/bin/mirocup" match --blue "$folder/in Python/team.py" --yellow idle --half 5 --trusted
fi

mirocup new "$folder/team" && exit 1  # does not write over a team
[[ $? -eq 2 ]]
mirocup league init league --team mine=build/team.so --team house=house:chaser --half 2
mirocup league start league
