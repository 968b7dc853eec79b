// One point of a sweep: plain numbers only, written once into its slot, journalled as bytes, and a row of results.nc.
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "analysis/results/quantity.h"
#include "analysis/results/stability_map.h"

namespace stickslip {

/// Why a number of a point is missing or a verdict undecided; `none` where nothing is.
enum class Reason : std::uint8_t {
    none,
    no_velocity,       ///< neither control.V0 nor control.force_rate is set
    law_needs_motion,  ///< the law has no meaning at this velocity
    no_steady_state,   ///< friction at the commanded velocity is not a finite number
    not_finite,        ///< a parameter or an intermediate result overflowed
    linear_only,       ///< the law is linear by definition: no nonlinear outcome exists
    not_converged,     ///< slow dynamics: the limit of work was reached before the outcome showed itself
    solver_failed,     ///< reference and fallback solver both gave up
    unsupported,       ///< this combination of law and joint has no evaluation
    neutral,           ///< nothing damps the joint: small disturbances neither grow nor decay, and none decides
    diverges,          ///< the motion runs away from steady sliding
    limit_too_low,     ///< the limit of the effort is below what steady sliding takes somewhere: there is none
    impossible         ///< numbers that break a rule between keys together: the joint file would be refused
};

/// What the nonlinear joint does after the stated disturbance.
enum class Outcome : std::uint8_t {
    not_asked,
    stable_sliding,
    stick_slip,
    limit_cycle,
    reversal,
    period_n,
    irregular,
    undecided,
    linear_only,
    solver_failure,
    held  ///< at rest for ever: limits leave less effort than breaks its static friction
};

/// Which method decided the outcome; `steps` is the method of steps, for delayed friction, `ticks` the real
/// loop, followed tick by tick; `interpolation` followed nothing: neighbours decided, and checks among them.
enum class DecisionPath : std::uint8_t { none, lanes, cvode, shooting, steps, ticks, interpolation };

inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Beyond yes (1) and no (0): a row with a reason has no verdict; neutral sliding has a root on the imaginary axis and
/// none right of it, so that small disturbances neither decay nor grow.
inline constexpr std::uint8_t verdict_missing = 2, verdict_neutral = 3;

struct PointResult {
    // linear theory
    double k_v_min = missing;            ///< least velocity gain that the velocity-only theory requires
    double spectral_abscissa = missing;  ///< max Re s of the joint with memory
    double k_cr = missing;               ///< critical position gain; NaN where no single one exists
    double omega = missing;              ///< frequency at the critical gain
    Region region = Region::undecided;
    std::uint8_t velocity_only_stable = verdict_missing;  ///< 0, 1, verdict_missing or verdict_neutral
    std::uint8_t state_variable_stable = verdict_missing;
    Reason reason = Reason::none;
    // nonlinear joint
    Outcome outcome = Outcome::not_asked;
    DecisionPath path = DecisionPath::none;
    double growth_rate = missing;
    double amplitude = missing;  ///< of the limit cycle in position, half peak to peak
    double velocity_min = missing, velocity_max = missing;
    double period = missing;
    double stick_fraction = missing;  ///< share of the period spent at rest or below a hundredth of V_0
    double overshoot = missing;       ///< largest excess of position over the steady path, per steady deflection
    double interpolation_error = 0;   ///< of an interpolated row, as its cell's checks saw it; 0: it was computed
};

/// A column of results.nc. Exactly one of `number` and `code` is set; a code has its meanings as CF flag_meanings.
struct Column {
    std::string_view name, long_name;
    Quantity quantity = Quantity::number;
    double PointResult::*number = nullptr;
    std::uint8_t (*code)(const PointResult&) = nullptr;
    void (*set_code)(PointResult&, std::uint8_t) = nullptr;
    std::string_view meanings;  ///< space separated, in the order of the codes
    bool nonlinear = false;     ///< written only when the sweep asks for nonlinear outcomes
};

/// Every column, in the order of the file.
std::span<const Column> columns();

/// The word for a code of a coded column, e.g. code_name("outcome", 1) == "stable-sliding".
std::string_view code_name(std::string_view column, std::uint8_t code);

}  // namespace stickslip
