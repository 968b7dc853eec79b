// The example joint as a user writes it: A = 1 N, B = 1.5 N, L = 10 µm, f0 = 60 N at V* = 1 mm/s.
#pragma once
#include <sstream>
#include <string>

/// The tables of a joint file, SI.
inline std::string example_joint_text(double inertia, double k_p, double k_v, double V0)
{
    std::ostringstream text;
    text << "[joint]\nmotion = \"prismatic\"\nmodel = \"single-mass\"\ninertia = " << inertia
         << "\n[control]\nkind = \"position\"\nk_p = " << k_p << "\nk_v = " << k_v << "\nV0 = " << V0
         << "\n[friction]\nlaw = \"rate-and-state\"\nf0 = 60.0\nA = 1.0\nB = 1.5\nL = 1.0e-5\nV_star = 1.0e-3\n";
    return text.str();
}
