// The numbers that a ladder of causes goes by. Their values, with reasons and evidence, stand in ladder.h.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace stickslip::gap {

/// Standard deviations of what a joint file says, as parts of each number.
struct CorrectionPrior {
    double inertia, coulomb, viscous;
    double coulomb_of_record;  ///< from record to record
    double load;               ///< of the Coulomb level
    double gravity;            ///< of the documented amplitude
    double least;              ///< of the usual effort: a number that is documented as less counts as that
    double small_term;         ///< of the Coulomb level: ripple, cogging, asymmetry and drift that nobody documents
    double widest;             ///< standard deviations at which the prior is cut off
};

/// What a physical range is counted in.
enum class Per {
    scale,             ///< the unit in which the parameter is fitted
    coulomb,           ///< the documented Coulomb level
    reading,           ///< what the encoder resolves: its step or its noise
    winding,           ///< resistance of the motor's winding
    period_of_record,  ///< an angular frequency, in periods over the longest record
    period_of_travel   ///< a wave number, in periods over the travel
};

/// Numbers outside are no property of a joint: a cause that needs them only soaks up what something else leaves.
struct PhysicalRange {
    std::string_view effect, parameter;
    double low, high;
    Per per;
    std::string_view reason;
};

struct LadderRules {
    CorrectionPrior prior;
    std::size_t most_rungs;
    std::size_t first_look, finalists;  ///< causes that get a first look beside the corrections, and that go on
    double worth_a_rung;                ///< least fall of the held-out mean log square
    double of_the_rest;                 ///< least part of what is left held out that a rung takes, `part_taken`
    double lost_in_a_fold;              ///< part of what a rung gains, that it may lose in one fold
    double margin;                      ///< of held-out mean log square, where all that is left is model error
    double rows_of_margin;              ///< the same where all is noise, times rows
    std::span<const PhysicalRange> ranges;
    double far_off;            ///< standard deviations from which on a document's number may be a cause beside others
    double relieved;           ///< squared standard deviations that a common scale takes from a document's numbers
    double beyond_the_others;  ///< multiple of what the document's other numbers are off, for the same
    double worth_telling;      ///< share of the squares from which on a dependence is reported
};

}  // namespace stickslip::gap
