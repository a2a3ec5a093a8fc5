#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Legs in real time in which both teams play on hosts of their own, over a network that loses packets. Each of the three
# processes loses a share P of what it sends. Usage: loss.sh BUILD P...; prints a line for each P and fails if a leg does not
# come to its end, or if fewer commands are in step than 0.9 (1 - P)^2 of the ticks. Exit 77: this system allows no hosts.
#
# Hosts are network namespaces: the server has 10.77.1.1 and routes; the teams are 10.77.1.2 and 10.77.2.2.
set -euo pipefail
build=$(realpath "$1")
shift

if [[ ${MIROCUP_IN_NAMESPACE:-} != yes ]]; then
  as_user=()
  [[ $(id -u) -eq 0 ]] || as_user=(--map-root-user)
  if ! command -v ip >/dev/null || ! unshare "${as_user[@]}" --net --mount true 2>/dev/null; then
    echo "skipped: network namespaces (unshare, ip) cannot be had here"
    exit 77
  fi
  MIROCUP_IN_NAMESPACE=yes exec unshare "${as_user[@]}" --net --mount "$0" "$build" "$@"
fi

mkdir -p /run/netns
mount -t tmpfs none /run/netns
ip link set lo up
for i in 1 2; do
  ip netns add team$i
  ip link add veth$i type veth peer name eth0 netns team$i
  ip address add 10.77.$i.1/24 dev veth$i
  ip link set veth$i up
  ip -n team$i link set lo up
  ip -n team$i address add 10.77.$i.2/24 dev eth0
  ip -n team$i link set eth0 up
  ip -n team$i route add default via 10.77.$i.1
done

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
bad=0
for loss in "$@"; do
  lossy=(env LD_PRELOAD="$build/bad_network.so" ASAN_OPTIONS=verify_asan_link_order=0 BAD_NETWORK_LOSS="$loss")
  record=$folder/$loss.json
  team() { # NUMBER COLOUR
    ip netns exec team"$1" "${lossy[@]}" "$build/mirocup" join --match loss --server 10.77.1.1 --team "$2" --name "$2" \
      --patience 20 "$build/house/striker.so" >"$folder/$2.out" 2>&1
  }
  team 1 blue &
  team 2 yellow &
  begin=$(date +%s%N)
  "${lossy[@]}" "$build/mirocup" match --blue dds:blue --yellow dds:yellow --match loss --interface 10.77.1.1 \
    --speed 1 --half "${HALF:-2}" --join-within 20 --record "$record" >"$folder/match.out" 2>&1 || bad=1
  end=$(date +%s%N)
  wait
  python3 - "$loss" "$record" "$(((end - begin) / 1000000))" <<'PYTHON' || bad=1
import json, sys
loss, record, ms = float(sys.argv[1]), json.load(open(sys.argv[2])), int(sys.argv[3])
ticks, network = record["ticks"], record["network"]
shares = {team: network[team]["in_step"] / ticks for team in network}
bar = 0.9 * (1.0 - loss) ** 2
print(f"loss {loss:.2f}: {record['result']['end']}, {ticks} ticks, in step blue {shares['blue']:.3f} "
      f"yellow {shares['yellow']:.3f} (bar {bar:.3f}), absences {sum(len(n['absences']) for n in network.values())}, "
      f"begin to end {ms / 1000:.2f} s, of which play {ticks * record['control_period']:.2f} s")
sys.exit(record["result"]["end"] != "full_time" or min(shares.values()) < bar)
PYTHON
done
[[ $bad -eq 0 ]] || cat "$folder"/*.out
exit $bad
