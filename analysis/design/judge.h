// Pairs of gains against requirements, by either theory. Internal to analysis/design.
#pragma once
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/design/design.h"
#include "analysis/numerics/optimise.h"

#include <array>
#include <functional>
#include <map>
#include <utility>

namespace stickslip {

inline constexpr int requirement_count = 3;
inline constexpr std::array<const char*, requirement_count> requirement_names{"margin", "effort_limit",
                                                                              "least_velocity"};

/// How far a choice is from each requirement, in logarithms: ≤ 0 where met; −infinity where nothing is required.
using Violations = std::array<double, requirement_count>;

/// What one verdict takes: of a real loop its eigenvalues, a hundred times as long as of a mass in the ideal loop, and
/// of delayed friction counts of roots, ten times as long again.
enum class VerdictCost { small, eigenvalues, counts };

class Judge {
  public:
    Judge(const Joint& joint, const Requirements& requirements, Curve::Kind theory);

    /// The same judge with another margin; it remembers what was judged.
    Judge with_margin(double margin) const;

    /// The pair at a point of the search's plane, (ln k_p, asinh(k_v/unit)). Each is judged once.
    const GainChoice& at(const std::vector<double>& t);
    /// The same with every direction searched for the margin.
    GainChoice thorough(double k_p, double k_v);
    /// Looks in many more directions at the place. Where the margin is smaller than it was thought, its direction is
    /// looked along at every place from now on, those judged before included; true then. Adding what was overlooked
    /// until nothing is follows A. Mutapcic & S. Boyd, Optim. Methods Softw. 24 (2009) 381-406.
    bool learns_at(const std::vector<double>& t);
    Violations violations(const GainChoice& choice) const;
    /// Of the places judged so far the one with the least `value`, exactly so where that does not rise with the margin.
    /// Empty if none.
    std::vector<double> best_known(const std::function<double(const GainChoice&)>& value);

    Bounds bounds() const;
    std::vector<double> place_of(double k_p, double k_v) const;
    int evaluations() const { return evaluations_; }
    const Requirements& requirements() const { return requirements_; }
    VerdictCost cost() const { return cost_; }
    double reach() const { return reach_; }
    double steady_effort() const { return steady_effort_; }

  private:
    struct Judged {
        GainChoice choice;
        std::size_t looked_along;  ///< of the overlooked directions, the first so many
    };
    const GainChoice& up_to_date(Judged& known);
    std::pair<double, double> gains_at(const std::vector<double>& t) const;
    NearestBoundary nearest(double k_p, double k_v, NearestOptions options) const;
    /// Where verdicts are costly: the directions in which boundaries are near over the range of gains, which alone are
    /// looked along until learns_at() finds another.
    void learn_directions();
    NearestOptions affordable() const;
    GainChoice judged(double k_p, double k_v, double margin, bool thoroughly) const;
    double least_velocity(Joint joint) const;
    double reach_for(double margin) const;

    Joint joint_;
    Requirements requirements_;
    Curve::Kind theory_;
    std::vector<Coordinate> coordinates_;
    std::vector<std::vector<double>> overlooked_;  ///< directions
    std::vector<double> direction_;                ///< of the last margin: neighbours have similar ones
    GainRange range_;
    double reach_ = 1, damping_unit_ = 1, velocity_ = 0, steady_effort_ = 0;
    double effort_gain_ = 1;  ///< effort per command of a real loop
    VerdictCost cost_ = VerdictCost::small;
    std::map<std::vector<double>, Judged> judged_;
    mutable int evaluations_ = 0;
};

}  // namespace stickslip
