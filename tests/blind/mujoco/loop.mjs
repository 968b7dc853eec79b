// The sampled loop round a MuJoCo mechanism: encoder, velocity estimate, law, dead time, lag, drive.

/// Reproducible normal numbers: the sfc32 generator (C. Doty-Humphrey, PractRand) and the Box-Muller transform.
export class Noise {
  constructor(seed) {
    this.s = [seed >>> 0, Math.floor(seed / 2 ** 32) >>> 0, 0x9e3779b9, 1];
    for (let i = 0; i < 20; ++i) this.uniform();
  }
  uniform() {
    const s = this.s, t = (s[0] + s[1] + s[3]) | 0;
    s[3] = (s[3] + 1) | 0;
    s[0] = s[1] ^ (s[1] >>> 9);
    s[1] = (s[2] + (s[2] << 3)) | 0;
    s[2] = ((s[2] << 21) | (s[2] >>> 11)) + t | 0;
    return ((t >>> 0) + 0.5) / 2 ** 32;
  }
  normal() { return Math.sqrt(-2 * Math.log(this.uniform())) * Math.cos(2 * Math.PI * this.uniform()); }
}

/// Motor current and effort. The sag of the supply is solved by iteration, R i = duty (V − R_b |i|) − k_e ω.
export function motorEffort(d, signal, velocity) {
  const clip = x => Math.min(Math.max(x, -d.limit), d.limit);
  if (d.kind === "effort") {
    const full = d.gain * signal;
    return { effort: clip(full / (1 + Math.abs(full) / d.sag_effort)), current: 0, supply: 0 };
  }
  let current = 0, supply = d.supply;
  for (let i = 0; i < (d.supply_resistance > 0 ? 60 : 1); ++i) {
    const voltage = d.kind === "dc-duty" ? Math.min(Math.max(signal, -1), 1) * supply : Math.min(Math.max(signal, -supply), supply);
    current = (voltage - d.back_emf * velocity) / d.resistance;
    const next = d.supply - d.supply_resistance * Math.abs(current);
    supply += 0.5 * (next - supply);
  }
  return { effort: clip(d.gain * d.torque_constant * current), current, supply };
}

/// Commands on their way: what the drive sees at a time, or on average between two times, behind dead time and lag.
class Way {
  constructor(drive) {
    this.drive = drive;
    this.waiting = [];
    this.level = 0;
    this.lagged = 0;
    this.time = 0;
  }
  give(t, command) { this.waiting.push([t + this.drive.dead_time, command]); }
  /// Moves on to time t and returns the mean of the lagged signal on the way.
  meanUntil(t) {
    let area = 0;
    const begin = this.time;
    while (this.time < t - 1e-10) {
      while (this.waiting.length && this.waiting[0][0] <= this.time + 1e-10) this.level = this.waiting.shift()[1];
      const end = this.waiting.length ? Math.min(t, this.waiting[0][0]) : t, h = end - this.time, lag = this.drive.lag;
      if (lag > 0) {
        const keep = Math.exp(-h / lag);
        area += this.level * h + (this.lagged - this.level) * lag * (1 - keep);
        this.lagged = this.level + (this.lagged - this.level) * keep;
      } else {
        area += this.level * h;
      }
      this.time = end;
    }
    return area / (t - begin);
  }
  now() {
    while (this.waiting.length && this.waiting[0][0] <= this.time + 1e-10) this.level = this.waiting.shift()[1];
    return this.drive.lag > 0 ? this.lagged : this.level;
  }
}

/// Runs one record; returns its columns, one entry a controller sample.
export function runLoop(mechanism, machine, reference, referenceVelocity, substeps, seed) {
  const c = machine.controller, s = machine.sensors, link = machine.mechanism.bodies - 1;
  const noise = [new Noise(seed), new Noise(seed + 1), new Noise(seed + 2)];
  const read = (q, n) => {
    const y = s.scale * q + s.offset + s.position_noise * n.normal();
    return s.quantum > 0 ? Math.round(y / s.quantum) * s.quantum : y;
  };
  const way = new Way(machine.drive), samples = reference.length, T = c.period, h = T / substeps;
  const out = {};
  for (const name of ["position", "velocity", "command", "effort", "current", "supply", "link_position"])
    out[name] = new Float64Array(samples);
  let y = 0, last = 0, v = 0, sum = 0;
  for (let k = 0; k < samples; ++k) {
    y = read(mechanism.position(0), noise[0]);
    if (k > 0) {
      // Two readings averaged, then differenced, are half the difference over two samples.
      const d = c.average === 2 ? (y - (k > 1 ? out.position[k - 2] : out.position[0])) / (2 * T) : (y - last) / T;
      v += (T / (c.filter + T)) * (d - v);
    }
    last = y;
    const late = (c.reference_velocity ? referenceVelocity[k] : 0) - v, error = reference[k] - y;
    const seen = error - Math.min(Math.max(error, -c.dead_zone), c.dead_zone);
    const wanted = c.cascade ? c.position_gain * seen + late : seen;
    sum += T * wanted;
    const law = c.cascade ? c.velocity_gain * wanted + c.velocity_integral * sum : c.k_p * seen + c.k_v * late + c.k_i * sum;
    const ahead = c.coulomb * Math.tanh(referenceVelocity[k] / c.coulomb_speed);
    const command = Math.min(Math.max(law + ahead, -c.limit), c.limit);
    way.give(k * T, command);
    const drive = motorEffort(machine.drive, way.now(), mechanism.velocity(0));
    out.position[k] = y;
    out.velocity[k] = v;
    out.command[k] = command;
    out.effort[k] = drive.effort + s.effort_noise * noise[1].normal();
    out.current[k] = drive.current + (s.effort_noise / (machine.drive.torque_constant || 1)) * noise[1].normal();
    out.supply[k] = drive.supply;
    out.link_position[k] = read(mechanism.position(link), noise[2]);
    for (let i = 1; i <= substeps; ++i)
      mechanism.advance(motorEffort(machine.drive, way.meanUntil(k * T + i * h), mechanism.velocity(0)).effort);
    if (!(Math.abs(y) < 1e4)) throw new Error("the loop of a case is unstable");
  }
  return out;
}
