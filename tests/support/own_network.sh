# SPDX-License-Identifier: MIT
#
# shellcheck shell=bash
# Computers with a network of their own, which are namespaces. To be sourced by a script of bash:
#   own_network "$@"    first: the script starts itself again in a network namespace, and gets a folder, $work. At the end the folder and
#                       what still runs are gone. Exit 77, with a sentence, if this system has no nft or allows no namespaces.
#   start_computer      then: starts a computer without a cable, and puts the process that keeps it into $computer
#   at PROCESS COMMAND...  runs a command on a computer

own_network() {
  PATH=$PATH:/usr/sbin
  if [ -z "${IN_NAMESPACE:-}" ]; then
    command -v nft >/dev/null && command -v ip >/dev/null || { echo "skipped: needs nftables and iproute2"; exit 77; }
    unshare --map-root-user --net nft list ruleset 2>/dev/null || { echo "skipped: needs a network namespace"; exit 77; }
    IN_NAMESPACE=1 exec unshare --map-root-user --net "$0" "$@"
  fi
  work=$(mktemp -d)
  # shellcheck disable=SC2046  # several processes
  trap 'kill $(jobs -p) 2>/dev/null; rm -rf "$work"' EXIT
}

start_computer() {
  unshare --net sleep 600 &
  computer=$!
  until [ "$(readlink /proc/$computer/ns/net)" != "$(readlink /proc/self/ns/net)" ]; do sleep 0.05; done
}

at() { nsenter --net="/proc/$1/ns/net" "${@:2}"; }
