// What a candidate leaves of records at several places at once: slopes and trials of a fit are the same records with
// other numbers, which go side by side.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

namespace stickslip::gap {

inline constexpr std::size_t no_parameter = static_cast<std::size_t>(-1);

/// A candidate's parameters, and the level at which it is looked at.
struct Place {
    std::vector<double> si;
    double omega = 0;
    /// The one parameter that differs from the place whose residuals are known; no_parameter: any may.
    std::size_t moved = no_parameter;
};

/// What a fit asks of its records.
struct Question {
    const std::vector<Case>* cases;
    const Candidate* candidate;
    std::vector<Place> places;
    /// So many of the places have to be looked at. The others will be asked next, if all goes well: they are looked at
    /// where they fill lanes that would be empty.
    std::size_t needed = 0;
    /// Whether the others are nearly sure to be asked: then a further pack is made for them, too.
    bool sure = false;
    const std::vector<double>* known = nullptr;
    /// Scaled residuals at every place: of each record the position rows, then the effort rows; empty where it was not
    /// looked at. Where only a parameter has moved that is one record's own, the others' residuals are taken from those
    /// that are known.
    std::vector<std::vector<double>> answers = {};
};

/// Answers some questions together.
void answer(std::span<Question* const> questions);

/// The residuals at every place, for a fit that asks alone.
std::vector<std::vector<double>> residuals_at(const std::vector<Case>& cases, const Candidate& candidate,
                                              const std::vector<Place>& places,
                                              const std::vector<double>* known = nullptr);

/// The misfit that these residuals of all records are.
Evaluation judged(const std::vector<Case>& cases, const std::vector<double>& scaled);

/// Weights of the scaled residuals that make a weighted least-squares step a step on the robust objective.
void block_weights(const std::vector<Case>& cases, const std::vector<double>& scaled, std::vector<double>& weights);

}  // namespace stickslip::gap
