// What turns joints into jobs of the lanes, whatever their law.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>

#include "analysis/joint/joint.h"
#include "analysis/simulation/lanes/job.h"

namespace stickslip::lanes {

/// To 44 bits, so that points which differ by roundoff only are one.
inline double rounded(double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    constexpr std::uint64_t lost = 8;  // of 52
    return std::bit_cast<double>((bits + (std::uint64_t{1} << (lost - 1))) >> lost << lost);
}

/// A law with nothing beside it.
inline bool plain(const Friction& f, const Load& l)
{
    return f.asymmetry.coulomb == 0 && f.asymmetry.viscous == 0 && !f.level_moves() && f.bristle.stiffness == 0 &&
           f.memory.A == 0 && f.memory.B == 0 && f.memory.lag == 0 && l.gravity_amplitude == 0 && !l.cogging.acts() &&
           l.disturbance.amplitude == 0;
}

/// A rate-and-state law whose one state the lanes can step.
struct OneState {
    const RateStateParameters* law = nullptr;  ///< null: another law, or several states
    StateLaw kind = StateLaw::slip;
};

inline OneState one_state(const Friction& friction)
{
    OneState found;
    if (const auto* slip = std::get_if<RateAndState>(&friction.law)) found = {slip, StateLaw::slip};
    if (const auto* ageing = std::get_if<Ageing>(&friction.law)) found = {ageing, StateLaw::ageing};
    return found.law && found.law->B.size == 1 ? found : OneState{};
}

/// A single mass under position feedback alone.
inline bool single(const Joint& joint)
{
    return joint.mechanism.model == Model::single_mass && joint.control.contact_stiffness == 0 &&
           joint.control.force_gain == 0 && !joint.normal.moves() && joint.neighbour.size == 0;
}

}  // namespace stickslip::lanes
