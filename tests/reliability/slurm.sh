#!/bin/bash
# The job scripts of examples/05-cluster in a real Slurm with four virtual nodes on this machine: arrays and MPI jobs whose
# workers are killed, and sweeps that change engine on the way. Every result must equal that of one process.
# Run as root: slurm.sh STICKSLIP STICKSLIP-MPI   (Debian: slurm-wlm munge openmpi-bin)
set -eu
export STICKSLIP=$(realpath "$1") STICKSLIP_MPI=$(realpath "$2")
scripts=$(realpath "$(dirname "$0")/../../examples/05-cluster")
export SPEC=$scripts/spec.toml OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
for tool in munged slurmctld slurmd sbatch; do
    command -v $tool >/dev/null || { echo "no $tool: skipped"; exit 77; }
done
stop() {
    for pid in "$work"/*.pid; do [ -f "$pid" ] && kill "$(cat "$pid")" 2>/dev/null; done
    sleep 1
    rm -rf "$work"
}
trap stop EXIT

# Nodes of one host: each needs its own port, spool and TmpFS (PMIx keeps its socket there). cred_expire is how long a
# requeued job waits; 120 s by default.
export SLURM_CONF=$work/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=virtual
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.sock,cred_expire=5
SlurmctldPort=46817
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool/%n
TmpFS=$work/tmp/%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
KillWait=5
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
NodeName=n[1-4] NodeHostname=$(hostname) NodeAddr=127.0.0.1 Port=[47001-47004] CPUs=2 RealMemory=1000
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
mkdir -p "$work"/state "$work"/{spool,tmp}/n{1,2,3,4}
chmod 711 "$work"
dd if=/dev/urandom of="$work/munge.key" bs=1024 count=1 status=none
chmod 400 "$work/munge.key"
munged --key-file="$work/munge.key" --socket="$work/munge.sock" --pid-file="$work/munged.pid" \
    --log-file="$work/munged.log" --seed-file="$work/munge.seed"
slurmctld -f "$SLURM_CONF" -c
for node in n1 n2 n3 n4; do slurmd -N $node -f "$SLURM_CONF"; done
for _ in $(seq 200); do [ "$(sinfo -h -t idle -o %D)" = 4 ] && break; sleep 0.1; done
echo "nodes idle: $(sinfo -h -t idle -o %D)"

cd "$work"
"$STICKSLIP" sweep "$SPEC" -o one --threads 1 --no-report >/dev/null
wait_for_jobs() { for _ in $(seq 400); do squeue -h | grep -q . || return 0; sleep 1; done; echo "jobs hang"; exit 1; }
same() { cmp one/results.nc "$1/results.nc" && echo "equal bytes: $2"; }
journals() { ls "$1/journal" 2>/dev/null | wc -l; }
until_journals() { for _ in $(seq 600); do [ "$(journals "$1")" -ge "$2" ] && break; sleep 0.05; done; }
a_worker() { ls "$1/journal" | tail -1 | sed 's/.*-\([0-9]*\)-[0-9]*\.journal/\1/'; }

job=$(OUT=array sbatch --parsable "$scripts/array.sbatch")
until_journals array 4
kill -9 "$(a_worker array)"
OUT=array sbatch --dependency=afterok:"$job" "$scripts/merge.sbatch" >/dev/null
wait_for_jobs
grep -h "exit code 137" stickslip-array-*.log
same array "an array of 8 tasks on 4 nodes, one killed and requeued"

job=$(OUT=mpi sbatch --parsable "$scripts/mpi.sbatch")
until_journals mpi 4
kill -9 "$(a_worker mpi)"
wait_for_jobs
grep -h "exit code" "stickslip-mpi-$job.log"
grep -h "chunks_[cr]" mpi/run.json
same mpi "4 ranks × 2 threads on 4 nodes (srun, PMIx), one rank killed and requeued"

job=$(OUT=mixed sbatch --parsable "$scripts/array.sbatch")
until_journals mixed 2
scancel "$job"
wait_for_jobs
LAUNCH="mpirun --bind-to none --mca plm_slurm_args --mpi=none" OUT=mixed sbatch "$scripts/mpi.sbatch" >/dev/null
wait_for_jobs
grep -h "chunks_[cr]" mixed/run.json
if grep -q '"chunks_computed": 0,' mixed/run.json; then echo "the cancelled array went on"; exit 1; fi
same mixed "an array cancelled half-way, then 4 ranks (mpirun inside sbatch)"
