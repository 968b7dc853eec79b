// Pairs of gains against requirements, by either theory. Internal to analysis/design.
#pragma once
#include "analysis/boundary/nearest.h"
#include "analysis/boundary/optimise.h"
#include "analysis/design/design.h"

#include <array>

namespace stickslip {

inline constexpr int demand_count = 3;
inline constexpr std::array<const char*, demand_count> demand_names{"margin", "effort_limit", "least_velocity"};

/// How far a choice is from each demand, in logarithms: ≤ 0 where met; −infinity where nothing is demanded.
using Violations = std::array<double, demand_count>;

class Judge {
  public:
    Judge(const Joint& joint, const Requirements& requirements, Curve::Kind theory);

    /// The pair at a point of the search's plane, (ln k_p, asinh(k_v/unit)).
    const GainChoice& at(const std::vector<double>& t);
    /// The same with every direction searched for the margin.
    GainChoice thorough(double k_p, double k_v);
    Violations violations(const GainChoice& choice) const;

    Bounds bounds() const;
    std::vector<double> place_of(double k_p, double k_v) const;
    int evaluations() const { return evaluations_; }
    const Requirements& requirements() const { return requirements_; }
    double reach() const { return reach_; }
    double steady_effort() const { return steady_effort_; }

  private:
    GainChoice judged(double k_p, double k_v, bool thoroughly);
    double least_velocity(Joint joint) const;

    Joint joint_;
    Requirements requirements_;
    Curve::Kind theory_;
    std::vector<Coordinate> coordinates_;
    std::vector<double> direction_;  ///< of the last margin: neighbours have similar ones
    GainRange range_;
    double reach_ = 1, damping_unit_ = 1, velocity_ = 0, steady_effort_ = 0;
    std::vector<double> last_place_;
    GainChoice last_;
    int evaluations_ = 0;
};

}  // namespace stickslip
