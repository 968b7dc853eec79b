// Fits an edit of the joint to records by prediction errors: how well, at which parameters, how surely.
#pragma once
#include "analysis/diagnosis/fit/effect.h"
#include "analysis/diagnosis/plant/simulator.h"

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace stickslip::gap {

/// A record ready to be fitted: on its clock, with the joint that held in it and its noise.
struct Case {
    Ticks ticks;
    Joint joint;                         ///< nominal, after what the controller audit has settled
    double sigma = 1;                    ///< standard deviation of a reading, quantisation included
    double effort_sigma = 0;             ///< of a measured effort; 0: effort is not judged
    double drive_sigma = 0;              ///< of a measured effort that drives the joint
    std::array<double, 3> load_sigma{};  ///< RMS of a prediction by what a known load is wrong by, at each of `levels`
    std::vector<double> controller_error;  ///< of that effort, less what the documented controller asks for, each row
    std::size_t number = 0;                ///< of the record among all: which own parameters are its
    double row_step = 1e-3;                ///< s between two readings
    std::vector<double> temperature;       ///< °C at every tick; empty: not logged
    bool supply_logged = false;
    bool noise_documented = true;                      ///< the documented sensor sets the floors
    double skip_from = infinity, skip_to = -infinity;  ///< s; rows held out of the fit
    double step_factor = 1;                            ///< longer time steps for a first look
    bool judged(std::size_t tick) const
    {
        return !(ticks.time[tick] >= skip_from && ticks.time[tick] < skip_to) &&
               (ticks.judged.empty() || ticks.judged[tick]);
    }
};

/// Of all records together.
inline double rows_of(const std::vector<Case>& cases)
{
    std::size_t rows = 0;
    for (const auto& c : cases) rows += c.ticks.rows();
    return static_cast<double>(rows);
}

/// Bandwidths of the observer, rad/s: the horizons over which a prediction has to hold (9, 20 and 50 ms, in 1/ω).
inline constexpr std::array<double, 3> levels{110, 50, 20};  // numerical: every judgement is made at all of them
/// A slower one, rad/s (83 ms): what builds up over many rows, where the loop as a whole is not simulated.
inline constexpr double slow_observer = 12;  // numerical: as the levels

/// Errors of a model hang together for about so many seconds, which are one block of the objective and one reading.
inline constexpr double block_time = 0.2;  // numerical: s

/// Some effects together, each in one of its forms.
struct Candidate {
    std::vector<const Effect*> effects;
    std::vector<const EffectForm*> forms;
    std::size_t records = 1;  ///< how many records have parameters of their own
    /// Standard deviations of a prior around "as documented", as fitted; of the first parameters, 0: none.
    std::vector<double> prior_sd = {};
    double prior_weight = 0;  ///< of a squared standard deviation against the objective; 0: priors are not looked at
    double sd_of(std::size_t i) const { return i < prior_sd.size() ? prior_sd[i] : 0; }
    /// Parameters of one form: shared ones, own ones of record 0, of record 1, …
    std::size_t count_of(const EffectForm& f) const { return f.parameters.size() + f.own * (records - 1); }
    std::size_t parameter_count() const
    {
        std::size_t n = 0;
        for (const auto* f : forms) n += count_of(*f);
        return n;
    }
    static const EffectParameter& parameter_of(const EffectForm& f, std::size_t i)
    {
        const std::size_t shared = f.parameters.size() - f.own;
        return f.parameters[i < shared ? i : shared + (i - shared) % f.own];
    }
    const EffectParameter& parameter(std::size_t i) const
    {
        for (const auto* f : forms) {
            if (i < count_of(*f)) return parameter_of(*f, i);
            i -= count_of(*f);
        }
        return forms.back()->parameters.back();
    }
    /// Whether the misfit is jagged in this parameter.
    bool is_rough(std::size_t i) const
    {
        for (const auto* f : forms) {
            if (i < count_of(*f)) return f->rough;
            i -= count_of(*f);
        }
        return false;
    }
    bool applies(const Joint& nominal) const
    {
        for (const auto* f : forms)
            if (f->applies && !f->applies(nominal)) return false;
        return true;
    }
};

/// Parameters in SI from what the fit works with (scaled, logarithms where the effect says so), kept within bounds.
std::vector<double> in_si(const Candidate& candidate, const Eigen::VectorXd& x, const Scales& scales);
/// From units of each parameter's scale to what the fit works with.
Eigen::VectorXd to_fit(const Candidate& candidate, const std::vector<double>& scaled);
/// The joint with the candidate's edits, as they hold in the record of this number.
Joint edited(const Joint& joint, const Candidate& candidate, const std::vector<double>& si, std::size_t record);

/// The same, as the simulation takes it; only here do unmodelled forces take part.
Plant edited_plant(const Joint& joint, const Candidate& candidate, const std::vector<double>& si, std::size_t record);

/// The prediction floor: standard deviation of a reading's noise that would leave the innovation of a true joint,
/// before the observer amplifies it (noise_amplification). It is the encoder's own, and what the noise of a measured
/// effort that drives it, or the error of a known load, makes of its motion.
double reading_floor(const Case& c, double omega);

/// Standard deviation of the effort's innovation in a true joint: the sensor's own noise, and in a motor the back-EMF
/// of the velocity that the encoder's noise makes in the observer.
double effort_floor(const Case& c, double omega);

/// Least mean squares over the floor that count: noise, or what stood still and has no logarithm.
inline constexpr double noise_square = 1, exact_square = 1e-12;  // numerical: arguments of a logarithm

/// How far predictions are from one record at one level: mean squares over their prediction floors, 1 where only noise
/// remains.
struct Misfit {
    double position = 0;
    double effort = 1;  ///< 1 where effort is not judged
    /// The same block by block of 200 ms, the last one shorter, if it is.
    std::vector<double> position_blocks = {}, effort_blocks = {};
};

/// A joint's misfit in every record at one level, and the robust objective that fits minimise: Σ over 200 ms blocks of
/// log(1 + mse/20), because one lost step would swamp a plain mean.
struct Evaluation {
    double objective = 0;
    std::vector<Misfit> records;
};

/// What the priors of a candidate's parameters add to the objective of its fits.
double prior_cost(const Candidate& candidate, const Eigen::VectorXd& x);

/// `residuals`, when given, receives every scaled residual of every record: position rows, then effort rows.
Evaluation evaluate(const std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si,
                    double omega, std::vector<double>* residuals = nullptr);

/// The same at several places at once, each at its level, or all at one: cheaper than one by one.
std::vector<Evaluation> evaluate_all(const std::vector<Case>& cases, const Candidate& candidate,
                                     const std::vector<std::vector<double>>& si, const std::vector<double>& omega);

}  // namespace stickslip::gap
