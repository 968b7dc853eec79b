// node check_arms.mjs STICKSLIP: inertia and gravity of five public arms, imported from MJCF and from URDF, against MuJoCo.
import loadMujoco from "@mujoco/mujoco";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { arms } from "./public_arms.mjs";

const mujoco = await loadMujoco();
const program = process.argv[2];
const room = mkdtempSync(join(tmpdir(), "arms-"));
process.on("exit", () => rmSync(room, { recursive: true }));
const poses = 3;
let worst = 0, failed = 0, checks = 0;

function near(what, found, wanted, scale) {
  ++checks;
  const error = Math.abs(found - wanted) / scale;
  worst = Math.max(worst, error);
  if (error <= 1e-9) return;
  ++failed;
  console.error(`${what}: MuJoCo has ${found}, import has ${wanted}`);
}

for (const arm of arms)
  for (const form of ["mjcf", "urdf"]) {
    const model = mujoco.MjModel.from_xml_string(arm[form]), data = new mujoco.MjData(model);
    if (model.nv !== arm.joints) throw new Error(`${arm.name} as ${form}: MuJoCo sees ${model.nv} joints`);
    const file = join(room, `${arm.name}.${form === "mjcf" ? "xml" : "urdf"}`), at = join(room, "pose.toml");
    writeFileSync(file, arm[form]);
    for (let pose = 0; pose < poses; ++pose) {
      const q = Array.from({ length: model.nv }, (_, i) => pose * Math.sin(1 + 2.3 * i + pose));
      q.forEach((v, i) => (data.qpos[i] = v));
      writeFileSync(at, q.map((v, i) => `joint${i + 1} = ${v === 0 ? "0.0" : v}\n`).join(""));
      mujoco.mj_forward(model, data);
      const bias = Array.from(data.qfrc_bias), most = Math.max(...bias.map(Math.abs));
      for (let i = 0; i < model.nv; ++i) {
        const unit = Array(model.nv).fill(0), column = new mujoco.DoubleBuffer(model.nv);
        unit[i] = 1;
        mujoco.mj_mulM(model, data, column, unit);
        const inertia = column.GetView()[i];
        column.delete();
        const answer = JSON.parse(execFileSync(program, ["import", file, "--joint", `joint${i + 1}`, "--at", at, "--json"], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }));
        near(`${arm.name} (${form}), joint ${i + 1}: inertia`, inertia, answer.inertia + (answer.armature ?? 0), inertia);
        near(`${arm.name} (${form}), joint ${i + 1}: gravity`, -bias[i], answer.gravity.effort, most);
      }
    }
    data.delete(), model.delete();
  }
console.log(`${arms.map(a => a.name).join(", ")}: ${checks} numbers, ${failed} wrong, farthest ${worst.toExponential(1)}`);
process.exit(failed > 0 || checks < 300 ? 1 : 0);
