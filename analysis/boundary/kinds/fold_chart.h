// Folds of limit cycles over two parameters: solving for one, judging its error, following it. Internal to
// analysis/boundary.
#pragma once
#include "analysis/boundary/kinds/fold_seed.h"
#include "analysis/boundary/trace/follow.h"

namespace stickslip {

/// Folds over two axes: solving for them, judging their error, following them.
class FoldChart {
  public:
    FoldChart(const Joint& joint, const Axis& x, const Axis& y) : orbits_(joint, {x, y}), system_(orbits_.folds()) {}
    FoldChart(const FoldChart&) = delete;  // the equations refer to the orbits

    int turns() const { return orbits_.turns(); }
    int section() const { return orbits_.section(); }
    UnitPoint place(const CurveState& s) const { return {s.z[section()], s.z[section() + 1]}; }

    /// The fold near a guess with one parameter held (0: x, 1: y).
    std::optional<CurveState> solve(const Eigen::VectorXd& guess, int held) const;

    /// A solved fold as a located point along one of the parameters.
    CurvePoint located(const CurveState& s, bool along_y, double precision) const;

    /// Both ways from a fold to its ends.
    CurvePiece follow(const CurveState& start, const FollowingOptions& options, double precision,
                      std::vector<UnitPoint>& path) const;

  private:
    struct Way {
        std::vector<CurveState> states;
        std::vector<CurvePoint> points;
        CurveEnd end = CurveEnd::lost;
    };
    Way walk(const CurveState& start, const FollowingOptions& options, double precision) const;

    OrbitSystem orbits_;
    CurveSystem system_;
};

}  // namespace stickslip
