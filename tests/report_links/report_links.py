#!/usr/bin/env python3
"""A page is drawn from answers: the program that composes it holds no solver. Run: report_links.py PROGRAM

Static libraries give a program the objects that it needs and no others: one call of a solver anywhere behind a page
would bring its symbols in.
"""
import pathlib
import re
import subprocess
import sys

SOLVERS = re.compile(
    r"linear_verdict|linear_point|linear_study|stable_velocities|compare_theories|spectrum\(|root_locus\(|locate_|"
    r"follow_bound|set_point\(|stability_under|hunting_field|margin_along|nearest_boundary\(stickslip::Joint|nonlinear_verdict|simulate\(|steady_sliding|"
    r"critical|CVode|nlopt|tbb::")

# They compare a limit of the joint with its steady friction (low_limit of stability/effort_limits), which stands in one object
# with what slides: computes_nothing.py holds these three against everything else.
READS_LIMITS = {"design_report", "evaluation_report", "trajectory_report"}

symbols = subprocess.run(["nm", "-C", sys.argv[1]], check=True, capture_output=True, text=True).stdout.splitlines()
own = [line for line in symbols if "stickslip::" in line or re.search(r" [UTt] (CV|nlopt)", line)]
found = sorted({line[19:] for line in own if SOLVERS.search(line)})
for name in found:
    print("a page brings in", name)
pages = pathlib.Path(__file__).parent.parent.parent / "sweep/report/pages"
makers = {name for header in pages.glob("*.h")
          for name in re.findall(r"^(?:Report|\w+Page) (\w+)\(", header.read_text(encoding="utf-8"), re.MULTILINE)}
absent = sorted(makers - READS_LIMITS - {maker for maker in makers if any(f" stickslip::{maker}(" in line for line in own)})
for maker in absent:
    print("the program does not compose", maker)
if len(makers) < 15:
    sys.exit("no makers of pages were found: nothing was tested")
sys.exit(1 if found or absent else 0)
