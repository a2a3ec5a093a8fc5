#!/bin/bash
# SPDX-License-Identifier: MIT
#
# Two computers, which are namespaces: a match server behind the rules of --print-firewall, and a team beside a flood from another
# address. Catches rules that nft does not load, rules that let the flood pass, and rules that cut the team off.
# Usage: firewall.sh BUILD; exit 77 if this system has no nft or allows no namespaces.
set -euo pipefail
. "$(dirname "$0")/../support/own_network.sh"
own_network "$@"
mirocup=$1/mirocup
match=("$mirocup" match --blue dds:ours --yellow "$1/house/keeper.so" --interface server --speed 1 --half 4 --record "$work/leg.json")

"${match[@]}" --print-firewall >"$work/rules"
nft -f "$work/rules"
nft 'add table inet behind; add chain inet behind input { type filter hook input priority 10; }
     add rule inet behind input ip saddr 10.9.0.66 counter'

# The other computer has the team's address, and one from which it floods the server's second address.
start_computer
on_far() { at "$computer" "$@"; }
ip link add server type veth peer name home netns "$computer"
ip link set server up
ip address add 10.9.0.1/24 dev server
ip address add 10.9.1.1/32 dev server
on_far ip link set home up
on_far ip address add 10.9.0.2/24 dev home
on_far ip address add 10.9.0.66/24 dev home
on_far ip route add 10.9.1.1 dev home src 10.9.0.66

"${match[@]}" >"$work/match.txt" 2>&1 &
leg=$!
on_far "$mirocup" join --match 1 --team blue --name ours --server 10.9.0.1 "$1/house/striker.so" >"$work/join.txt" 2>&1 &
for _ in {1..600}; do grep -q "plays blue" "$work/join.txt" && break; sleep 0.1; done
on_far bash -c 'for i in {1..3000}; do echo flood; done >/dev/udp/10.9.1.1/7410'
wait $leg
passed=$(nft list chain inet behind input | sed -n 's/.*counter packets \([0-9]*\).*/\1/p')
cat "$work/match.txt"
python3 - "$work/leg.json" "$passed" <<'END'
import json, sys
record, passed = json.load(open(sys.argv[1])), int(sys.argv[2])
network = record["network"]["blue"]
print(f"{passed} of 3000 packets pass; {network['in_step']} of {record['ticks']} ticks in step, processes {network['processes']}")
# A burst of 400 and 200 a second; a busy machine takes longer to send them.
sys.exit(0 if 400 <= passed <= 1500 and record["result"]["end"] == "full_time" and 2 * network["in_step"] > record["ticks"] else 1)
END
