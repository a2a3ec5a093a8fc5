#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Legs in real time in which both teams play on hosts of their own, over wires that lose packets. Usage: loss.sh BUILD P...;
# prints a line for each P and fails if a leg does not come to its end, or if fewer answers are in step than the bar of that P:
# 0.97 at a tenth, 0.93 at a fifth, otherwise 0.9 (1 - P)^2 of the ticks. Exit 77: this system allows no hosts.
#   HALF=S         length of a half (2 s); bars are for legs of a minute, and shorter ones get 0.04 less
#   DELAY=MS       each packet takes so long, one way (0); JITTER=MS: more or less (0). With a delay only the end counts.
#   CREDENTIALS=1  the leg is played in secure mode
#   LEAGUE=large   the league (small)
#
# Hosts are network namespaces, wires are pairs of TUN devices with an MTU of 1500 (tests/support/lossy_wire.c): what is lost is
# an IP packet or a fragment of one, in either direction. The server is 10.77.1.1 and routes; the teams are 10.77.1.2 and
# 10.77.2.2.
set -euo pipefail
build=$(realpath "$1")
shift

if [[ ${MIROCUP_IN_NAMESPACE:-} != yes ]]; then
  as_user=()
  [[ $(id -u) -eq 0 ]] || as_user=(--map-root-user)
  if ! command -v ip >/dev/null || [[ ! -w /dev/net/tun ]] || ! unshare "${as_user[@]}" --net --mount true 2>/dev/null; then
    echo "skipped: network namespaces (unshare, ip) or TUN devices cannot be had here"
    exit 77
  fi
  MIROCUP_IN_NAMESPACE=yes exec unshare "${as_user[@]}" --net --mount "$0" "$build" "$@"
fi

mkdir -p /run/netns
mount -t tmpfs none /run/netns
ip link set lo up
folder=$(mktemp -d)
wires=()
cut_wires() {
  [[ ${#wires[@]} -eq 0 ]] || kill "${wires[@]}"
  wires=()
}
trap 'cut_wires; rm -rf "$folder"' EXIT
for i in 1 2; do
  ip netns add team$i
  ip -n team$i link set lo up
done

lay_wires() { # LOSS
  for i in 1 2; do
    rm -f "$folder/ready$i"
    "$build/lossy_wire" /run/netns/team$i "$1" "${DELAY:-0}" "${JITTER:-0}" wire$i >"$folder/ready$i" &
    wires+=($!)
    until grep -qs ready "$folder/ready$i"; do
      kill -0 $! 2>/dev/null || { echo "skipped: TUN devices cannot be had here"; exit 77; }
      sleep 0.02
    done
    ip address add 10.77.$i.1/24 dev wire$i
    ip link set wire$i mtu 1500 up
    ip -n team$i address add 10.77.$i.2/24 dev eth0
    ip -n team$i link set eth0 mtu 1500 up
    ip -n team$i route add default via 10.77.$i.1
  done
}

own=() of_blue=() of_yellow=()
if [[ -n ${CREDENTIALS:-} ]]; then
  "$build/mirocup" league credentials "$folder" --team blue --team yellow >/dev/null
  own=(--credentials "$folder/credentials/server")
  of_blue=(--credentials "$folder/credentials/teams/blue")
  of_yellow=(--credentials "$folder/credentials/teams/yellow")
fi

bad=0
for loss in "$@"; do
  lay_wires "$loss"
  record=$folder/$loss.json
  rm -f "$record"
  team() { # NUMBER COLOUR OPTION...
    ip netns exec team"$1" "$build/mirocup" join --match loss --server 10.77.1.1 --team "$2" --name "$2" \
      --patience 20 "$build/house/striker.so" "${@:3}" >"$folder/$2.out" 2>&1
  }
  team 1 blue "${of_blue[@]}" &
  blue=$!
  team 2 yellow "${of_yellow[@]}" &
  yellow=$!
  begin=$(date +%s%N)
  "$build/mirocup" match --blue dds:blue --yellow dds:yellow --match loss --interface 10.77.1.1 --league "${LEAGUE:-small}" \
    --speed 1 --half "${HALF:-2}" --join-within 20 --record "$record" "${own[@]}" >"$folder/match.out" 2>&1 || bad=1
  end=$(date +%s%N)
  wait "$blue" "$yellow" || true
  cut_wires
  wait
  python3 - "$loss" "$record" "$(((end - begin) / 1000000))" "${HALF:-2}" "${DELAY:-0}" <<'PYTHON' || bad=1
import json, sys
loss, record, ms, half, delay = float(sys.argv[1]), json.load(open(sys.argv[2])), int(sys.argv[3]), float(sys.argv[4]), float(sys.argv[5])
ticks, network = record["ticks"], record["network"]
shares = {team: network[team]["in_step"] / ticks for team in network}
bar = {0.1: 0.97, 0.2: 0.93}.get(loss, 0.9 * (1.0 - loss) ** 2) - (0.04 if half < 30 else 0.0)
if delay > 0: bar = 0.0
print(f"loss {loss:.2f}: {record['result']['end']}, {ticks} ticks, in step blue {shares['blue']:.3f} "
      f"yellow {shares['yellow']:.3f} (bar {bar:.3f}), absences {sum(len(n['absences']) for n in network.values())}, "
      f"begin to end {ms / 1000:.2f} s, of which play {ticks * record['control_period']:.2f} s")
sys.exit(record["result"]["end"] != "full_time" or min(shares.values()) < bar)
PYTHON
done
[[ $bad -eq 0 ]] || cat "$folder"/*.out
exit $bad
