#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Plays leagues on a real Slurm: a controller and two nodes on this machine, started by this script as the calling user and ended by it.
# Usage: slurm.sh BUILD. Needs cmake/packages-slurm.txt; exit 77 without. No privilege is needed: any user will do.
#
# The pages must be byte-equal to those of a local run: without faults, when a node dies with its legs (SIGKILL), when the
# controller is down, when the league is stopped and started again, and when nodes or their daemons alone die
# at random moments, MIROCUP_KILLS times (4). Catches a leg that is lost or booked twice, an endless wait for a lost task,
# a stop that cuts off a leg.
set -euo pipefail
build=$(realpath "$1")
for program in munged slurmctld slurmd sbatch; do
  command -v $program >/dev/null || PATH=$PATH:/usr/sbin
  command -v $program >/dev/null || { echo "skipped: there is no $program"; exit 77; }
done

base=$(mktemp -d)
me=$(id -un)
port=$((20000 + RANDOM % 10000))
kills=${MIROCUP_KILLS:-4}
mkdir -p "$base"/{state,munge,n1,n2}
chmod 711 "$base" "$base/munge"
head -c 128 /dev/urandom >"$base/munge/key"
chmod 600 "$base/munge/key"
cat >"$base/slurm.conf" <<END
ClusterName=mirocup
SlurmctldHost=localhost
SlurmUser=$me
SlurmdUser=$me
SlurmctldPort=$port
AuthType=auth/munge
AuthInfo=socket=$base/munge/socket
StateSaveLocation=$base/state
SlurmctldPidFile=$base/slurmctld.pid
SlurmctldLogFile=$base/slurmctld.log
SlurmdSpoolDir=$base/%n
SlurmdPidFile=$base/%n.pid
SlurmdLogFile=$base/%n.log
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=10
KillWait=5
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1
PartitionName=league Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$base/slurm.conf

# end NAME: kills the process whose id is in NAME.pid.
end() {
  [[ ! -s $base/$1.pid ]] || kill -9 "$(cat "$base/$1.pid")" 2>/dev/null || true
}
finish() {
  scancel --me 2>/dev/null || true
  for name in n1 n2 slurmctld munged; do end $name; done
  rm -rf "$base"
}
trap finish EXIT
trap 'exit 1' INT TERM

# eventually WORDS...: waits until the command succeeds.
eventually() {
  for _ in $(seq 600); do
    "$@" && return
    sleep 0.1
  done
  echo "never came true: $*" >&2
  tail -n 20 "$base"/*.log >&2
  exit 1
}

# start_node NAME: starts the node's daemon and waits until it can be killed.
start_node() {
  rm -f "$base/$1.pid"
  slurmd -N "$1"
  eventually test -s "$base/$1.pid"
}

munged --force --key-file="$base/munge/key" --socket="$base/munge/socket" --pid-file="$base/munged.pid" \
  --log-file="$base/munged.log" --seed-file="$base/munge/seed" 2>/dev/null
slurmctld
start_node n1
start_node n2
both_idle() { [[ $(sinfo --noheader --Node --format=%t 2>/dev/null | sort -u) == idle ]]; }
eventually both_idle

# make NAME: makes a league of twelve legs in $base/NAME/l.
make() {
  mkdir "$base/$1"
  "$build/mirocup" league init "$base/$1/l" --half 20 --seed 3 --team a=house:chaser --team b=house:keeper \
    --team c=house:striker --team d=house:idle >/dev/null
}
play() { "$build/mirocup" league start "$base/$1/l" --engine slurm >>"$base/$1.out" 2>&1; }
begin() {
  make "$1"
  play "$1" &
  league=$!
  eventually has_begun "$1"
}
has_begun() { [[ -n $(find "$base/$1/l/records" -name '*.json') ]]; }
no_controller() { ! kill -0 "$(cat "$base/slurmctld.pid" 2>/dev/null)" 2>/dev/null; }
booked() { grep -c "\"kind\":\"$2\"" "$base/$1/l/journal.jsonl" || true; }

# check NAME: checks that twelve legs are booked, each once, and that the pages are those of the local run.
check() {
  local twice
  twice=$(grep '"kind":"leg"' "$base/$1/l/journal.jsonl" | grep -o '"fixture":"[^"]*","leg":[0-9]*' | sort | uniq -d)
  if [[ $(booked "$1" leg) != 12 || -n $twice ]] || ! diff -r "$base/here/l/site" "$base/$1/l/site" >&2; then
    echo "$1: $(booked "$1" leg) legs are booked, twice: ${twice:-none}" >&2
    cat "$base/$1.out" >&2
    exit 1
  fi
  echo "$1: the same pages, $(booked "$1" void) attempts void, after $SECONDS s"
}

# kill_node NAME: kills the daemon and all its processes at once.
kill_node() {
  local id parent victims=() keepers=()
  end "$1"
  for id in $(grep -lsazF "SLURMD_NODENAME=$1" /proc/[0-9]*/environ | grep -o '[0-9]*'); do
    grep -qsazF "SLURM_CONF=$SLURM_CONF" "/proc/$id/environ" || continue
    parent=$(awk '/^PPid:/ { print $2 }' "/proc/$id/status" 2>/dev/null) || continue
    [[ $(cat "/proc/$parent/comm" 2>/dev/null) != slurmstepd ]] || keepers+=("$parent")
    victims+=("$id")
  done
  kill -9 "${keepers[@]}" "${victims[@]}" 2>/dev/null || true
}

make here
"$build/mirocup" league start "$base/here/l" >/dev/null 2>&1

make quiet
play quiet
check quiet

begin node_dies
kill_node n1
start_node n1
wait $league
check node_dies

begin controller_away
kill "$(cat "$base/slurmctld.pid")"
eventually no_controller
slurmctld
wait $league
check controller_away

begin stopped
"$build/mirocup" league stop "$base/stopped/l" >/dev/null
status=0
wait $league || status=$?
[[ $status == 130 && $(booked stopped leg) == "$(find "$base/stopped/l/records" -name '*.json' | wc -l)" ]] || {
  echo "stopped: exit $status, $(booked stopped leg) legs are booked" >&2
  cat "$base/stopped.out" >&2
  exit 1
}
[[ $(booked stopped void) == 0 ]] || { echo "stopped: a leg was cut off" >&2; cat "$base/stopped.out" >&2; exit 1; }
echo "stopped: after $(booked stopped leg) legs"
play stopped
check stopped

# Every second time the whole node dies; otherwise only its daemon does, while its task plays on.
killed=(0 0)
for ((plays = 0; killed[0] + killed[1] < kills; ++plays)); do
  begin "killed$plays"
  while ((killed[0] + killed[1] < kills)); do
    sleep "$((RANDOM % 5)).$((RANDOM % 10))"
    kill -0 $league 2>/dev/null || break
    node=n$((1 + RANDOM % 2))
    what=$(((killed[0] + killed[1]) % 2))
    if ((what)); then end $node; else kill_node $node; fi
    start_node $node
    killed[what]=$((killed[what] + 1))
  done
  wait $league
  check "killed$plays"
done
echo "killed at random moments: ${killed[0]} nodes, ${killed[1]} daemons alone, in $plays plays of a league, by $me"
