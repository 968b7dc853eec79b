// One blind test case: a setting, a machine that may differ from its nominal, its records, and the answer.
#pragma once
#include "tests/blind/generate/effects.h"
#include "tests/blind/generate/setting.h"

namespace blind {

/// What is wanted of a case. Empty strings leave the choice to the draw.
struct Wish {
    std::string kind = "mixed";  ///< single | pair | none | outside | noisy | few | mixed
    std::string effect, strength, columns, family;
    std::string controller = "pd";  ///< pd | pid | cascade
    bool dirty = false;             ///< the joint is not quite its document, see dirty.h
    std::string mujoco;             ///< folder of the MuJoCo script; empty: the own mechanism makes the records
};

struct SealedCase {
    std::string kind, strength, verdict;
    std::uint64_t seed = 0;
    Setting setting;
    std::vector<Machine> machines;     ///< the true one of each record
    std::vector<Machine> undisturbed;  ///< the same without its dirt
    std::vector<Record> records;

    std::vector<Edit> edits;
    std::vector<std::string> effects, equivalent;
    std::string outside;
    double explained_by_catalogue = 0;  ///< of a cause outside it
    std::vector<Parameter> parameters;
    double wanted = 1;                ///< the gap that was aimed at, in floors
    std::vector<double> gap_without;  ///< of a pair: what remains when one effect is left out, in floors
    Gap gap;
    double gap_of_dirt = 0;          ///< what the joint without its effects leaves, in floors
    std::vector<std::string> forms;  ///< that are not the catalogue's
};

/// Names of ranges of the gap, in floors; ascending.
inline const std::vector<std::pair<std::string, std::pair<double, double>>> strengths = {
    {"weak", {2, 4}}, {"medium", {4, 10}}, {"strong", {10, 30}}};

/// Makes case `index` of the stream `seed`. Cases walk through the whole catalogue in an order that the seed decides.
/// Throws std::runtime_error if many draws were all unusable.
SealedCase make_case(const Wish& wish, std::uint64_t seed, int index);

}  // namespace blind
