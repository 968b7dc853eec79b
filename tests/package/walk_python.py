"""The walk of a Python user: a map, a boundary, a record, its diagnosis, a chart."""
import numpy
import pandas

import stickslip

joint = stickslip.Joint.example()
answer = stickslip.evaluate(joint)
assert answer["decided"], answer
edge = stickslip.boundary(joint, along="control.k_p=1e3..1e7")
print(edge)

JOINT = """[joint]
motion = "revolute"
inertia = 0.3
[control]
k_p = 400
k_v = 20
period = 2e-3
velocity_estimate = { form = "backward-difference" }
[friction]
law = "coulomb-viscous"
coulomb = 1.0
viscous = 0.3
[sensor]
encoder_quantum = 1e-6
position_noise = 1e-6
"""
time = numpy.arange(2000) * 2e-3
reference = pandas.DataFrame({"time": time, "reference_position": 0.4 * (1 - numpy.cos(3.5 * time))})
run = stickslip.simulate(JOINT, {"load.constant": 0.8}, reference=reference)
found = stickslip.diagnose(JOINT, {"run1": run})
assert found["verdict"] == "gap" and found["effects"][0]["names"] == ["constant-load"], found["reasons"]
stickslip.plot_effects(found).figure.savefig("effects.png")
