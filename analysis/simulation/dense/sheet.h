// Motions that vary smoothly over a map: rows of one kind, and the regular quantities that their numbers are made of.
// Internal to analysis/simulation/dense.
#pragma once
#include "analysis/results/point.h"

#include <cstddef>
#include <optional>
#include <span>

namespace stickslip::dense {

/// What the linear theory and the joint say about the place of a row.
struct Place {
    double velocity = missing;    ///< of steady sliding
    double deflection = missing;  ///< |δ_ss|
    double growth = missing;      ///< of a small disturbance
    double peak = missing;        ///< of a small disturbance that decays, per deflection; not set: only motions show
};

/// What rows must share for one smooth function to run through their numbers.
struct Kind {
    bool regular = false;  ///< such functions exist: a decided outcome that is sliding or a plain cycle
    bool grows = false;    ///< small disturbances do, by the linear theory
    Outcome outcome = Outcome::not_asked;
    bool bistable = false;
    bool rests = false;                         ///< the cycle has a share of its period at rest or near it
    bool stops = false;                         ///< its least velocity is 0 and not only small
    bool measured = false, overshoots = false;  ///< has a growth rate, a peak

    bool operator==(const Kind&) const = default;
    bool cycles() const { return bistable || outcome != Outcome::stable_sliding; }
};
Kind kind_of(const PointResult& row);

/// The verdict as one number: what must be the same at neighbours, or both are computed.
std::uint8_t verdict_of(const PointResult& row);

/// How the quantities are made regular.
enum class Form {
    plain,
    square_root  ///< the amplitude vanishes as the square root of the growth, as beyond a supercritical Hopf point
};

/// The regular quantities of rows of one kind.
class Sheet {
  public:
    Sheet(const Kind& kind, Form form) : kind_(kind), form_(form) {}

    std::size_t quantities() const;
    /// Whether the numbers follow from the linear theory's growth: a kink there is one here.
    bool follows_growth(const Place& place) const;
    /// The quantities of a computed row of this kind.
    void take(const PointResult& row, const Place& place, std::span<double> quantity) const;
    /// Fills the nonlinear fields of a row whose linear ones stand.
    void give(std::span<const double> quantity, const Place& place, PointResult& row) const;

  private:
    Kind kind_;
    Form form_;
};

/// How far two rows of one kind differ: numbers by their ratio, the least velocity by its logarithm per e-folds from
/// V_0, the share at rest by itself. The largest of these; infinite where one is missing.
double difference(const PointResult& interpolated, const PointResult& computed, const Place& place);

/// Whether an interpolated row is of that kind beyond doubt, its least velocity `margin` away from what counts as rest.
bool surely(const Kind& kind, const PointResult& interpolated, const Place& place, double margin);

}  // namespace stickslip::dense
