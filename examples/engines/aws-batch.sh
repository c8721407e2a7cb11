#!/bin/bash
# One recording in 64 parts, as an array job of AWS Batch. NOT TRIED BY US: no account was at hand.
#
# To adapt: image (any with sarsim in it), file system (EFS, with scene.toml on it), queue, processors, number of parts.
set -e
aws batch register-job-definition --cli-input-json "$(cat <<'JSON'
{
  "jobDefinitionName": "sarsim-part",
  "type": "container",
  "retryStrategy": {
    "attempts": 10,
    "evaluateOnExit": [
      {"onExitCode": "2", "action": "EXIT"},
      {"onReason": "*", "action": "RETRY"}
    ]
  },
  "containerProperties": {
    "image": "registry.example.org/sarsim:0.1.0",
    "command": ["sh", "-c",
      "exec sarsim run /data/scene.toml --out /data/run1 --part $((AWS_BATCH_JOB_ARRAY_INDEX + 1))/64 --resume --threads 8"],
    "resourceRequirements": [{"type": "VCPU", "value": "8"}, {"type": "MEMORY", "value": "4096"}],
    "mountPoints": [{"sourceVolume": "data", "containerPath": "/data"}],
    "volumes": [{"name": "data", "efsVolumeConfiguration": {"fileSystemId": "fs-00000000"}}]
  }
}
JSON
)"
aws batch submit-job --job-name run1 --job-queue spot --job-definition sarsim-part --array-properties size=64
