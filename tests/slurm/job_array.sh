#!/bin/bash
# A campaign as a job array on a real Slurm of one node, which lives and dies in a folder of its own.
#
# usage: job_array.sh PROGRAM SBATCH-SCRIPT FOLDER
#
# Needs root: Slurm's daemons and munge run as whoever starts them, and as no one else here.
set -euo pipefail
program=$1 script=$2 folder=$3
test "$(id -u)" = 0 || { echo "Slurm's daemons are started as root here" >&2; exit 1; }
rm -rf "$folder"
mkdir -p "$folder"/{munge,state,spool,work}
chmod 0755 "$folder" "$folder"/{state,spool,work}
chmod 0700 "$folder/munge"
sockets=$(mktemp -d /tmp/rebound-slurm-XXXXXX)  # paths of sockets are short
chmod 0711 "$sockets"
host=$(hostname -s)
daemons=()
finish() {
  for pid in "${daemons[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$sockets"
}
trap finish EXIT

free_port() { python3 -c 'import socket; s=socket.socket(); s.bind(("127.0.0.1",0)); print(s.getsockname()[1])'; }
head -c 1024 /dev/urandom >"$folder/munge/key"
chmod 0400 "$folder/munge/key"
/usr/sbin/munged --foreground --force --key-file="$folder/munge/key" --socket="$sockets/munge" \
  --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" &
daemons+=($!)

cat >"$folder/slurm.conf" <<CONF
ClusterName=rebound
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$sockets/munge
CredType=cred/munge
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=sched_interval=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP MaxTime=INFINITE
CONF
export SLURM_CONF="$folder/slurm.conf"
for _ in $(seq 50); do test -S "$sockets/munge" && break; sleep 0.1; done
/usr/sbin/slurmctld -D -f "$SLURM_CONF" >"$folder/slurmctld.out" 2>&1 & daemons+=($!)
/usr/sbin/slurmd -D -f "$SLURM_CONF" -N "$host" >"$folder/slurmd.out" 2>&1 & daemons+=($!)
for _ in $(seq 60); do
  sinfo -h -o %t 2>/dev/null | grep -q '^idle$' && break
  sleep 0.5
done
sinfo -h -o %t | grep -q '^idle$' || { cat "$folder"/slurm*.log >&2; exit 1; }

cd "$folder/work"
cat >ball.toml <<'TOML'
schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
damping = "17.63e4 N.s/m^2.5"
TOML
cat >many.toml <<'TOML'
schema = 1
base = "ball.toml"
[design]
kind = "sobol"
count = 400
[[design.factor]]
key = "impact.speed"
low = "1 m/s"
high = "30 m/s"
TOML
"$program" campaign many.toml --out whole
REBOUND=$program sbatch --wait --array=1-4 "$script" many.toml parts || {
  cat campaign-*.log "$folder"/slurm*.log >&2
  exit 1
}
test "$(ls parts/shard-0000?-of-00004.sqlite | wc -l)" = 4
"$program" campaign query many.toml --out whole --csv whole.csv
"$program" campaign query many.toml --out parts --csv parts.csv
cmp whole.csv parts.csv
# Submitted again, the same array finds all and runs nothing.
REBOUND=$program sbatch --wait --array=1-4 "$script" many.toml parts
tail -qn 1 campaign-*.log | grep -c " 0 run now" | grep -qx 4
echo "400 members in 4 tasks of a job array: the same table, bit by bit"
