// Which loop a verdict is about, and what of the joint's description it could not use.
#pragma once
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/joint/joint.h"

namespace stickslip {

/// ideal: k_p and k_v act at once and without end, as in the paper. continuous: behind dead time, lag and filter, with
/// an integral. sampled: read, computed and held tick by tick.
enum class LoopKind { ideal, continuous, sampled };

/// Why the linear theory of steady sliding has no place for a term that the joint has.
enum class WhyNot {
    small_signal,    ///< a limit, a band or a dead zone: small motions about steady sliding do not reach it
    rounding,        ///< encoder steps and noise: sliding holds only up to a jitter
    place,           ///< locked to position: steady sliding has no one linear system
    time,            ///< locked to time: it forces the joint and moves no root
    backlash,        ///< closed while the load has one sign, open it has no linear system
    needs_period,    ///< of a sampled estimate, in a loop without a period
    no_feedback,     ///< the loop feeds nothing back that it could act on
    reference_only,  ///< it acts on the reference alone and moves no root
    load_direction,  ///< friction of a gear, with a kink where the effort at the load changes its sign
    fed_back,        ///< a push by the side of the set point, of which the linear theory has no term
    unsupported,     ///< this loop has no evaluation with such friction
    overruled,       ///< another key says the same and goes before it
    other_kind,      ///< of a kind of control that the joint does not have
    told_velocity    ///< of an estimate, where a sampled loop is told its velocity
};

/// As JSON calls it.
constexpr std::string_view name_of(WhyNot why)
{
    constexpr std::string_view names[] = {"small-signal", "rounding",    "place",          "time",           "backlash",
                                          "needs-period", "no-feedback", "reference-only", "load-direction", "fed-back",
                                          "unsupported",  "overruled",   "other-kind",     "told-velocity"};
    static_assert(std::size(names) == static_cast<std::size_t>(WhyNot::told_velocity) + 1);
    return names[static_cast<std::size_t>(why)];
}

struct UnusedTerm {
    std::string key;
    WhyNot why;
    bool matters = false;  ///< a verdict without it may be wrong for motions of ordinary size
};

/// A gear between motor and joint. Verdicts count displacement, gains and efforts at the joint's side, records push the
/// motor and read where the encoder is.
struct GearSide {
    double ratio = 1;  ///< turns of the motor per turn of the joint; 1: none lies between
    /// k_p at the joint's side per k_p of a record: ratio², or ratio of a signal in volts or duty; of an encoder on the
    /// link ratio, or 1.
    double gain = 1;
    bool dc_motor = false;    ///< k_t and k_e are counted at either side, too
    bool reads_link = false;  ///< readings are the joint's in records as well

    bool between() const { return ratio != 1; }
};
GearSide gear_side(const Joint& joint);

struct LoopUse {
    LoopKind kind = LoopKind::ideal;
    std::vector<std::string> used;  ///< paths beyond those of the ideal loop
    std::vector<UnusedTerm> not_used;
    GearSide gear;  ///< of verdicts and records
};

/// The kind alone, without allocation.
LoopKind loop_kind(const Joint& joint);
LoopUse loop_use(const Joint& joint);

/// The joint under the paper's loop: k_p and k_v act at once. Of the drive and the reading constant factors and the
/// back-EMF stay, which turn gains of a drive signal into stiffness and damping.
Joint with_ideal_loop(Joint joint);

/// The loop of the joint with, as `used`, only what with_ideal_loop() leaves out of it: nothing where it changes
/// nothing.
LoopUse left_out_by_ideal(const Joint& joint);

}  // namespace stickslip
