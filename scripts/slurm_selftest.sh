#!/usr/bin/env bash
# Runs a sweep as a real Slurm array on one loopback node, merges it, and compares it with the same
# sweep in one piece.
#
#   scripts/slurm_selftest.sh [KINESTAT]
#
# Starts its own controller and node in a temporary folder, on free ports, and ends them; an existing
# cluster is not touched. Needs slurmctld, slurmd and munged (Debian: slurmctld, slurmd, munge) and
# root, because slurmd does; if one is missing, it says so and ends with status 77, which ctest counts
# as skipped.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
program=$(realpath "${1:-$root/build/release/app/kinestat}")
skip() { echo "slurm_selftest: skipped: $1"; exit 77; }
for tool in slurmctld slurmd sbatch squeue scontrol munged; do
  command -v "$tool" > /dev/null || skip "$tool is not installed"
done
[ "$(id -u)" = 0 ] || skip "slurmd needs root"

work=$(mktemp -d /tmp/kinestat-slurm.XXXXXX)
pids=()
end() {
  for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done
  wait 2> /dev/null || true
  rm -rf "$work"
}
trap end EXIT

# Authentication between the two daemons: a munged of its own, with a key of its own.
mkdir -p "$work"/{munge,state,spool,log,shards,whole,merged}
chmod 755 "$work"
chmod 700 "$work/munge"
dd if=/dev/urandom of="$work/munge/key" bs=128 count=1 status=none
chmod 600 "$work/munge/key"
munged --foreground --force --socket="$work/munge.socket" --key-file="$work/munge/key" \
  --pid-file="$work/munge/pid" --log-file="$work/munge/log" --seed-file="$work/munge/seed" \
  > "$work/log/munged" 2>&1 &
pids+=($!)

free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}
node=$(hostname -s)
cat > "$work/slurm.conf" <<CONF
ClusterName=selftest
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
ReturnToService=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$node Default=YES State=UP
CONF
export SLURM_CONF=$work/slurm.conf
slurmctld -D > "$work/log/slurmctld" 2>&1 &
pids+=($!)
slurmd -D -N "$node" > "$work/log/slurmd" 2>&1 &
pids+=($!)

up=no
for _ in $(seq 60); do
  if [ "$(sinfo --noheader --format=%T 2> /dev/null)" = idle ]; then up=yes; break; fi
  sleep 0.5
done
if [ "$up" = no ]; then
  tail -n 5 "$work"/log/* >&2 || true
  skip "no node comes up here; the last lines of the logs are above"
fi

# The array: every task is one shard. --resume lets a task that was requeued go on where it was.
cat > "$work/sweep.sh" <<JOB
#!/bin/bash
#SBATCH --array=1-7
#SBATCH --ntasks=1
#SBATCH --output=$work/log/task-%a
exec "$program" sweep --jobs 1 --quiet --resume --out "$work/shards" \\
  --shard "\$SLURM_ARRAY_TASK_ID/\$SLURM_ARRAY_TASK_COUNT" \\
  "$root/mechanisms/sweeps/ravigneaux_search.yaml"
JOB
sbatch --wait "$work/sweep.sh"
cat "$work"/log/task-*
"$program" merge --quiet --out "$work/merged" "$work"/shards/*.shard
"$program" sweep --quiet --out "$work/whole" "$root/mechanisms/sweeps/ravigneaux_search.yaml"
diff -r "$work/whole" "$work/merged"
echo "slurm_selftest: 7 tasks of an array give the bytes of one run"
