// node check_import.mjs STICKSLIP: gains, limits, damping, gravity and inertia of one joint under many kinds of actuators,
// options and classes, as imported, against the efforts that MuJoCo has under commands and motions of its own.
import loadMujoco from "@mujoco/mujoco";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const mujoco = await loadMujoco();
const program = process.argv[2];
const room = mkdtempSync(join(tmpdir(), "import-"));
process.on("exit", () => rmSync(room, { recursive: true }));

const classes = `<default><general forcerange="-3 3" gainprm="50"/><default class="c"><position kp="40" kv="2" ctrlrange="-1 1"/></default></default>`;
const beam = ({ head = "", joint = "", body = "", geom = "", actuators }) => `<mujoco><compiler angle="radian"/>${head}
<worldbody><body name="b" ${body}><joint name="j" axis="0 1 0" ${joint}/><geom type="box" size=".5 .05 .05" pos=".5 0 0" mass="2" ${geom}/>
<body pos="1 0 0" euler="0 .7 0"><joint name="k" axis="0 1 0" ref=".2"/><geom type="box" size=".3 .02 .02" pos=".3 0 0" mass=".4"/></body></body></worldbody>
<actuator>${actuators}</actuator></mujoco>`;
const cases = [
  { actuators: `<motor joint="j" gear="100" forcerange="-1 1"/>` },
  { actuators: `<motor joint="j" gear="150" ctrlrange="-1 1"/>` },
  { actuators: `<motor joint="j" gear="150" ctrllimited="true" ctrlrange="-1 1"/>`, head: `<compiler autolimits="false"/>` },
  { actuators: `<motor joint="j" gear="3" ctrlrange="-1 1" ctrllimited="false" forcerange="-2 2" forcelimited="false"/>` },
  { actuators: `<motor joint="j" gear="3" ctrlrange="-1 1" forcerange="-2 2"/>`, head: `<option><flag clampctrl="disable"/></option>` },
  { actuators: `<motor joint="j" gear="100"/>`, joint: `actuatorfrcrange="-7 7"` },
  { actuators: `<motor joint="j" gear="100"/>`, joint: `actuatorfrcrange="-7 7" actuatorfrclimited="false"` },
  { actuators: `<general joint="j" gear="2" gainprm="100" biasprm="0 -100 0"/>` },
  { actuators: `<motor joint="j" class="c"/>`, head: classes },
  { actuators: `<position joint="j" kp="100" gear="2" kv="3" forcerange="-3 3"/>` },
  { actuators: `<position joint="j" kp="100" forcerange="-3 3" forcelimited="false"/>` },
  { actuators: `<position joint="j" kp="100"/>`, joint: `actuatorfrcrange="-7 7"` },
  { actuators: `<velocity joint="j" kv="5"/><position joint="j" kp="100"/>` },
  { actuators: `<position joint="j" kp="100" kv="3"/><velocity joint="j" kv="5" gear="2"/><position joint="j" kp="20"/>` },
  { actuators: `<position joint="j" kp="100" dampratio="1"/>` },
  { actuators: `<position joint="j" kp="100" dampratio=".5" gear="2" armature=".02" damping=".3"/>`, joint: `armature=".1" damping=".7" ref=".3"` },
  { actuators: `<general joint="j" biastype="affine" gainprm="100" biasprm="0 -100 0.7"/>` },
  { actuators: `<general joint="j" biastype="affine" gainprm="70" biasprm="0 -70 -4"/>` },
  { actuators: `<general joint="j" biastype="affine" gainprm="70" biasprm="0 -70 -4"/><general joint="j" biastype="affine" gainprm="6" biasprm="0 0 -6"/>` },
  { actuators: `<position joint="j"/>`, head: classes },
  { actuators: `<position joint="j" class="c"/>`, head: classes },
  { actuators: `<general joint="j" class="c"/>`, head: classes },
  { actuators: `<intvelocity joint="j" kp="30" kv="2"/>` },
  { actuators: `<position joint="j" kp="100"/>`, body: `gravcomp="1"` },
  { actuators: `<position joint="j" kp="100"/>`, body: `gravcomp=".3"` },
  { actuators: `<position joint="j" kp="100"/>`, head: `<option><flag gravity="disable"/></option>` },
  { actuators: `<position joint="j" kp="100"/>`, joint: `damping="3"`, head: `<option><flag damper="disable"/></option>` },
  { actuators: `<position joint="j" kp="100"/>`, joint: `damping="3" stiffness="30" springref=".5"` },
  { actuators: `<position joint="j" kp="100"/>`, head: `<compiler inertiagrouprange="0 1"/>`, geom: `group="1"/><geom type="sphere" size=".1" pos="2 0 0" mass="5" group="3"` },
];

let failed = 0, checks = 0, worst = 0;
for (const [index, one] of cases.entries()) {
  const text = beam(one), file = join(room, "robot.xml"), toml = join(room, "joint.toml");
  writeFileSync(file, text);
  const model = mujoco.MjModel.from_xml_string(text), data = new mujoco.MjData(model), servo = !/<motor|gainprm="100" biasprm="0 -100 0"/.test(one.actuators);
  const answer = JSON.parse(execFileSync(program, ["import", file, "--joint", "j", "--json"], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }));
  const value = (table, key, standard) => {
    const found = new RegExp(`\\[${table}\\][^[]*?^${key} = ([-+.0-9e]+)`, "m").exec(answer.text);
    return found ? Number(found[1]) : standard;
  };
  const near = (what, found, wanted) => {
    ++checks;
    const error = Math.abs(found - wanted) / Math.max(1e-3, Math.abs(wanted));
    if (error <= 1e-9) return void (worst = Math.max(worst, error));
    ++failed;
    console.error(`case ${index} (${JSON.stringify(one)}): ${what}: MuJoCo has ${wanted}, import has ${found}`);
  };
  const zero = model.qpos0[0];
  const effort = (command, position, velocity) => {
    for (let i = 0; i < model.nq; ++i) data.qpos[i] = model.qpos0[i];
    data.qpos[0] = zero + position, data.qvel[0] = velocity;
    for (let i = 0; i < model.nu; ++i) data.ctrl[i] = command;
    mujoco.mj_forward(model, data);
    return data.qfrc_actuator[0];
  };
  const small = 1e-3, base = effort(0, 0, 0);
  const gain = value("actuator", "effort_gain", 1), limit = Math.min(value("control", "effort_limit", Infinity) * gain, value("actuator", "limit", Infinity));
  if (servo) {
    near("k_p", value("control", "k_p", 0), -(effort(0, small, 0) - base) / small);
    near("k_v", value("control", "k_v", 0), -(effort(0, 0, small) - base) / small);
  } else {
    near("effort_gain", gain, effort(small, 0, 0) / small);
  }
  const most = effort(1e6, 0, 0);
  // a servo's command has its target in it: only a limit of the force stops it
  if (Number.isFinite(limit) || !servo) near("greatest effort", Number.isFinite(limit) ? limit : gain * 1e6, most);
  effort(0, 0, small);
  near("gravity", answer.gravity.effort, (() => (effort(0, 0, 0), -data.qfrc_bias[0] + data.qfrc_gravcomp[0]))());
  const passive = velocity => (effort(0, 0, velocity), data.qfrc_passive[0]);
  near("damping", answer.friction.viscous, -(passive(small) - passive(0)) / small);
  effort(0, 0, 0);
  const unit = [1, 0], column = new mujoco.DoubleBuffer(model.nv);
  mujoco.mj_mulM(model, data, column, unit);
  near("inertia", answer.inertia + answer.armature, column.GetView()[0]);
  column.delete(), data.delete(), model.delete();
}
console.log(`${cases.length} kinds of actuators, options and classes: ${checks} numbers, ${failed} wrong, farthest ${worst.toExponential(1)}`);
process.exit(failed > 0 || checks < 100 ? 1 : 0);
