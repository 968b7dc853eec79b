// node simulate.mjs JOB.json: simulates the records of one blind test case with MuJoCo. Beside JOB.json lies JOB.references
// (64-bit floats: position, then velocity of each record's reference); JOB.columns is written in the same way.
import { readFileSync, writeFileSync } from "node:fs";
import loadMujoco from "@mujoco/mujoco";
import { Mechanism } from "./mechanism.mjs";
import { runLoop } from "./loop.mjs";

const file = process.argv[2];
// JSON has no infinity: what is not limited is null.
const job = JSON.parse(readFileSync(file, "utf8"), (key, value) => (value === null ? Infinity : value));
const raw = readFileSync(file.replace(/\.json$/, ".references"));
const references = new Float64Array(raw.buffer.slice(raw.byteOffset, raw.byteOffset + raw.byteLength));
const mujoco = await loadMujoco();
const parts = [];
let offset = 0;
for (const { machine, samples, seed } of job.records) {
  const position = references.subarray(offset, offset + samples);
  const velocity = references.subarray(offset + samples, offset + 2 * samples);
  offset += 2 * samples;
  const substeps = Math.ceil(machine.controller.period / job.longest_step - 1e-9);
  const start = (position[0] - machine.sensors.offset) / machine.sensors.scale;
  const mechanism = new Mechanism(mujoco, machine, machine.controller.period / substeps, start);
  const columns = runLoop(mechanism, machine, position, velocity, substeps, seed);
  mechanism.close();
  for (const column of Object.values(columns)) parts.push(Buffer.from(column.buffer));
}
writeFileSync(file.replace(/\.json$/, ".columns"), Buffer.concat(parts));
