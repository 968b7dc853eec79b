// The spectrum of a linearised joint.
#pragma once
#include <complex>
#include <vector>

#include "analysis/joint/joint.h"
#include "analysis/stability/linear_friction.h"

namespace stickslip {

/// m s² + (k_v + f_v − G(s)) s + k_p: the single mass with its loop, position or force controlled    (27)
struct LinearMass {
    double inertia, k_v, k_p;
    LinearFriction friction;
};

/// The single mass with nothing but its loop, whose verdict has a closed form or a small polynomial where its memory is
/// neither delay nor table.
bool is_plain_mass(const Joint& joint);

/// The single mass of the joint about steady sliding at V.
LinearMass linear_mass(const Joint& joint, double V);

/// All roots of (27), each polished on (27) itself.
std::vector<std::complex<double>> spectrum(const LinearMass& mass);

/// max Re s over the roots of (27), without allocation for up to one state.
double spectral_abscissa(const LinearMass& mass);

}  // namespace stickslip
