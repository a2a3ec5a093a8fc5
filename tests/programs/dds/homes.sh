#!/bin/bash
# SPDX-License-Identifier: MIT
#
# Two matches on one host with four teams: two behind one router, which translates addresses and lets in only replies, one in the
# server's network, and one in a VPN (WireGuard), or on the server's host if wireguard-go cannot run. Computers are namespaces.
# Catches matches that share a port, and teams behind one address that get the states or seats of each other.
# Usage: homes.sh BUILD; exit 77 if this system has no nft or allows no namespaces.
set -euo pipefail
. "$(dirname "$0")/../../support/own_network.sh"
own_network "$@"
build=$1

# on NAME COMMAND...: on the computer of this name.
declare -A keeper
on() { at "${keeper[$1]}" "${@:2}"; }
for name in router home campus vpn; do
  start_computer
  keeper[$name]=$computer
done
# cable TO NAME ADDRESS: from the switch of the server's network.
cable() {
  ip link add "to-$1" type veth peer name eth0 netns "${keeper[$1]}"
  ip link set "to-$1" up master switch
  on "$1" ip link set eth0 up
  on "$1" ip address add "$2/24" dev eth0
}
ip link set lo up
ip link add switch type bridge
ip link set switch up
ip address add 203.0.113.10/24 dev switch
cable router 203.0.113.20
cable campus 203.0.113.30
cable vpn 203.0.113.40
on router ip link add inside type veth peer name eth0 netns "${keeper[home]}"
on router ip link set inside up
on router ip address add 192.168.1.1/24 dev inside
on router sysctl -q -w net.ipv4.ip_forward=1
on router nft 'add table ip nat; add chain ip nat out { type nat hook postrouting priority srcnat; }
               add rule ip nat out oifname eth0 masquerade fully-random
               add chain ip nat in { type filter hook forward priority filter; policy drop; }
               add rule ip nat in iifname inside accept; add rule ip nat in ct state established,related accept'
on home ip link set eth0 up
on home ip address add 192.168.1.2/24 dev eth0
on home ip route add default via 192.168.1.1

# The tunnel ends at the server's second address, and leads to the first one.
tunnel() {
  command -v wg >/dev/null && command -v wireguard-go >/dev/null || return 1
  ip address add 203.0.113.11/32 dev switch
  (umask 077 && wg genkey >"$work/server.key" && wg genkey >"$work/team.key")
  wireguard-go -f wg-server >/dev/null 2>&1 &
  (exec nsenter --net="/proc/${keeper[vpn]}/ns/net" wireguard-go -f wg-team) >/dev/null 2>&1 &
  for _ in {1..100}; do wg show wg-server >/dev/null 2>&1 && on vpn wg show wg-team >/dev/null 2>&1 && break; sleep 0.1; done
  wg set wg-server listen-port 51820 private-key "$work/server.key" peer "$(wg pubkey <"$work/team.key")" allowed-ips 10.8.0.2/32 &&
    on vpn wg set wg-team private-key "$work/team.key" peer "$(wg pubkey <"$work/server.key")" endpoint 203.0.113.11:51820 \
      allowed-ips 203.0.113.10/32 &&
    ip link set wg-server up && ip route add 10.8.0.2 dev wg-server src 203.0.113.10 &&
    on vpn ip address add 10.8.0.2/32 dev wg-team && on vpn ip link set wg-team up &&
    on vpn ip route add 203.0.113.10/32 dev wg-team src 10.8.0.2
}
fourth=(env)
tunnel && fourth=(on vpn)
echo "the fourth team is started by: ${fourth[*]}"

"$build/mirocup" league credentials "$work/league" --team one --team two --team three --team four >/dev/null
# play ID BLUE YELLOW: of the teams one to four. team ID COLOUR NAME LIBRARY: the command of a team.
play() {
  "$build/mirocup" match --nat --interface switch --credentials "$work/league/credentials/server" --match "$1" --seed 4 --half 8 \
    --blue "dds:$2" --yellow "dds:$3" --record "$work/$1.json"
}
team() {
  "${@:5}" "$build/mirocup" join --match "$1" --team "$2" --name "$3" --server 203.0.113.10 \
    --credentials "$work/league/credentials/teams/$3" "$build/house/$4.so"
}
play first one two & first=$!
play second three four & second=$!
team first blue one striker on home &
team second blue three chaser on home &
team first yellow two keeper on campus &
team second yellow four striker "${fourth[@]}" &
wait $first
wait $second
[ "${fourth[0]}" = env ] || on vpn wg show wg-team transfer
"$build/mirocup" match --seed 4 --half 8 --blue striker --yellow keeper --record "$work/first-alone.json" >/dev/null
"$build/mirocup" match --seed 4 --half 8 --blue chaser --yellow striker --record "$work/second-alone.json" >/dev/null
python3 - "$work" <<'END'
import json, sys
for name in "first", "second":
    record, alone = (json.load(open(f"{sys.argv[1]}/{name}{part}.json")) for part in ("", "-alone"))
    print(name, record["result"]["end"], {c: record["network"][c]["in_step"] for c in ("blue", "yellow")}, "of", record["ticks"], "in step")
    assert record["state_hash"] == alone["state_hash"], name
END
