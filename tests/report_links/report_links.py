#!/usr/bin/env python3
"""A page is drawn from answers: the program that composes it holds no solver. Run: report_links.py PROGRAM

Static libraries give a program the objects that it needs and no others: one call of a solver anywhere behind the pages
of a sweep, of a joint or of boundaries would bring its symbols in.
"""
import re
import subprocess
import sys

SOLVERS = re.compile(
    r"linear_verdict|linear_point|linear_study|stable_velocities|compare_theories|spectrum\(|root_locus\(|locate_|"
    r"follow_bound|set_point\(|stability_under|hunting_field|margin_along|nearest_boundary\(stickslip::Joint|nonlinear_verdict|simulate\(|steady_sliding|"
    r"critical|CVode|nlopt|tbb::")

symbols = subprocess.run(["nm", "-C", sys.argv[1]], check=True, capture_output=True, text=True).stdout.splitlines()
own = [line for line in symbols if "stickslip::" in line or re.search(r" [UTt] (CV|nlopt)", line)]
found = sorted({line[19:] for line in own if SOLVERS.search(line)})
for name in found:
    print("a page brings in", name)
if not any("stability_report" in line for line in own):
    sys.exit("the program does not compose the page: nothing was tested")
sys.exit(1 if found else 0)
