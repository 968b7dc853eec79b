// The mechanism of a blind test case in MuJoCo: masses, gravity, viscous and dry friction, spring and play are MuJoCo's own;
// what MuJoCo has no element for acts as a force between two of its steps.

/// Impedance close to 1 and a reference damping of 1/step: the regularised dry friction then creeps by 1e-7 of the speed
/// that its force would give the body in a second, far below an encoder's noise.
const stiffFriction = step => `solreffriction="${2 * step} 1" solimpfriction="0.9999 0.9999 0.001"`;

const wave = (s, x) => (s.amplitude === 0 ? 0 : s.amplitude * Math.sin(s.rate * x + s.phase));

function body(machine, index, step) {
  const m = machine.mechanism, inertia = m.inertia[index], link = index === m.bodies - 1;
  const joint = `frictionloss="1" damping="${m.friction[index].viscous}" ${stiffFriction(step)}`;
  if (!machine.revolute)
    return `<body><inertial pos="0 0 0" mass="${inertia}" diaginertia="1 1 1"/>
      <joint name="j${index}" type="slide" axis="1 0 0" ${joint}/></body>`;
  // A pendulum: half of the inertia is its point mass below the axis, tilted by the phase; the rest sits on the axis.
  const gravity = link ? m.gravity : 0, g = 9.81;
  const arm = gravity > 0 ? (0.5 * inertia * g) / gravity : 0, mass = gravity > 0 ? gravity / (g * arm) : 1;
  const rest = inertia - mass * arm * arm, phase = m.gravity_phase;
  return `<body><inertial pos="${arm * Math.sin(phase)} 0 ${-arm * Math.cos(phase)}" mass="${mass}"
      diaginertia="${rest} ${rest} ${rest}"/><joint name="j${index}" type="hinge" axis="0 -1 0" ${joint}/></body>`;
}

/// Euler's method takes the damping of a tendon from the last step. The implicit ones take from its matrix only what lies
/// on the pattern of the inertia matrix: two bodies side by side then move as if twice its damping times the step were
/// inertia of theirs.
function description(machine, step) {
  const m = machine.mechanism, bodies = [];
  for (let i = 0; i < m.bodies; ++i) bodies.push(body(machine, i, step));
  const play = m.backlash / 2;
  const spring = m.bodies < 2 ? "" : `<tendon><fixed name="spring" stiffness="${m.stiffness}" damping="${m.damping}"
      springlength="${-play} ${play}"><joint joint="j0" coef="1"/><joint joint="j1" coef="-1"/></fixed></tendon>`;
  return `<mujoco><compiler angle="radian"/>
    <option timestep="${step}" gravity="0 0 -9.81" integrator="Euler" iterations="50" tolerance="1e-14">
      <flag contact="disable"/></option>
    <worldbody>${bodies.join("\n")}</worldbody>${spring}</mujoco>`;
}

/// Forces of causes that the catalogue does not have; `memory` is what a hysteretic load remembers.
function outsideForce(o, q, v, memory) {
  const beyond = Math.sign(q) * Math.max(Math.abs(q) - o.where, 0) / o.width;
  switch (o.kind) {
    case "none": return 0;
    case "quadratic-drag": return -o.size * v * Math.abs(v);
    case "softening-ends": return (o.size * beyond) / (1 + beyond * beyond);
    case "hardening-ends": return -o.size * beyond;
    case "cubic-spring": return -o.size * (q / o.where) ** 3;
    case "local-obstacle": {
      const x = (q - o.where) / o.width;
      return o.size * x * Math.exp(0.5 * (1 - x * x));
    }
    case "hysteretic-load":
      memory.follower = Math.min(Math.max(memory.follower, q - o.width), q + o.width);
      return (-o.size * memory.follower) / o.where;
    default: throw new Error(`MuJoCo cases have no cause called ${o.kind}`);
  }
}

export class Mechanism {
  constructor(mujoco, machine, step, start) {
    this.mujoco = mujoco;
    this.machine = machine;
    this.step = step;
    this.model = mujoco.MjModel.from_xml_string(description(machine, step));
    this.data = new mujoco.MjData(this.model);
    this.q = this.data.qpos;
    this.v = this.data.qvel;
    this.applied = this.data.qfrc_applied;
    this.dry = this.model.dof_frictionloss;
    this.memory = { follower: start };
    this.time = 0;
    this.q.fill(start);
  }

  close() {
    this.data.delete();
    this.model.delete();
  }

  /// MuJoCo moves the position with the velocity at the end of a step; the mean of both ends is what an encoder would see.
  position(body) { return this.q[body] - 0.5 * this.step * this.v[body]; }
  velocity(body) { return this.v[body]; }

  inPlay() {
    const { backlash } = this.machine.mechanism;
    return backlash > 0 && Math.abs(this.q[0] - this.q[1]) < backlash / 2;
  }

  /// What the transmission carries; without one the effort itself.
  transmitted(effort) {
    const m = this.machine.mechanism;
    if (m.bodies < 2) return effort;
    if (this.inPlay()) return 0;
    const apart = this.q[0] - this.q[1], stretch = apart - (Math.sign(apart) * m.backlash) / 2;
    return m.stiffness * stretch + m.damping * (this.v[0] - this.v[1]);
  }

  /// One step under a constant effort on the motor.
  advance(effort) {
    const m = this.machine.mechanism, link = m.bodies - 1, q = this.q, v = this.v;
    const carried = this.transmitted(effort);
    this.applied[0] = effort;
    if (link === 1) this.applied[1] = 0;
    this.applied[link] += m.constant_load + wave(m.cogging, q[link]) + wave(m.disturbance, this.time + 0.5 * this.step) +
      outsideForce(m.outside, q[link], v[link], this.memory);
    for (let i = 0; i < m.bodies; ++i) {
      const f = m.friction[i], speed = Math.abs(v[i]);
      let level = f.coulomb + wave(f.ripple, q[i]) + f.load_share * Math.abs(carried);
      if (f.static_rise !== 0) level += f.static_rise * Math.exp(-((speed / f.stribeck_velocity) ** f.stribeck_exponent));
      if (f.drift !== 0) level += f.drift * (1 - Math.exp(-this.time / f.drift_time));
      this.dry[i] = Math.max(level, 0);
      // A Coulomb level that differs by direction is a symmetric one and a constant push.
      this.applied[i] -= f.uneven_coulomb + f.uneven_viscous * speed;
    }
    if (m.backlash > 0) this.model.tendon_damping[0] = this.inPlay() ? 0 : m.damping;
    this.mujoco.mj_step(this.model, this.data);
    this.time += this.step;
  }
}
