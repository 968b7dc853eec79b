// How a joint is to hold a set point without hunting about it: what a design found.
#pragma once
#include <vector>

#include "analysis/results/set_point.h"

namespace stickslip {

/// What keeps a loop from hunting.
enum class SetPointWay : std::uint8_t {
    as_described,           ///< nothing: the joint as it is
    no_integral,            ///< k_i = 0
    dead_zone,              ///< the error counts only outside it
    push,                   ///< Coulomb effort towards the set point, while the joint stands
    push_without_integral,  ///< the same, k_i = 0
    push_and_dead_zone,
    dither_without_integral  ///< a vibration below the kinetic friction, k_i = 0
};

/// As JSON calls it.
constexpr std::string_view name_of(SetPointWay way)
{
    constexpr std::string_view names[] = {
        "as-described",           "no-integral", "dead-zone", "push", "push-without-integral", "push-and-dead-zone",
        "dither-without-integral"};
    static_assert(std::size(names) == static_cast<std::size_t>(SetPointWay::dither_without_integral) + 1);
    return names[static_cast<std::size_t>(way)];
}

/// What a joint with one of the frictions that are reckoned with does.
struct SetPointProof {
    double coulomb = missing, breakaway = missing;  ///< kinetic and static friction
    SetPoint answer;
};

/// The best of one way.
struct SetPointChoice {
    SetPointWay way = SetPointWay::as_described;
    bool holds = false;  ///< hunts with none of the frictions
    double k_i = missing, dead_zone = missing;
    double push = 0, push_speed = missing;  ///< in the units of the command
    double dither = 0, dither_frequency = missing;
    double low = missing, high = missing;  ///< between which the number that was chosen does not hunt
    double rest_error = missing;           ///< largest over the frictions
    std::vector<SetPointProof> proofs;
};

struct SetPointDesign {
    double k_i_limit = missing;  ///< above it the loop as it is is unstable without any dry friction; 0: with every k_i
    double k_i_used = missing;   ///< of the ways that integrate
    bool k_i_assumed = false;    ///< the joint has none: a tenth of the limit
    std::vector<SetPointChoice> choices;
    int best = -1;  ///< of those that hold the one with the least error at rest; −1: none
};

}  // namespace stickslip
