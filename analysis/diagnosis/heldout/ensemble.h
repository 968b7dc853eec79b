// What noise alone does: repeated noisy simulations of one joint along one record.
#pragma once
#include "analysis/diagnosis/search/attribute.h"
#include "analysis/results/diagnosis.h"

#include <optional>

namespace stickslip::gap {

/// Misfits that a true joint would have: noisy closed-loop runs of it, judged exactly like the record.
struct NoiseSpread {
    std::array<std::vector<Misfit>, levels.size()> mean, deviation;  ///< per level, per record
    bool simulated = false;  ///< false without a reference: the innovation's own floor is all there is
};
NoiseSpread spread_of(const std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si,
                      int runs, const ParallelFor& parallel);

/// Whether misfits are no larger than a true joint's. `levels_used` counts from the fastest.
bool within(const NoiseSpread& spread, const std::array<Evaluation, levels.size()>& evaluation,
            std::size_t levels_used);

/// Whether noisy closed-loop runs of the joint differ from every record, in every signal, by no more than among
/// themselves: then nothing is left to explain, however badly a fed-back prediction does.
bool closed_loop_at_floor(const std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si,
                          const ParallelFor& parallel);

/// Mean squares over a record's rows of the difference between the record and noisy runs of a joint, and between the
/// runs.
struct SignalSquares {
    std::string signal, unit;
    double difference = 0, floor = 0;
    double rows = 0;  ///< that these are means over
};

/// How a command is counted: what drives an effort source as the effort that it asks for, whatever its own unit; a
/// motor's drive as it is.
struct CommandUnit {
    double factor = 1;
    std::string unit;  ///< N | N·m | V | "1" for a duty cycle
};
CommandUnit command_unit(const Joint& joint);

/// One entry a logged signal (position, command, effort). Rows outside [from, to) are left out, and those that are
/// marked as not judged. Without a reference the
/// slow observer's prediction stands in for the closed loop, and the names say so.
std::vector<SignalSquares> compare(const Case& c, const Joint& joint, int runs, double from, double to,
                                   Trace* first = nullptr);

/// Floors of what `compare` gave no lower than the coarse steps of this joint's encoder make two joints differ that
/// move alike: twice the mean square by which its simulation differs from one with the finer steps. Whatever the
/// controller makes of a step is in it.
void raise_floor_to_steps(const Case& c, const Joint& joint, double finer, std::vector<SignalSquares>& squares);

}  // namespace stickslip::gap
