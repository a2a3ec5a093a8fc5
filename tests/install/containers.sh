#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Builds the images of the Containerfile with podman and tries them: `play` shows the table of the example league; in `mirocup` a team is
# made, compiled and plays in T2; `host` takes a team's sources, compiles them, plays a night and is healthy.
# Usage: tests/install/containers.sh [--mirror URL] [--base IMAGE]
#   --base IMAGE  an image of Debian 12; otherwise mmdebstrap makes one
# Needs root, podman, curl and a mirror of Debian. Exit 3 if podman or an image of Debian cannot be had, 1 if something failed.
#
# Catches an image that lacks a file or a package, a sandbox that is weaker in it without need, and a host that loses its league with its
# container.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
mirror=
base=
while [[ $# -gt 0 ]]; do
  case $1 in
    --mirror) mirror=$2; shift 2 ;;
    --base) base=$2; shift 2 ;;
    *) echo "usage: $0 [--mirror URL] [--base IMAGE]" >&2; exit 2 ;;
  esac
done
command -v podman >/dev/null || { echo "podman is missing" >&2; exit 3; }

folder=$(mktemp -d)
clean_up() {
  podman rm --force --time 2 mirocup-try-play mirocup-try-host >/dev/null 2>&1 || true
  podman volume rm --force mirocup-try >/dev/null 2>&1 || true
  rm -rf --one-file-system "$folder"
}
trap clean_up EXIT
step() { echo "== $*"; }
failed() { echo "$*" >&2; exit 1; }

# wait_for TEXT COMMAND...: until the command prints the text, at most ten minutes.
wait_for() {
  local text=$1
  shift
  for _ in $(seq 300); do
    if "$@" 2>/dev/null | grep -q "$text"; then return 0; fi
    sleep 2
  done
  failed "\"$text\" never came: $*"
}

if [[ -z $base ]]; then
  step "a Debian 12"
  command -v mmdebstrap >/dev/null || { echo "mmdebstrap is missing: give --base" >&2; exit 3; }
  mmdebstrap --quiet --variant=minbase bookworm "$folder/debian.tar" ${mirror:+"deb $mirror bookworm main"} || exit 3
  base=localhost/mirocup-debian:12
  podman import --quiet "$folder/debian.tar" "$base" >/dev/null || exit 3
fi

git clone -q "$root" "$folder/mirocup"
for target in play mirocup host; do
  step "image $target"
  podman build --network=host --quiet --build-arg DEBIAN="$base" --target "$target" --tag "mirocup-try-$target" "$folder/mirocup" >/dev/null
done
podman images --format '{{.Repository}} {{.Size}}' | grep mirocup-try

step "play"
podman run --detach --name mirocup-try-play --publish 127.0.0.1:18080:8080 mirocup-try-play >/dev/null
wait_for "tactician" curl -s http://127.0.0.1:18080/

step "mirocup"
mkdir "$folder/team"
inside() { podman run --rm --volume "$folder/team:/work" mirocup-try-mirocup "$@"; }
inside mirocup new mine >/dev/null
inside sh -c 'cd mine && cmake --workflow --preset team' >"$folder/build.log" 2>&1 || failed "$(tail -20 "$folder/build.log")"
inside mirocup match --blue mine/build/team.so --yellow chaser --half 10 --json | grep -q '"isolation":"T2"' || failed "not T2"

step "host"
podman volume create mirocup-try >/dev/null
start_host() {
  podman run --detach --name mirocup-try-host --publish 127.0.0.1:18081:8080 --volume mirocup-try:/league mirocup-try-host >/dev/null
  wait_for "html" curl -s http://127.0.0.1:18081/
}
league() { podman exec mirocup-try-host mirocup league "$@"; }
start_host
printf 'team\nalpha\nbeta\n' | podman exec --interactive mirocup-try-host sh -c 'cat > /tmp/class.csv'
league team /league --csv /tmp/class.csv
for team in alpha beta; do
  token=$(league token /league "$team" 2>/dev/null | tail -1)
  portal() { curl -s --fail -H "Authorization: Bearer $token" "http://127.0.0.1:18081/api/v1/entries$1" "${@:2}"; }
  answer=$(portal "?name=team.cpp" --upload-file "$folder/team/mine/team.cpp") || failed "an entry was not taken"
  wait_for '"state":"accepted"' portal "/$(grep -o '"entry":[0-9]*' <<<"${answer// /}" | cut -d: -f2)"
done
league nightly /league
league health /league
podman rm --force --time 2 mirocup-try-host >/dev/null
start_host
wait_for "alpha" curl -s http://127.0.0.1:18081/
echo "all three images work"
