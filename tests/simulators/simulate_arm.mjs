// node simulate_arm.mjs MACHINE.json FOLDER: a public arm or two links in MuJoCo, each joint in a loop of its own, as records.
// MACHINE: arm, seconds, period [s], noise and quantum [rad], seed, and per joint coulomb, viscous, load, k_p, k_v and
// motion [[amplitude, frequency]…] of sines squared. Writes arm.urdf and JOINT.csv of each.
import loadMujoco from "@mujoco/mujoco";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { arms, twoLinks } from "./public_arms.mjs";

const mujoco = await loadMujoco();
const machine = JSON.parse(readFileSync(process.argv[2], "utf8")), folder = process.argv[3];
const arm = [...arms, twoLinks].find(a => a.name === machine.arm), n = arm.joints, { period } = machine;
const step = 1e-4, steps = Math.round(period / step), settling = 3;  // s at rest before the record begins

// friction as in tests/blind/mujoco/mechanism.mjs: stiff enough that rest does not creep
let text = arm.mjcf.replace("<worldbody>", `<option timestep="${step}" integrator="Euler" iterations="50" tolerance="1e-14"/><worldbody>`);
machine.joints.forEach((j, i) => {
  text = text.replace(`<joint name="joint${i + 1}"`,
    `<joint name="joint${i + 1}" frictionloss="${j.coulomb}" damping="${j.viscous}" solreffriction="${2 * step} 1" solimpfriction="0.9999 0.9999 0.001"`);
});
const model = mujoco.MjModel.from_xml_string(text), data = new mujoco.MjData(model);

let state = BigInt(machine.seed) * 2654435761n + 12345n;
function uniform() {  // splitmix64 (Steele, Lea, Flood 2014)
  state = BigInt.asUintN(64, state + 0x9E3779B97F4A7C15n);
  let z = state;
  z = BigInt.asUintN(64, (z ^ (z >> 30n)) * 0xBF58476D1CE4E5B9n);
  z = BigInt.asUintN(64, (z ^ (z >> 27n)) * 0x94D049BB133111EBn);
  return Number((z ^ (z >> 31n)) >> 11n) / 2 ** 53;
}
const normal = () => Math.sqrt(-2 * Math.log(1 - uniform())) * Math.cos(2 * Math.PI * uniform());
const target = (j, t) => j.motion.reduce((sum, [a, w]) => sum + a * Math.sin(w * t) ** 2, 0);
const speed = (j, t) => j.motion.reduce((sum, [a, w]) => sum + a * w * Math.sin(2 * w * t), 0);

const rows = machine.joints.map(() => ["time,reference_position,reference_velocity,position,velocity,effort_command"]);
const before = Array(n).fill(null), ticks = Math.round((settling + machine.seconds) / period);
for (let k = 0; k < ticks; ++k) {
  const t = k * period - settling, recorded = t > -period / 2;
  for (let i = 0; i < n; ++i) {
    const j = machine.joints[i], moving = Math.max(t, 0);
    // MuJoCo moves the position with the velocity at the end of a step; an encoder sees the mean of both ends
    const q = data.qpos[i] - 0.5 * step * data.qvel[i];
    const read = Math.round((q + machine.noise * normal()) / machine.quantum) * machine.quantum;
    // the record's own filter begins with it
    const estimate = before[i] === null || (recorded && t < period / 2) ? 0 : (read - before[i]) / period;
    before[i] = read;
    const r = target(j, moving), dr = recorded ? speed(j, moving) : 0;
    const effort = j.k_p * (r - read) + j.k_v * (dr - estimate);
    if (recorded) rows[i].push([moving.toFixed(6), r, dr, read, estimate, effort].join(","));
    data.qfrc_applied[i] = effort + j.load;
  }
  for (let s = 0; s < steps; ++s) mujoco.mj_step(model, data);
}
mkdirSync(folder, { recursive: true });
writeFileSync(join(folder, "arm.urdf"), arm.urdf);
rows.forEach((lines, i) => writeFileSync(join(folder, `joint${i + 1}.csv`), lines.join("\n") + "\n"));
data.delete(), model.delete();
