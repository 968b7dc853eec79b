// Inertial parameters of five public arms, from their published tables, as MJCF and URDF text written here.
// A link's frame stands at its joint; `at` and `turn` place it on the link before (turn: quaternion w x y z, any length).

const diagonal = (x, y, z) => [x, y, z, 0, 0, 0];

/// Universal Robots UR5e: the manufacturer's ur_description (masses, centres) with inertias of cylinders.
const ur5e = {
  name: "ur5e", links: [
    { at: [0, 0, 0.163], turn: [1, 0, 0, 1], axis: [0, 0, 1], mass: 3.7, centre: [0, 0, 0], inertia: diagonal(0.0102675, 0.0102675, 0.00666), armature: 0.1 },
    { at: [0, 0.138, 0], turn: [1, 0, 1, 0], axis: [0, 1, 0], mass: 8.393, centre: [0, 0, 0.2125], inertia: diagonal(0.133886, 0.133886, 0.0151074), armature: 0.1 },
    { at: [0, -0.131, 0.425], axis: [0, 1, 0], mass: 2.275, centre: [0, 0, 0.196], inertia: diagonal(0.0311796, 0.0311796, 0.004095), armature: 0.1 },
    { at: [0, 0, 0.392], turn: [1, 0, 1, 0], axis: [0, 1, 0], mass: 1.219, centre: [0, 0.127, 0], inertia: diagonal(0.0025599, 0.0025599, 0.0021942), armature: 0.1 },
    { at: [0, 0.127, 0], axis: [0, 0, 1], mass: 1.219, centre: [0, 0, 0.1], inertia: diagonal(0.0025599, 0.0025599, 0.0021942), armature: 0.1 },
    { at: [0, 0, 0.1], axis: [0, 1, 0], mass: 0.1889, centre: [0, 0.0771683, 0], inertia: diagonal(9.90863e-5, 0.000132134, 9.90863e-5), armature: 0.1 }]
};

/// Franka Emika Panda: Gaz, Cognetti, Oliva, Robuffo Giordano, De Luca 2019, IEEE Robot. Autom. Lett. 4, 4147-4154.
const panda = {
  name: "panda", links: [
    { at: [0, 0, 0.333], mass: 4.970684, centre: [0.003875, 0.002081, -0.04762], inertia: [0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169], armature: 0.1 },
    { turn: [1, -1, 0, 0], mass: 0.646926, centre: [-0.003141, -0.02872, 0.003495], inertia: [0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704], armature: 0.1 },
    { at: [0, -0.316, 0], turn: [1, 1, 0, 0], mass: 3.228604, centre: [0.027518, 0.039252, -0.066502], inertia: [0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805], armature: 0.1 },
    { at: [0.0825, 0, 0], turn: [1, 1, 0, 0], mass: 3.587895, centre: [-0.05317, 0.104419, 0.027454], inertia: [0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641], armature: 0.1 },
    { at: [-0.0825, 0.384, 0], turn: [1, -1, 0, 0], mass: 1.225946, centre: [-0.011953, 0.041065, -0.038437], inertia: [0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229], armature: 0.1 },
    { turn: [1, 1, 0, 0], mass: 1.666555, centre: [0.060149, -0.014117, -0.010517], inertia: [0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341], armature: 0.1 },
    { at: [0.088, 0, 0], turn: [1, 1, 0, 0], mass: 0.735522, centre: [0.010517, -0.004252, 0.061597], inertia: [0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741], armature: 0.1 }]
};

/// KUKA LBR iiwa 14 R820: the parameters of the public iiwa_description.
const iiwa = {
  name: "iiwa14", links: [
    { at: [0, 0, 0.1575], mass: 5.76, centre: [0, -0.03, 0.12], inertia: diagonal(0.0333, 0.033, 0.0123) },
    { at: [0, 0, 0.2025], turn: [0, 0, 1, 1], mass: 6.35, centre: [0.0003, 0.059, 0.042], inertia: diagonal(0.0305, 0.0304, 0.011) },
    { at: [0, 0.2045, 0], turn: [0, 0, 1, 1], mass: 3.5, centre: [0, 0.03, 0.13], inertia: diagonal(0.025, 0.0238, 0.0076) },
    { at: [0, 0, 0.2155], turn: [1, 1, 0, 0], mass: 3.5, centre: [0, 0.067, 0.034], inertia: diagonal(0.017, 0.0164, 0.006) },
    { at: [0, 0.1845, 0], turn: [0, 0, 1, 1], mass: 3.5, centre: [0.0001, 0.021, 0.076], inertia: diagonal(0.01, 0.0087, 0.00449) },
    { at: [0, 0, 0.2155], turn: [1, 1, 0, 0], mass: 1.8, centre: [0, 0.0006, 0.0004], inertia: diagonal(0.0049, 0.0047, 0.0036) },
    { at: [0, 0.081, 0], turn: [0, 0, 1, 1], mass: 1.2, centre: [0, 0, 0.02], inertia: diagonal(0.001, 0.001, 0.001) }]
};

/// Kinova Gen3 with seven joints: the manufacturer's description; principal axes turned by a quaternion each.
const gen3 = {
  name: "gen3", links: [
    { at: [0, 0, 0.15643], turn: [0, 1, 0, 0], mass: 1.3773, centre: [-2.3e-5, -0.010364, -0.07336], principal: [0.00488868, 0.00457, 0.00135132], axes: [0.707051, 0.0451246, -0.0453544, 0.704263] },
    { at: [0, 0.005375, -0.12838], turn: [1, 1, 0, 0], mass: 1.1636, centre: [-4.4e-5, -0.09958, -0.013278], principal: [0.0113017, 0.011088, 0.00102532], axes: [0.482348, 0.516286, -0.516862, 0.483366] },
    { at: [0, -0.21038, -0.006375], turn: [1, -1, 0, 0], mass: 1.1636, centre: [-4.4e-5, -0.006641, -0.117892], principal: [0.0111633, 0.010932, 0.00100671], axes: [0.706144, 0.0213722, -0.0209128, 0.707437] },
    { at: [0, 0.006375, -0.21038], turn: [1, 1, 0, 0], mass: 0.9302, centre: [-1.8e-5, -0.075478, -0.015006], principal: [0.00834839, 0.008147, 0.000598606], axes: [0.483678, 0.515961, -0.515859, 0.483455] },
    { at: [0, -0.20843, -0.006375], turn: [1, -1, 0, 0], mass: 0.6781, centre: [1e-6, -0.009432, -0.063883], principal: [0.00165901, 0.001596, 0.000346988], axes: [0.703558, 0.0707492, -0.0707492, 0.703558] },
    { at: [0, 0.00017505, -0.10593], turn: [1, 1, 0, 0], mass: 0.6781, centre: [1e-6, -0.045483, -0.00965], principal: [0.00170087, 0.001641, 0.00035013], axes: [0.44426, 0.550121, -0.550121, 0.44426] },
    { at: [0, -0.10593, -0.00017505], turn: [1, -1, 0, 0], mass: 0.5, centre: [0.000281, 0.011402, -0.029798], principal: [0.000657336, 0.000587019, 0.000320645], axes: [0.394358, 0.596779, -0.577293, 0.393789] }]
};

/// UFACTORY xArm7: the manufacturer's description; principal axes turned by a quaternion each.
const xarm = {
  name: "xarm7", links: [
    { at: [0, 0, 0.267], mass: 2.382, centre: [-0.0002, 0.02905, -0.01233], principal: [0.00569127, 0.00533384, 0.00293865], axes: [0.978953, -0.202769, -0.00441617, -0.0227264] },
    { turn: [1, -1, 0, 0], mass: 1.869, centre: [0.00022, -0.12856, 0.01735], principal: [0.00959898, 0.00937717, 0.00201315], axes: [0.50198, 0.86483, -0.00778841, 0.00483285] },
    { at: [0, -0.293, 0], turn: [1, 1, 0, 0], mass: 1.6383, centre: [0.0466, -0.02463, -0.00768], principal: [0.00351721, 0.00294089, 0.00195868], axes: [0.913819, 0.289775, 0.281481, -0.0416455] },
    { at: [0.0525, 0, 0], turn: [1, 1, 0, 0], mass: 1.7269, centre: [0.07047, -0.11575, 0.012], principal: [0.00657137, 0.00647948, 0.00186763], axes: [0.422108, 0.852026, -0.126025, 0.282832] },
    { at: [0.0775, -0.3425, 0], turn: [1, 1, 0, 0], mass: 1.3203, centre: [-0.00032, 0.01604, -0.026], principal: [0.00534729, 0.00499076, 0.0013489], axes: [0.999311, -0.0304457, 0.000577067, 0.0212082] },
    { turn: [1, 1, 0, 0], mass: 1.325, centre: [0.06469, 0.03278, 0.02141], principal: [0.00245421, 0.00221646, 0.00107273], axes: [-0.217672, 0.772419, 0.16258, 0.574069] },
    { at: [0.076, 0.097, 0], turn: [1, -1, 0, 0], mass: 0.17, centre: [0, -0.00677, -0.01098], principal: [0.000132176, 9.3e-5, 5.85236e-5], axes: [0.487612, 0.512088, -0.512088, 0.487612] }]
};

/// Two links that hang in a vertical plane, their axes parallel: those of tests/python/test_arm.py.
const planar = {
  name: "two-links", links: [
    { axis: [0, 1, 0], mass: 3, centre: [0, 0, -0.25], inertia: diagonal(0.09, 0.08, 0.02), armature: 0.1 },
    { at: [0, 0, -0.5], axis: [0, 1, 0], mass: 2, centre: [0, 0, -0.2], inertia: diagonal(0.04, 0.03, 0.01), armature: 0.1 }]
};

/// Rotation of a quaternion of any length.
function matrix(q) {
  const n = Math.hypot(...q), [w, x, y, z] = q.map(v => v / n);
  return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]];
}

/// xx yy zz xy xz yz of principal moments whose axes a quaternion turns.
function full(principal, q) {
  const r = matrix(q), at = (i, j) => principal.reduce((sum, p, k) => sum + r[i][k] * p * r[j][k], 0);
  return [at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(0, 2), at(1, 2)];
}

const inertiaOf = link => link.inertia ?? full(link.principal, link.axes);
const numbers = values => values.map(v => v.toPrecision(17)).join(" ");

function mjcf(arm) {
  let inside = "", outside = "";
  arm.links.forEach((link, i) => {
    const inertia = link.principal ? `diaginertia="${numbers(link.principal)}" quat="${numbers(link.axes)}"` : `fullinertia="${numbers(link.inertia)}"`;
    inside += `<body name="link${i + 1}" pos="${numbers(link.at ?? [0, 0, 0])}" quat="${numbers(link.turn ?? [1, 0, 0, 0])}">
      <joint name="joint${i + 1}" axis="${numbers(link.axis ?? [0, 0, 1])}" armature="${link.armature ?? 0}"/>
      <inertial pos="${numbers(link.centre)}" mass="${link.mass}" ${inertia}/>\n`;
    outside += "</body>";
  });
  return `<mujoco model="${arm.name}"><compiler angle="radian"/><worldbody>${inside}${outside}</worldbody></mujoco>`;
}

/// Roll, pitch and yaw about fixed axes.
function rpy(q) {
  const r = matrix(q), level = Math.hypot(r[0][0], r[1][0]);
  if (level < 1e-12) return [Math.atan2(-r[1][2], r[1][1]), Math.atan2(-r[2][0], level), 0];
  return [Math.atan2(r[2][1], r[2][2]), Math.atan2(-r[2][0], level), Math.atan2(r[1][0], r[0][0])];
}

function urdf(arm) {
  let text = `<robot name="${arm.name}"><link name="ground"/>\n`;
  arm.links.forEach((link, i) => {
    const [xx, yy, zz, xy, xz, yz] = inertiaOf(link).map(v => v.toPrecision(17));
    text += `<link name="link${i + 1}"><inertial><origin xyz="${numbers(link.centre)}"/><mass value="${link.mass}"/>
      <inertia ixx="${xx}" iyy="${yy}" izz="${zz}" ixy="${xy}" ixz="${xz}" iyz="${yz}"/></inertial></link>
      <joint name="joint${i + 1}" type="continuous"><parent link="${i ? `link${i}` : "ground"}"/><child link="link${i + 1}"/>
      <origin xyz="${numbers(link.at ?? [0, 0, 0])}" rpy="${numbers(rpy(link.turn ?? [1, 0, 0, 0]))}"/><axis xyz="${numbers(link.axis ?? [0, 0, 1])}"/></joint>\n`;
  });
  return text + "</robot>";
}

const described = arm => ({ name: arm.name, joints: arm.links.length, mjcf: mjcf(arm), urdf: urdf(arm) });
export const arms = [ur5e, panda, iiwa, gen3, xarm].map(described), twoLinks = described(planar);
