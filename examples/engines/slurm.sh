#!/bin/bash
#SBATCH --array=1-64 --cpus-per-task=8 --requeue
# One recording in parts, as an array job of Slurm: sbatch slurm.sh
while
  sarsim run scene.toml --out $SCRATCH/run1 --threads $SLURM_CPUS_PER_TASK \
    --part $SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT --resume
  status=$?
  [ $status -eq 75 ]  # another process, perhaps on a node that Slurm has lost, still makes this part
do sleep 30; done
exit $status
