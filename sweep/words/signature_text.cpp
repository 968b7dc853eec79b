#include "sweep/words/signature_text.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace stickslip {
namespace {

using Row = std::pair<std::string_view, std::string_view>;

constexpr Row signatures[] = {
    {"actuator-lag", "phase, at high frequency"},
    {"asymmetric-friction", "friction differs between the directions"},
    {"backlash", "flat gap and impact at reversal"},
    {"cogging", "locked to position, does not flip with velocity"},
    {"compliance", "resonance; extra lag that grows with acceleration"},
    {"constant-load", "even in velocity, constant"},
    {"coulomb-level", "square in the sign of velocity"},
    {"dead-zone", "the command is the proportional part less k_p times the zone, and nothing within it"},
    {"delay", "phase linear in frequency"},
    {"effort-gain", "proportional to effort"},
    {"feed-forward", "a function of the reference alone, in the command"},
    {"friction-drift", "slow trend of the friction level"},
    {"frictional-memory", "transient after a speed change, in slip distance"},
    {"gain-k_i", "proportional to the integral of the position error, in the command"},
    {"gain-k_p", "proportional to the tracking error, in the command"},
    {"gain-k_v", "proportional to the velocity error, in the command"},
    {"gravity", "even in velocity, sine of position"},
    {"inertia", "proportional to acceleration"},
    {"load-dependent-friction", "friction grows with the transmitted effort"},
    {"periodic-disturbance", "locked to time, not to position"},
    {"position-dependent-friction", "locked to position, flips with velocity"},
    {"presliding", "spring-like loop at reversal"},
    {"quantisation", "bounded sawtooth: readings lie on a coarser grid"},
    {"saturation", "only at the limit"},
    {"sensor-offset", "sine of position under gravity"},
    {"stribeck", "friction falls from rest to low speed, then flat"},
    {"supply-sag", "grows with drive"},
    {"velocity-filter", "acts with k_v only"},
    {"viscous", "linear in velocity"},
    {"law:coulomb-viscous", "never sticks and slips where k_v and the viscous slope damp"},
    {"law:kinetic-static",
     "sticks and slips below a velocity that falls as stiffness or damping rise, at any small velocity without "
     "damping"},
    {"law:stribeck", "damping decides; stiffness alone never steadies sliding where the friction falls with velocity"},
    {"law:rate-and-state",
     "above a stiffness that low velocities hardly change every joint slides, although its friction falls with "
     "velocity"},
    {"law:ageing",
     "above a stiffness that low velocities hardly change every joint slides, although its friction falls with "
     "velocity"},
    {"law:time-lag", "windows of stiffness in which sliding is smooth, in step with the lag"},
    {"law:lugre", "a damping beyond that of the bristles is needed first, then a stiffness"},
    {"numbers", "in proportion to the numbers that are off"},
};

/// What files call a number is no sentence, and stays as it is; these are told in other words.
constexpr Row labels[] = {
    {"Coulomb level in the end", "Coulomb level at the end"},
    {"amplitude over the position", "amplitude of friction over the position"},
};

template <std::size_t n>
std::string found_in(const Row (&rows)[n], std::string_view key)
{
    const auto row = std::ranges::find(rows, key, &Row::first);
    return std::string(row == std::end(rows) ? key : row->second);
}

}  // namespace

std::string signature_text(const std::vector<std::string>& of)
{
    std::string text;
    for (const auto& one : of) text += (text.empty() ? "" : "; ") + found_in(signatures, one);
    return text;
}

std::string sheet_label(const std::string& key)
{
    return found_in(labels, key);
}

}  // namespace stickslip
