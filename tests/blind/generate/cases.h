// One sealed case: a nominal joint, a machine that may differ from it, its records, and the answer.
#pragma once
#include "tests/blind/generate/effects.h"
#include "tests/blind/generate/gap.h"
#include "tests/blind/generate/nominal.h"

#include <map>
#include <optional>

namespace blind {

/// Which columns a case writes.
struct Columns {
    std::string name = "full";
    bool reference_position = true, reference_velocity = true, velocity = true, command = true, effort = true,
         supply = false;
};

/// What is wanted of a case. Empty strings leave the choice to the draw.
struct Wish {
    std::string kind = "mixed";  ///< single | pair | none | outside | noisy | few | mixed
    std::string effect, strength, columns, family;
    std::string mujoco;  ///< folder of the MuJoCo script; empty: the own mechanism makes the records
};

struct SealedCase {
    std::string kind, strength, verdict;
    std::uint64_t seed = 0;
    Nominal nominal;
    std::vector<Machine> machines;  ///< the true one of each record
    std::vector<Excitation> excitations;
    std::vector<Record> records;
    int stride = 1;
    Columns columns;
    bool noise_stated = true;

    std::vector<Edit> edits;
    std::vector<std::string> effects, equivalent;
    std::string outside;
    std::vector<Parameter> parameters;
    double wanted = 1;                ///< the gap that was aimed at, in floors
    std::vector<double> gap_without;  ///< of a pair: what remains when one effect is left out, in floors
    Gap gap;
};

/// Names of ranges of the gap, in floors; ascending.
inline const std::vector<std::pair<std::string, std::pair<double, double>>> strengths = {
    {"weak", {2, 4}}, {"medium", {4, 10}}, {"strong", {10, 30}}};

/// Makes case `index` of the stream `seed`. Cases of kind "single" walk through the whole catalogue in an order that
/// the seed decides.
SealedCase make_case(const Wish& wish, std::uint64_t seed, int index);

/// The signals that a simulation of the closed loop predicts and that the columns show.
std::vector<Signal> compared_signals(const Machine& machine, const Columns& columns);

}  // namespace blind
