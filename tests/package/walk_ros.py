"""Stands for the robot: what its shoulder would log as MCAP, joint states and commands, with other friction than documented."""
import pathlib
import subprocess

import log_samples as sample
import numpy
import pandas

time = numpy.arange(4000) * 2e-3
pandas.DataFrame({"time": time, "reference_position": 0.4 * (1 - numpy.cos(3 * time)) + 0.05 * numpy.sin(11 * time)}).to_csv("motion.csv", index=False)
subprocess.run(["stickslip", "simulate", "shoulder.toml", "--reference", "motion.csv", "--set", "friction.coulomb=0.64", "-o", "real"], check=True)
record = pandas.read_csv("real/record.csv")
messages = []
for row in record.itertuples():
    state = sample.Cdr().add("i", 1_700_000_000 + int(row.time)).add("I", int(round(row.time % 1 * 1e9))).string("base").add("I", 1)
    state = state.string("shoulder").doubles([row.position]).doubles([row.velocity]).doubles([row.effort_measured])
    messages.append(("/commands", "std_msgs/msg/Float64MultiArray", row.time, sample.ros2_multi_array([row.reference_position])))
    messages.append(("/joint_states", "sensor_msgs/msg/JointState", row.time + 1e-4, state.message()))
sample.mcap_of(pathlib.Path("run.mcap"), messages)
