"""Loads of a moving arm against the closed form of two links, and one cause per joint of an arm of another engine."""
import math

import numpy
import pytest

import stickslip
from stickslip import StickslipError

M1, M2, L1, C1, C2, I1, I2, G = 3.0, 2.0, 0.5, 0.25, 0.2, 0.08, 0.03, 9.81
ROTOR = (0.4, 0.1)
URDF = f"""<robot name="two">
 <link name="ground"/>
 <link name="upper_link"><inertial><origin xyz="0 0 {-C1}"/><mass value="{M1}"/>
  <inertia ixx="0.09" iyy="{I1}" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial></link>
 <link name="lower_link"><inertial><origin xyz="0 0 {-C2}"/><mass value="{M2}"/>
  <inertia ixx="0.04" iyy="{I2}" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
 <joint name="upper" type="continuous"><parent link="ground"/><child link="upper_link"/><axis xyz="0 1 0"/></joint>
 <joint name="lower" type="continuous"><parent link="upper_link"/><child link="lower_link"/><origin xyz="0 0 {-L1}"/><axis xyz="0 1 0"/></joint>
</robot>"""


def mass_matrix(q):
    c = numpy.cos(q[1])
    m12 = I2 + M2 * (C2**2 + L1 * C2 * c)
    return numpy.array([[I1 + M1 * C1**2 + I2 + M2 * (L1**2 + C2**2 + 2 * L1 * C2 * c), m12], [m12, I2 + M2 * C2**2]])


def bias(q, dq):
    """Coriolis, centrifugal and gravity: angles from hanging down, by Lagrange (Craig, Introduction to Robotics, 6.7)."""
    h = M2 * L1 * C2 * numpy.sin(q[1])
    tip = M2 * G * C2 * numpy.sin(q[0] + q[1])
    return numpy.array([-h * (2 * dq[0] * dq[1] + dq[1]**2) + (M1 * C1 + M2 * L1) * G * numpy.sin(q[0]) + tip, h * dq[0]**2 + tip])


def two_links(q, dq, ddq):
    return mass_matrix(q) @ ddq + bias(q, dq)


def moved(t):
    """Two sines, with their derivatives."""
    q = numpy.stack([0.6 * numpy.sin(2 * t), 0.4 * numpy.cos(3 * t)], axis=1)
    dq = numpy.stack([1.2 * numpy.cos(2 * t), -1.2 * numpy.sin(3 * t)], axis=1)
    ddq = numpy.stack([-2.4 * numpy.sin(2 * t), -3.6 * numpy.cos(3 * t)], axis=1)
    return q, dq, ddq


@pytest.fixture
def urdf(tmp_path):
    file = tmp_path / "two.urdf"
    file.write_text(URDF)
    return file


def test_loads_and_inertias_are_those_of_the_closed_form(urdf):
    t = numpy.arange(0, 1, 2e-3)
    q, dq, ddq = moved(t)
    given = {n: {"time": t, "position": q[:, i]} for i, n in enumerate(("upper", "lower"))}
    by_urdf = stickslip.with_arm_load(given, urdf, armature={"lower": 0.2})
    by_engine = stickslip.with_arm_load(given, inverse_dynamics=two_links, armature={"lower": 0.2})
    for i, name in enumerate(given):
        inertia = numpy.array([mass_matrix(row)[i, i] for row in q]) + (0.2 if name == "lower" else 0)
        load = -numpy.array([two_links(a, b, c * (numpy.arange(2) != i))[i] for a, b, c in zip(q, dq, ddq)])
        for frame in (by_urdf[name], by_engine[name]):
            assert numpy.allclose(frame["inertia"], inertia, rtol=1e-5)
            wrong = numpy.abs(frame["load_effort"] - load) / numpy.abs(load).max()
            assert wrong[15:-15].max() < 1e-3  # what a cubic over 30 ms makes of these sines
            assert wrong.max() < 2e-2          # at both ends the row is not in the middle of its window
        assert numpy.allclose(by_urdf[name]["load_effort"], by_engine[name]["load_effort"], rtol=1e-9, atol=1e-9)


def test_what_the_helper_cannot_use_is_said(urdf):
    t = numpy.arange(0, 1, 1e-3)
    good = {"time": t, "position": numpy.sin(t)}
    for records, told in (({"upper": good, "lower": {"time": t + 0.5, "position": t}}, "lower: its rows are at other times"),
                          ({"upper": {"time": t}}, "upper: has no column position"),
                          ({"upper": {"time": t[:5] * 100, "position": t[:5]}}, "upper_position: has 2 rows within the window"),
                          ({"uper": good}, "upper")):
        with pytest.raises(StickslipError, match=told):
            stickslip.with_arm_load(records, urdf)
    with pytest.raises(StickslipError, match="expected an inertia above 0"):
        stickslip.with_arm_load({"a": good}, inverse_dynamics=lambda q, dq, ddq: -ddq)
    with pytest.raises(StickslipError, match="there is no record of lower"):
        stickslip.with_arm_load({"upper": good}, urdf, armature={"lower": 1})
    with pytest.raises(TypeError):
        stickslip.with_arm_load({"upper": good})


GAINS = ((900.0, 60.0), (250.0, 14.0))
FRICTION = ((3.0, 1.0), (1.0, 0.3))
PERIOD, NOISE = 2e-3, 3e-5


def joint_files():
    """What the documents say. Inertias stand in the records; the file's are those of the pose at the start."""
    files = {}
    for i, name in enumerate(("upper", "lower")):
        files[name] = stickslip.Joint.from_dict({
            "joint": {"motion": "revolute", "inertia": float(mass_matrix((0, 0))[i, i] + ROTOR[i])},
            "control": {"k_p": GAINS[i][0], "k_v": GAINS[i][1], "period": PERIOD, "velocity_estimate": {"form": "backward-difference"}},
            "friction": {"law": "coulomb-viscous", "coulomb": FRICTION[i][0], "viscous": FRICTION[i][1]},
            "sensor": {"encoder_quantum": 1e-6, "position_noise": NOISE}})
    return files


def simulated(seconds, seed, friction=FRICTION, gains=GAINS, load=(0.0, 0.0)):
    """The arm in its two loops, by semi-implicit steps of 0.2 ms; Coulomb friction by projected Gauss-Seidel on the impulses
    of a step (Moreau 1988). In plain numbers: arrays of two would take most of the time."""
    rng = numpy.random.default_rng(seed)
    steps, h = 10, PERIOD / 10
    t = numpy.arange(0, seconds, PERIOD)
    # two sines each that share no frequency: each joint turns round while the other one moves
    reference = numpy.stack([0.5 * numpy.sin(1.3 * t) ** 2 + 0.1 * numpy.sin(4.1 * t) ** 2,
                             0.6 * numpy.sin(1.9 * t) ** 2 + 0.08 * numpy.sin(5.3 * t) ** 2], axis=1)
    reference_velocity = numpy.gradient(reference, PERIOD, axis=0)
    noise = NOISE * rng.standard_normal((len(t), 2))
    (F1, V1), (F2, V2) = friction
    a, b = M2 * L1 * C2, M2 * G * C2
    m22 = I2 + M2 * C2**2
    m11 = I1 + M1 * C1**2 + m22 + M2 * L1**2
    q1 = q2 = w1 = w2 = 0.0
    before, columns = None, []
    for k in range(len(t)):
        read = [round((q + e) / 1e-6) * 1e-6 for q, e in zip((q1, q2), noise[k])]
        estimate = [0.0, 0.0] if before is None else [(r - o) / PERIOD for r, o in zip(read, before)]
        before = read
        u1, u2 = (g[0] * (reference[k, i] - read[i]) + g[1] * (reference_velocity[k, i] - estimate[i]) for i, g in enumerate(gains))
        columns.append((read, estimate, (u1, u2)))
        for _ in range(steps):
            c, s = math.cos(q2), math.sin(q2)
            A, B, D = m11 + 2 * a * c + ROTOR[0], m22 + a * c, m22 + ROTOR[1]
            det, tip = A * D - B * B, b * math.sin(q1 + q2)
            e1 = u1 + load[0] - V1 * w1 + a * s * (2 * w1 * w2 + w2 * w2) - (M1 * C1 + M2 * L1) * G * math.sin(q1) - tip
            e2 = u2 + load[1] - V2 * w2 - a * s * w1 * w1 - tip
            free1, free2 = w1 + h * (D * e1 - B * e2) / det, w2 + h * (A * e2 - B * e1) / det
            p1 = p2 = 0.0
            for _ in range(6):
                p1 = min(max(p1 - (free1 + (D * p1 - B * p2) / det) * det / D, -h * F1), h * F1)
                p2 = min(max(p2 - (free2 + (A * p2 - B * p1) / det) * det / A, -h * F2), h * F2)
            w1, w2 = free1 + (D * p1 - B * p2) / det, free2 + (A * p2 - B * p1) / det
            q1, q2 = q1 + h * w1, q2 + h * w2
    read, estimate, command = (numpy.array([c[i] for c in columns]) for i in range(3))
    return {name: {"time": t, "reference_position": reference[:, i], "reference_velocity": reference_velocity[:, i],
                   "position": read[:, i], "velocity": estimate[:, i], "effort_command": command[:, i]}
            for i, name in enumerate(("upper", "lower"))}


# A constant load and a Coulomb level that differs between the directions are the very same motion: either name is right.
@pytest.mark.parametrize("planted, found", (
    ({}, {}),
    ({"friction": ((4.2, 1.0), (1.0, 0.3)), "gains": (GAINS[0], (200.0, 14.0))}, {"upper": {"coulomb-level"}, "lower": {"gain-k_p"}}),
    ({"friction": (FRICTION[0], (1.0, 0.9)), "load": (2.0, 0.0)},
     {"upper": {"constant-load", "asymmetric-friction"}, "lower": {"viscous"}})))
def test_one_cause_a_joint_of_a_moving_arm_is_found(urdf, planted, found):
    records = stickslip.with_arm_load(simulated(6, 5, **planted), urdf, armature={"upper": ROTOR[0], "lower": ROTOR[1]})
    for name, joint in joint_files().items():
        diagnosis = stickslip.diagnose(joint, {"run": records[name]})
        assert diagnosis["verdict"] == ("gap" if name in found else "no-gap"), name
        if name in found:
            (cause,) = diagnosis["effects"][0]["names"]
            assert cause in found[name]


def test_what_a_computed_load_is_wrong_by_is_no_unmodelled_force(urdf):
    """The upper joint turns round at a few positions of the lower one, again and again, and the smoothed load is wrong there."""
    records = stickslip.with_arm_load(simulated(6, 303, load=(0.0, -0.3367)), urdf, armature={"upper": ROTOR[0], "lower": ROTOR[1]})
    diagnosis = stickslip.diagnose(joint_files()["lower"], {"run": records["lower"]})
    assert diagnosis["verdict"] == "gap" and diagnosis["effects"][0]["names"][0] in {"constant-load", "asymmetric-friction"}


def test_without_the_arm_in_it_the_same_record_has_a_gap(urdf):
    """What the columns are for: the joint's own file knows nothing of the other joint and of weight."""
    records = simulated(6, 5)
    diagnosis = stickslip.diagnose(joint_files()["lower"], {"run": records["lower"]})
    assert diagnosis["verdict"] != "no-gap" and diagnosis["gap"]["overall"]["before"] > 10


def test_a_map_over_the_pose_says_that_only_the_stretched_arm_sticks(urdf, tmp_path):
    """Rate-and-state friction on the upper joint: one mass and one state have a critical gain that grows with the inertia."""
    A, B, L, V = 1.0, 1.5, 1e-3, 1e-2
    elbow = numpy.linspace(0, 3, 7)

    def critical(inertia):  # ((B − A)/L)(1 + m V²/(L A)), by hand (paper, equations 36 and 37 at k_v = 0)
        return (B - A) / L * (1 + inertia * V**2 / (L * A))

    inertia = numpy.array([mass_matrix((0, q))[0, 0] + ROTOR[0] for q in elbow])
    between = float(critical(inertia).min() + critical(inertia).max()) / 2
    joint = stickslip.Joint.from_dict({"joint": {"motion": "revolute", "inertia": 1.0}, "control": {"k_p": between, "V0": V},
                                       "friction": {"law": "rate-and-state", "f0": 60.0, "A": A, "B": B, "L": L, "V_star": V}})
    maps = stickslip.sweep_poses(urdf, "upper", {"lower": elbow}, joint, armature=ROTOR[0])
    assert maps["k_cr"].dims == ("lower",) and maps["lower"].attrs["units"] == "rad"
    assert numpy.allclose(maps["k_cr"], critical(inertia), rtol=1e-6)
    assert list(maps["spectral_abscissa"].values < 0) == list(critical(inertia) < between)
    assert maps["spectral_abscissa"].values[0] > 0 > maps["spectral_abscissa"].values[-1]  # stretched, folded

    # the same from a spec, over the pose and the gain, and the angle from which on the arm slides
    spec = {"joint": str(tmp_path / "upper.toml"), "robot": {"file": str(urdf), "joint": "upper", "armature": ROTOR[0]},
            "axes": {"pose.lower": {"from": 0.0, "to": 3.0, "points": 7}, "control.k_p": [between / 2, between]}}
    joint.save(spec["joint"])
    assert numpy.allclose(stickslip.sweep(spec)["k_cr"].isel(k_p=1), critical(inertia), rtol=1e-6)
    found = stickslip.boundary(spec, along="pose.lower", kind="linear", settings={"control.k_p": between}).at("lines.0.points.0.value")
    m11 = (between * L / (B - A) - 1) * L * A / V**2 - ROTOR[0]
    assert abs(mass_matrix((0, found))[0, 0] - m11) < 1e-6 * m11
    with pytest.raises(StickslipError, match="axes.pose.lowr: is none of the other joints of the robot, expected pose.lower"):
        stickslip.sweep_poses(urdf, "upper", {"lowr": elbow}, joint)
    with pytest.raises(StickslipError, match="both have lower"):
        stickslip.sweep_poses(urdf, "upper", {"lower": elbow}, joint, at={"lower": 1})
