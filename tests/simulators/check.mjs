// node check.mjs STICKSLIP: exported joints in MuJoCo itself. Numbers of the compiled model against those of the answer,
// gravity and inertia against the description, and the effort of steady sliding against coulomb + viscous V by hand.
// Then the other way round: the inertia and gravity of an imported arm against MuJoCo's mass matrix and bias, to 1e-9,
// and the loads on its joints while all of them move, to 1e-8.
import loadMujoco from "@mujoco/mujoco";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const mujoco = await loadMujoco();
const program = process.argv[2];
const room = mkdtempSync(join(tmpdir(), "simulators-"));
process.on("exit", () => rmSync(room, { recursive: true }));
const stickslip = (...words) => execFileSync(program, words, { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });

let failed = 0, checks = 0;
function near(what, found, wanted, relative) {
  ++checks;
  if (Math.abs(found - wanted) <= relative * Math.max(Math.abs(wanted), 1e-12)) return;
  ++failed;
  console.error(`${what}: MuJoCo has ${found}, wanted is ${wanted}`);
}

function load(text) {
  const model = mujoco.MjModel.from_xml_string(text), data = new mujoco.MjData(model);
  return { model, data, close: () => (data.delete(), model.delete()) };
}

/// A column of the mass matrix: what effort an acceleration of one joint takes.
function massDiagonal(model, data, i) {
  const unit = Array(model.nv).fill(0), column = new mujoco.DoubleBuffer(model.nv);
  unit[i] = 1;
  mujoco.mj_mulM(model, data, column, unit);
  const value = column.GetView()[i];
  column.delete();
  return value;
}

function exported(name, settings, words = []) {
  const file = join(room, `${name}.toml`);
  stickslip("new", "joint", ...words, "--plain", "--force", "-o", file, ...settings.flatMap(s => ["--set", s]));
  return JSON.parse(stickslip("export", file, "--to", "mjcf", "--name", "elbow", "--json"));
}

/// Pulls the servo's target along at a constant velocity until the joint follows steadily.
function slidingEffort(text, V, seconds) {
  const { model, data, close } = load(text);
  const steps = Math.round(seconds / model.opt.timestep);
  for (let k = 0; k < steps; ++k) {
    data.ctrl[0] = V * data.time;
    if (model.nu > 1) data.ctrl[1] = V;
    mujoco.mj_step(model, data);
  }
  let effort = 0;
  for (let i = 0; i < model.nu; ++i) effort += data.actuator_force[i];
  const velocity = data.qvel[model.nv - 1];
  close();
  return { effort, velocity };
}

for (const motion of ["prismatic", "revolute"]) {
  const V = motion === "prismatic" ? 0.02 : 0.5;
  const one = exported("one", [], ["--motion", motion, "--law", "coulomb-viscous"]);
  const n = one.numbers, { model, data, close } = load(one.text);
  mujoco.mj_forward(model, data);
  near(`${motion}: inertia`, massDiagonal(model, data, 0), n.link_inertia, 1e-8);
  near(`${motion}: frictionloss`, model.dof_frictionloss[0], n.friction.coulomb, 1e-8);
  near(`${motion}: damping`, model.dof_damping[0], n.friction.viscous, 1e-8);
  close();
  const slid = slidingEffort(one.text, V, 2);
  near(`${motion}: velocity`, slid.velocity, V, 1e-3);
  near(`${motion}: effort of sliding`, slid.effort, n.friction.coulomb + n.friction.viscous * V, 2e-3);
}

const geared = exported("geared", ["joint.motor_inertia=2e-5", "joint.transmission.ratio=50", "joint.transmission.stiffness=4000",
  "joint.transmission.damping=3", "joint.transmission.backlash=0.01", "friction.motor.coulomb=0.02", "friction.motor.viscous=1e-4",
  "control.k_p=0.4", "control.k_v=0.01", "load.gravity_amplitude=6", "load.gravity_phase=0.4"],
  ["--motion", "revolute", "--model", "two-mass", "--law", "coulomb-viscous"]);
{
  const n = geared.numbers, { model, data, close } = load(geared.text);
  near("geared: armature", model.dof_armature[0], 2e-5 * 2500, 1e-8);
  near("geared: backlash", model.tendon_lengthspring[1] - model.tendon_lengthspring[0], 0.01, 1e-8);
  for (const q of [-1, 0, 0.7, 2]) {
    data.qpos[1] = q;
    mujoco.mj_forward(model, data);
    near(`geared: gravity at ${q}`, -data.qfrc_bias[1], -6 * Math.sin(q + 0.4), 1e-7);
  }
  near("geared: link inertia", massDiagonal(model, data, 1), n.link_inertia, 1e-7);
  close();
}
{
  const level = exported("level", ["joint.motor_inertia=2e-5", "joint.transmission.ratio=50", "control.k_p=0.4", "control.k_v=0.01",
    "friction.motor.coulomb=0.02", "friction.motor.viscous=1e-4", "joint.transmission.stiffness=4000"],
    ["--motion", "revolute", "--model", "two-mass", "--law", "coulomb-viscous"]);
  const f = level.numbers.friction, V = 0.5, slid = slidingEffort(level.text, V, 3);
  near("geared: effort of sliding", slid.effort, f.coulomb + f.viscous * V, 5e-3);
}

// an arm of three dimensions with everything that the reader knows
const arm = `<mujoco><compiler angle="degree" eulerseq="zyx"/>
  <default><joint damping="0.1"/><default class="d"><joint armature="0.02" frictionloss="0.3"/><geom density="500"/></default></default>
  <worldbody><body name="a" pos="0.1 0 1" euler="10 20 30" childclass="d">
    <joint name="turn" axis="0 0.2 1" pos="0.02 0 0"/><geom type="capsule" fromto="0 0 0 0.1 0.2 0.3" size="0.04"/>
    <geom type="box" pos="0 0.1 0" size="0.05 0.02 0.1" quat="0.9 0.1 0.3 0.2"/>
    <body name="b" pos="0.1 0.2 0.3" axisangle="1 1 0 40"><joint name="lift" type="slide" axis="1 0 0.3" ref="0.05"/>
      <joint name="bend" axis="1 0 0" ref="15"/>
      <inertial pos="0.01 0.02 0.1" mass="1.3" fullinertia="0.02 0.03 0.025 0.001 -0.002 0.003"/>
      <frame pos="0 0 0.1" euler="0 0 35"><body name="c" pos="0 0 0.2" zaxis="0.1 0.2 1"><joint name="tip" axis="0 1 0"/>
        <geom type="ellipsoid" size="0.05 0.1 0.15" mass="0.7"/><geom type="cylinder" fromto="0 0 0 0 0.1 0.2" size="0.03"/>
        <geom type="sphere" size="0.06" pos="0 0 0.2"/></body></frame>
    </body></body></worldbody></mujoco>`;
{
  const file = join(room, "arm.xml"), pose = join(room, "pose.toml");
  writeFileSync(file, arm);
  const { model, data, close } = load(arm);
  const names = ["turn", "lift", "bend", "tip"];
  for (const q of [[0, 0.05, Math.PI / 12, 0], [0.3, -0.2, 1.1, -0.6], [-2, 0.4, -0.3, 2.5]]) {
    q.forEach((v, i) => (data.qpos[i] = v));
    writeFileSync(pose, names.map((name, i) => `${name} = ${q[i] === Math.round(q[i]) ? q[i].toFixed(1) : q[i]}\n`).join(""));
    mujoco.mj_forward(model, data);
    names.forEach((name, i) => {
      const answer = JSON.parse(stickslip("import", file, "--joint", name, "--at", pose, "--json"));
      near(`arm: inertia about ${name}`, massDiagonal(model, data, i), answer.inertia + answer.armature, 1e-9);
      near(`arm: gravity on ${name}`, -data.qfrc_bias[i], answer.gravity.effort, 1e-9);
    });
  }
  // moving: cubics in time, which a cubic through the rows reproduces; the load is what M and the bias make of the others
  const cubic = [[0.3, -0.4, 0.8, -0.5], [-0.2, 0.3, -0.6, 0.4], [1.1, 0.9, -1.2, 0.7], [-0.6, -1.3, 0.5, 0.9]];
  const at = (c, t) => [c[0] + t * (c[1] + t * (c[2] + t * c[3])), c[1] + t * (2 * c[2] + 3 * t * c[3]), 2 * c[2] + 6 * c[3] * t];
  const table = join(room, "moving.csv"), rows = 400;
  let text = "time," + names.map((name) => name + "_position").join(",") + "\n";
  for (let k = 0; k < rows; ++k) text += [k * 2e-3, ...cubic.map((c) => at(c, k * 2e-3)[0])].join(",") + "\n";
  writeFileSync(table, text);
  const [head, ...lines] = stickslip("arm-load", table, "--robot", file).trim().split("\n").map((line) => line.split(","));
  for (const k of [0, 77, 200, 399]) {
    const acceleration = cubic.map((c) => at(c, k * 2e-3)[2]);
    cubic.forEach((c, i) => ([data.qpos[i], data.qvel[i]] = at(c, k * 2e-3)));
    mujoco.mj_forward(model, data);
    names.forEach((name, i) => {
      const others = acceleration.map((a, j) => (j === i ? 0 : a)), moved = new mujoco.DoubleBuffer(model.nv);
      mujoco.mj_mulM(model, data, moved, others);
      const load = -(data.qfrc_bias[i] + moved.GetView()[i]);
      moved.delete();
      near(`moving arm: load on ${name}, row ${k}`, load, Number(lines[k][head.indexOf(name + "_load_effort")]), 1e-8);
      near(`moving arm: inertia about ${name}, row ${k}`, massDiagonal(model, data, i), Number(lines[k][head.indexOf(name + "_inertia")]), 1e-9);
    });
  }
  close();
}
console.log(`${checks} numbers, ${failed} of them wrong`);
process.exit(failed > 0 || checks < 70 ? 1 : 0);
