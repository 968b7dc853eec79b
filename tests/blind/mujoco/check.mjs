// node check.mjs: two masses on a damped spring that a constant effort pushes one way must move like one mass of their sum,
// to 1e-4: v(t) = F/c + (v(0) - F/c) exp(-c t/J). Ends with 1 and says which did not.
import loadMujoco from "@mujoco/mujoco";
import { Mechanism } from "./mechanism.mjs";

const mujoco = await loadMujoco();
const none = { amplitude: 0, rate: 1, phase: 0 };
const friction = (coulomb, viscous) => ({
  coulomb, viscous, ripple: none, load_share: 0, static_rise: 0, stribeck_velocity: 1, stribeck_exponent: 2, drift: 0,
  drift_time: 1, uneven_coulomb: 0, uneven_viscous: 0,
});
const step = 5e-5, effort = 5, coulomb = 0.5, viscous = 0.1, inertia = [0.065, 0.12];
let failed = 0;
for (const revolute of [true, false])
  for (const backlash of [0, 0.0013])
    for (const damping of [5, 17]) {
      const mechanism = new Mechanism(mujoco, {
        revolute,
        mechanism: {
          bodies: 2, inertia, gravity: 0, gravity_phase: 0, constant_load: 0, cogging: none, disturbance: none,
          outside: { kind: "none" }, stiffness: 19000, damping, backlash,
          friction: [friction(2 * coulomb, 2 * viscous), friction(coulomb, viscous)],
        },
      }, step, 0);
      const speedAfter = seconds => {
        for (let i = 0; i < Math.round(seconds / step); ++i) mechanism.advance(effort);
        return mechanism.velocity(0);
      };
      const seconds = 0.2, final = (effort - 3 * coulomb) / (3 * viscous);
      const first = speedAfter(1), last = speedAfter(seconds);  // the spring has come to rest by then
      const found = (3 * viscous * seconds) / Math.log((final - first) / (final - last));
      const ratio = found / (inertia[0] + inertia[1]);
      mechanism.close();
      if (Math.abs(ratio - 1) < 1e-4) continue;
      failed = 1;
      console.error(`two masses, ${revolute ? "revolute" : "prismatic"}, play ${backlash}, damping ${damping}: ` +
        `they move like ${ratio} of their sum`);
    }
process.exit(failed);
