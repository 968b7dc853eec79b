// What a diagnosis found: plain data, the fields of diagnosis.json by the same names.
#pragma once
#include "analysis/results/cause_set.h"
#include "analysis/results/note.h"
#include "analysis/results/point.h"
#include "analysis/results/quantity.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// Whether model and records differ by more than noise, and whether that is explained: `gap` a cause was found,
/// `no_gap` within noise, `unknown` no cause of the catalogue, `insufficient_data` the records do not decide.
enum class Verdict { gap, no_gap, unknown, insufficient_data };

/// "gap", "no-gap", "unknown" or "insufficient-data".
inline std::string name_of(Verdict v)
{
    switch (v) {
        case Verdict::gap:
            return "gap";
        case Verdict::no_gap:
            return "no-gap";
        case Verdict::unknown:
            return "unknown";
        default:
            return "insufficient-data";
    }
}

/// 95 % unless said otherwise; NaN: none is known.
struct ConfidenceInterval {
    double low = missing, high = missing;  ///< in the unit of its number
};

/// A part of the whole: where along the chain, or in which regime, the gap lies.
struct Share {
    std::string name;             ///< of a signal or a regime
    double share = 0;             ///< within [0, 1]
    ConfidenceInterval interval;  ///< of the share, 95 %
    double rms = 0, floor = 0;    ///< in `unit`; regimes: in multiples of the prediction floor
    std::string unit;             ///< of rms and floor
};

/// A number of an effect as it was fitted.
struct FittedParameter {
    std::string name;                 ///< "stribeck.c2"
    double value = 0;                 ///< in `unit`
    double standard_error = missing;  ///< in `unit`
    std::string unit;                 ///< "N·m", empty for a plain number
};

/// Whether the parameter is one of the effect of this name: the part before its first dot.
inline bool is_of(const FittedParameter& parameter, std::string_view effect)
{
    return std::string_view(parameter.name).substr(0, parameter.name.find('.')) == effect;
}

/// A number of the joint with a cause in it, as a data sheet has it: the level of one direction, not half a difference.
struct SheetValue {
    std::string key;              ///< what files call it: "Coulomb level, positive direction"
    double value = 0;             ///< in `unit`
    ConfidenceInterval interval;  ///< 95 %
    std::string unit;             ///< "N·m", empty for a plain number
    bool pinned = false;          ///< the interval is narrower than the number is large: the records say what it is
};

/// One cause, or a few that act together, with its rank by position.
struct Cause {
    std::vector<std::string> names;            ///< of effects
    std::string form;                          ///< which way of writing it down fitted best, empty where there is one
    double probability = 0;                    ///< that it is the cause, within [0, 1]
    std::vector<FittedParameter> parameters;   ///< of its effects
    std::vector<SheetValue> values;            ///< of the documented numbers that the cause changes
    double heldout_gain = 0;                   ///< 1 − after/before of held-out RMS
    ConfidenceInterval heldout_gain_interval;  ///< 95 %
    double force_gain = missing;               ///< the same for the drive force, see DriveForceGap
    ConfidenceInterval force_gain_interval;    ///< 95 %
    bool signature = false;                    ///< it is in the records
    bool plausible = true;                     ///< its numbers are not at a bound and not out of all proportion
    /// Whose signature that is: effects, `law:` and a friction law among outcomes, `numbers` of documents that are off.
    std::vector<std::string> signatures;
    double misfit = 0;  ///< score of the fit; 0 is noise
};

/// One cause of the ladder, given those above it and with the nuisance parameters refitted on both sides.
struct LadderRung {
    std::vector<std::string> names;                        ///< one, or the audit's findings together
    double share = 0;                                      ///< of the gap's held-out squares beyond the noise
    ConfidenceInterval interval;                           ///< bootstrap over the held-out windows
    std::vector<FittedParameter> parameters;               ///< of its effects
    std::vector<std::vector<std::string>> ambiguous_with;  ///< causes that explain as much in its place
    double probability = 0;                                ///< that it is a cause, within [0, 1]
};

/// A number of the document that was refitted beside the causes: no cause, but worth correcting.
struct Correction {
    std::string name;        ///< "viscous"
    FittedParameter number;  ///< as refitted
    double prior = 0;        ///< standard deviation of what documents usually say, in the number's unit
};

/// What any model of the joint's own signals could explain of the gap on unseen data.
struct ExplainableShare {
    double share = 0;                     ///< of the gap's squares beyond the noise, within [0, 1]
    ConfidenceInterval interval;          ///< of the share, 95 %
    std::vector<std::string> depends_on;  ///< signals on which what the corrected joint lacks depends, strongest first
};

/// What the ladder leaves, and the signals that it still depends on, strongest first.
struct Remainder {
    double share = 0;                    ///< of the gap's squares beyond the noise, within [0, 1]
    std::vector<std::string> structure;  ///< names of these signals
};

/// RMS difference between measured and simulated signals over held-out records.
struct SignalGap {
    std::string signal, unit;  ///< its column, and what its numbers are in
    double before = 0, after = 0, floor = 0,
           explained = 0;  ///< in `unit`; explained: share of squares beyond the floor
};

/// RMS difference of all signals together, each per its noise floor.
struct OverallGap {
    double before = 0, after = 0, floor = 0, explained = 0;  ///< in multiples of the noise floor
    ConfidenceInterval interval;                             ///< of explained
    double own_floor = 0;  ///< what noisy simulations with the cause differ by; 0: by no more than `floor`

    /// What two true simulations differ by, with the cause.
    double noise() const { return own_floor > floor ? own_floor : floor; }
    /// What the cause leaves of the mean square beyond the noise; above 1 it makes things worse. A cause that is itself
    /// noise, as the steps of an encoder are, makes two true simulations differ by more: that is not held against it.
    double left() const
    {
        const double was = before * before - floor * floor, is = after * after - noise() * noise();
        return is <= 0 ? 0 : is <= was ? is / was : std::numeric_limits<double>::infinity();
    }
    /// Whether the gap is larger with the cause than without.
    bool worse() const { return left() > 1; }
};

/// The force that drives the joint, low-passed, against what the model requires along the measured motion: RMS over
/// held-out data with the nuisance parameters refitted, without and with the first cause. corner 0: not judged.
struct DriveForceGap {
    std::string unit;              ///< of before and after
    double corner = 0;             ///< of the low pass [Hz]
    double before = 0, after = 0;  ///< RMS, in `unit`
};

/// The motion along which two causes differ most.
enum class TestMotion {
    none,
    slow_stroke,      ///< to and fro over the stroke at a fiftieth of the largest speed
    small_sine,       ///< with many reversals
    falling_sine,     ///< its amplitude falls as its frequency rises
    steps_and_rests,  ///< over the whole stroke
    steps_of_speed,   ///< a tenth, a third and the whole of the largest
    rig_step_down,    ///< of the load point, to a tenth of its first speed and back
    rig_step_up,      ///< to ten times
    rig_hold,         ///< at rest between two slides
};

/// The motion that separates the causes that the records could not.
struct NextExperiment {
    TestMotion motion = TestMotion::none;                        ///< none: nothing is left to distinguish
    std::vector<std::pair<std::string, std::string>> separates;  ///< two causes each
    double distance = 0;                  ///< difference of the two predictions, in noise standard deviations
    std::vector<double> time, reference;  ///< the motion itself: s, [m | rad]
};

/// What a record was used for.
struct RecordRole {
    std::string file, role;  ///< its name, and "held-out": every record is, in its turn
};

/// A part of a long record that fits used.
struct FittedStretch {
    std::string file;         ///< of the record
    double from = 0, to = 0;  ///< s
};

/// Which rows of long records were fitted: the others are the held-out data. No stretches: all rows in their turn.
struct FittedRows {
    std::vector<FittedStretch> stretches;  ///< in the order of the records
    double fitted = 0, all = 0;            ///< rows
};

/// Traces of one record for the page: measured, and simulated before and after.
struct DiagnosedTrace {
    std::string file;                                   ///< of the record
    std::vector<double> time, measured, before, after;  ///< s; the others in the unit of what was measured
    std::vector<double> effort_measured, effort_before, effort_after;  ///< in `effort_unit`
    enum class Effort { measured, command, friction_of_rig };
    Effort effort = Effort::command;  ///< what the efforts are
    bool predicted = false;           ///< along the measured motion by a slow observer: no loop could be simulated
    std::string effort_unit;          ///< of the three efforts
};

/// Everything that the report and diagnosis.json say. Boundary numbers are added by who can compute maps.
struct Diagnosis {
    Verdict verdict = Verdict::insufficient_data;          ///< whether there is a gap, and whether it is explained
    std::vector<Note> reasons;                             ///< of the verdict
    bool interrupted = false;                              ///< on request: what was found until then stands here
    std::vector<RecordRole> records;                       ///< fitted and held out
    FittedRows rows;                                       ///< of long records
    std::vector<Share> signals, regimes;                   ///< where along the chain and in which motion the gap lies
    std::vector<Cause> effects;                            ///< most probable first
    std::vector<std::vector<std::string>> ambiguous_with;  ///< causes that explain as much as the first
    std::optional<CauseSet> set;                           ///< where a guarantee was requested
    NextExperiment next_experiment;                        ///< what would distinguish the causes that are left
    std::vector<SignalGap> gap;                            ///< by signal
    OverallGap overall;                                    ///< over all signals
    DriveForceGap drive_force;                             ///< beside the signals
    std::vector<LadderRung> ladder;                        ///< causes that act together, each given those above it
    std::vector<Correction> corrections;                   ///< of documented numbers
    double corrected_share = 0;                            ///< of the gap, that the corrections take
    ExplainableShare ceiling;                              ///< what no model of these signals can exceed
    Remainder remainder;                                   ///< what the best cause leaves of the gap
    std::vector<Note> notes;                               ///< what else a user should know
    std::vector<DiagnosedTrace> traces;                    ///< one a record
    Motion motion = Motion::prismatic;                     ///< of the joint: m and N, or rad and N·m
    double usual_speed = 0;                                ///< 95th percentile of |velocity| in the records
};

/// That none of the listed causes is it: with their probabilities it makes one. NaN where none is listed.
inline double probability_of_none(const Diagnosis& d)
{
    if (d.effects.empty()) return missing;
    double listed = 0;
    for (const auto& cause : d.effects) listed += cause.probability;
    return std::clamp(1 - listed, 0.0, 1.0);
}

}  // namespace stickslip
