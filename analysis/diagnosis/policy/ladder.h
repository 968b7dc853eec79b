// What decides the rungs of a ladder of causes: what documents are off by, what numbers a joint can have, and what
// a rung must gain (ladder/, heldout/, fit/).
#pragma once
#include "analysis/diagnosis/policy/rules.h"

#include <array>

namespace stickslip::gap::policy {

/// Standard deviation of each documented parameter, as a part of it: catalogue values, CAD masses and single-run
/// identifications have errors of a few per cent; identified friction is the least certain and differs from day to day.
inline constexpr CorrectionPrior correction_prior{
    /// Of an inertia. Reason: CAD masses and single-run identifications have errors of this size. Evidence: only that
    /// of the blind cases: in the dirty ones inertias of the joint file are 2-10 % off.
    .inertia = 0.04,
    /// Of the Coulomb level. Reason: identified friction is less certain than an inertia. Evidence: only that of the
    /// blind cases: in the dirty ones it is 2-10 % off.
    .coulomb = 0.05,
    /// Of the viscous friction. Reason: it is the least certain, since it depends on the temperature. Evidence: only
    /// that of the blind cases: in the dirty ones it is 2-10 % off.
    .viscous = 0.08,
    /// Of the Coulomb level, from record to record. Reason: friction differs from day to day. Evidence: only that of
    /// the blind cases: in the dirty ones the level of one joint differs by 3-10 % between records.
    .coulomb_of_record = 0.03,
    /// Of a constant load that is not documented, as a part of the Coulomb level. Reason: a cable or a seal is in no
    /// document. Evidence: a measured ball screw (EMPS) has 15 %, three of these; in 41 dirty joints without such a
    /// load none was found beyond 0.6 of them.
    .load = 0.05,
    /// Of gravity. Reason: mass times lever, as an inertia is mass times lever squared. Evidence: only that of the
    /// blind cases: in the dirty ones gravity amplitudes are 2-10 % off.
    .gravity = 0.04,
    /// Part of the usual effort that every documented friction counts at least. Reason: a friction that is documented
    /// as zero is not exactly zero. Evidence: of 94 documented numbers in 23 other cases and in tests none is below
    /// 0.08 of it.
    .least = 0.02,
    /// Of ripple, asymmetry, drift and a Stribeck peak, as a part of the Coulomb level. Reason: ripple of gears and
    /// windings, asymmetry and warm-up of a per cent or two are in no data sheet. Evidence: only that of the blind
    /// cases: in the dirty ones ripple, asymmetry and drift are 0.3 to 3 % of the Coulomb level, and cogging up to 2 %.
    /// A cogging of 1.7 % took 8 % of a gap (`least_against_corrections`); a peak of 1.5 % took 0.05 % beside a ripple.
    .small_term = 0.02,
    /// Standard deviations at which these distributions are cut off. Reason: a parameter beyond is a cause, not a
    /// correction. Evidence: only that of the blind cases: documents of the dirty ones are at most 2.5 of them off, 10
    /// % of an inertia.
    .widest = 3,
};

/// Physical ranges of parameters: a cause with a parameter outside its range has no rung.
inline constexpr std::array physical_ranges{
    /// Evidence: two encoders of other cases whose scale is wrong are at 1.06 and 1.12. In three others, where
    /// something else is wrong, the search came to 0.57 to 0.8. Units differ by more than either end, slipping wheels
    /// by less.
    PhysicalRange{"sensor-offset", "scale", 0.8, 1.25, Per::scale,
                  "lines and gear teeth are counted: a scale is wrong by a slipping wheel or a unit, not by a half"},
    /// Evidence: a drag with the square of the speed was a viscous slope and a Stribeck peak in the place of a Coulomb
    /// level of 0.2 % of its document; wrong documents in other cases are wrong by a factor of three at most.
    PhysicalRange{"coulomb-level", "change", -0.95, 1e9, Per::coulomb,
                  "what slides dry keeps a level: one that vanishes is another curve's, a peak or a slope"},
    /// Evidence: three sources of other cases have 0.25, 0.43 and 0.46 of the winding.
    PhysicalRange{"supply-sag", "resistance", 0, 3, Per::winding,
                  "a source weaker than a third of the motor could not run it (maximum power at equal resistances)"},
    /// Evidence: the published effects, at most 0.07 of the friction; the end is about four times that.
    PhysicalRange{"frictional-memory", "A", 0, 0.25, Per::coulomb,
                  "direct effects of 0.005-0.02 beside friction of 0.3-0.7 are published for rock, metal, paper and "
                  "plastics (Dieterich 1979, Heslot 1994, Marone 1998), ten times that for no surface"},
    /// Evidence: as that of A.
    PhysicalRange{"frictional-memory", "B", 0, 0.25, Per::coulomb, "as A: they differ by less than either"},
    /// Definition: one step, or the noise, of the encoder is what it resolves.
    PhysicalRange{"frictional-memory", "L", 1, 1e9, Per::reading,
                  "a slip below the encoder resolution is invisible: such an effect depends on the time at rest"},
    /// Definition: one step, or the noise, of the encoder is what it resolves.
    PhysicalRange{"backlash", "width", 1, 1e9, Per::reading,
                  "backlash below the encoder resolution is invisible: what wants it is a spring"},
    /// Definition: what repeats has two periods.
    PhysicalRange{"periodic-disturbance", "frequency", 2, 1e9, Per::period_of_record,
                  "less than two periods are a drift, not a period"},
    /// Definition: what repeats within the travel has one period in it.
    PhysicalRange{"cogging", "periods", 1, 1e9, Per::period_of_travel,
                  "a wave that does not repeat within the travel is a slope or gravity: what wants fewer periods "
                  "stands at this bound"},
    /// Definition: what repeats within the travel has one period in it.
    PhysicalRange{"position-dependent-friction", "periods", 1, 1e9, Per::period_of_travel,
                  "a wave that does not repeat within the travel is a trend"},
};

/// What decides the rungs of a ladder of causes.
inline constexpr LadderRules ladder{
    .prior = correction_prior,
    /// numerical: causes of a ladder at most. No record of one joint has distinguished more, and each more is a search
    /// of its own.
    .most_rungs = 4,
    /// numerical: causes that get a first look beside the corrections, the best of the search without corrections. The
    /// catalogue has 31 effects in some forms each.
    .first_look = 40,
    /// numerical: causes that go on from that look to be held out. In 33 of 37 dirty cases the right one was first even
    /// without corrections.
    .finalists = 5,
    /// Held-out mean log square that a rung must gain. Reason: less is a hundredth of the RMS. Evidence: of 90 gains
    /// beyond the margin, in five other cases and in tests, none is below 0.07; where more than noise is left the
    /// margin itself is larger (`margin`).
    .worth_a_rung = 0.02,
    /// Part of what remains (`part_taken`) that a rung must take. Reason: an imperfect form of another cause leaves
    /// more. Evidence: of 186 values in 21 other cases none lies between 0.071 and 0.37.
    .of_the_rest = 0.15,
    /// Part of its gain that a rung may lose in one fold. Reason: a limit that one step reaches does nothing elsewhere.
    /// Evidence: of 345 values in nine other cases and in tests none is above -0.37: no fold lost anything. It was set
    /// for one case with such a limit.
    .lost_in_a_fold = 0.25,
    /// Held-out mean log square by which rivals differ to be distinguished where all that is left is model error.
    /// Reason: closer rivals differ by model error, 7 % of the RMS. Evidence: with 0.07 and with 0.28 four other cases,
    /// none of which has a near rival, keep their answers. Over it the odds fall by e, so that it scales the
    /// probability of every ladder.
    .margin = 0.14,
    /// The same where all is noise, times rows. Reason: four readings of 15 rows each (`rows_per_reading`). Evidence:
    /// with 30 and with 120 the same four cases as of `margin` keep their answers. As that, it scales probabilities.
    .rows_of_margin = 60,
    .ranges = physical_ranges,
    /// Standard deviations from which on a documented parameter may be a cause beside others. Reason: one document in
    /// twenty is so far off in a given parameter. Evidence: values lie on both sides (of 170 in 48 other cases and in
    /// tests the nearest are 1.96 and 2.1), so that no gap supports it; with 1 and with 4 four other cases keep their
    /// answers.
    .far_off = 2,
    /// Squared standard deviations that a common scale must take from a document's parameters. Reason: of two that are
    /// `far_off`. Evidence: values lie on both sides (of 218 in other cases and in tests 11 within a factor of two, the
    /// nearest 7.8 and 8.1), so that no gap supports it. It decides which scales are tried; held-out rows decide which
    /// is named.
    .relieved = 8,
    /// Multiple of what the document's other parameters are off by, from which on one is far off. Reason: errors of one
    /// document are alike; three inertias beside causes were a cause of their own. Evidence: of five values in one
    /// other case and in tests none lies between 3 and 110.
    .beyond_the_others = 5,
    /// Share of the squares from which on a dependence of the remainder on a signal is reported. Reason: below, it is
    /// the scatter of blocks, not a dependence. Evidence: values lie on both sides (of 427 in 54 other cases the
    /// nearest are 0.097 and 0.109), so that no gap supports it. It decides which signals are told beside a remainder,
    /// and no name.
    .worth_telling = 0.1,
};

/// Least mean square of a held-out window that counts, in squares of the prediction floor. Reason: a joint at rest
/// between two steps of its encoder is predicted to any number of digits by whatever holds it at rest, and the
/// logarithm of nothing outweighs all motion; a documented noise is less than three times too high. Evidence: on a
/// hobby servo with its motor off for three quarters of two records a drift gained 7.0 of mean log square there and
/// 0.03 to 0.15 in the other two folds, and hid the load-dependent friction, which took twice as much of the squares.
inline constexpr double least_square_of_window = 0.1;
/// Squares of what the corrections are off by, in standard deviations of their priors, by which corrections without the
/// causes exceed those with them, from which on they stand in for the causes: these are then compared with the
/// corrections that belong to them. Reason: exp(-6/2) are odds of one to twenty against such a joint file. Evidence: a
/// load-dependent friction was explained to 99.8 % by a Coulomb level at the end of its prior with all records another
/// 1.4 standard deviations above it (a sum of 17), and was `unknown`.
inline constexpr double standing_in = 6;
/// Held-out mean log square that a ripple, a cogging or a drift of every machine (`small_term`) must gain, and gain in
/// every fold, to be fitted as a correction; a wave must repeat within the travel (physical ranges). Reason: three
/// parameters gain that much from noise (`price_of_parameter`); a term that pays only where it was fitted, or a wave
/// that is a bend, takes over a part of what the parameters of the cause explain. Evidence: beside the asymmetric
/// friction of a measured ball screw a ripple of 0.8 periods of the travel, not held out, moved a viscous slope from
/// 165 to 172 N·s/m (published 167) and half the difference of the slopes from 37.3 to 34.5 (published 36.9).
inline constexpr double worth_a_small_term = 0.01;
/// Part of the mean square above the prediction floor that still counts as noise. Reason: two integrators differ, and a
/// documented noise is slightly off. Evidence: with it and `deviations_of_floor` none of 300 joints without an effect
/// raised an alarm (docs/validation.md).
inline constexpr double slack_of_floor = 0.06;
/// Standard deviations of repeated simulations that still count as noise. Reason: a statistic of few runs exceeds three
/// of them now and then. Evidence: with it and `slack_of_floor` none of 300 joints without an effect raised an alarm
/// (docs/validation.md).
inline constexpr double deviations_of_floor = 4;
/// Distance to the end of a range, as a part of it, within which a parameter is at its bound. Reason: a parameter at a
/// bound comes from the search, not from the joint. Evidence: of 13,537 values in 54 other cases none lies between
/// 0.000021 and 0.0026.
inline constexpr double beside_bound = 0.001;
/// Part of the largest deviation that a correction may have (`widest`) within which it is at its bound. Reason: a
/// descent may end just inside. Evidence: of 65 corrections that the tests of the ladder look at, those at their bound
/// stand at it to the last digit, and the nearest other at 0.90 of it.
inline constexpr double inside_bound = 0.01;
/// Ratio of mean squares by which closed-loop simulations may exceed their own spread. Reason: the spread of so few
/// runs (4) is not known better. Evidence: in other cases, of 243 ratios none lies between 1.24 and 1.28.
inline constexpr double slack_of_runs = 1.25;
/// Part of the span up to which the spread of simulations of one joint counts as noise. Reason: an unstable or chaotic
/// simulation differs from itself by a large part of the motion, and any record would be within its spread. Evidence:
/// of 508 values in 117 other cases none is above 0.00092.
inline constexpr double own_part = 0.02;
/// Standard deviations of a reading up to which the same spread counts as noise whatever its part of the span. Reason:
/// a joint that hardly moves has a small span. Evidence: of five values in three other cases none is above 0.94; in all
/// others `own_part` of the span is more.
inline constexpr double own_readings = 20;
/// Penalty of score for each parameter. Reason: a parameter that fits only noise gains less in thousands of rows.
/// Evidence: with half of it and with twice of it eight other cases keep verdict and names.
inline constexpr double price_of_parameter = 0.003;
/// Margins of a ladder (`margin`) by which a set of causes must be worse to be no rival. Reason: its odds are e⁻⁴ =
/// 0.02. Evidence: values lie on both sides (of 142 in 17 other cases and in tests the nearest are 3.9 and 4.1), so
/// that no gap supports it. It decides which rivals are fitted once more; what it leaves out has less than 0.02.
inline constexpr double out_of_question = 4;
/// numerical: margins by which a set of causes must be worse than the best, with numbers that have seen the held-out
/// rows, for its folds not to be fitted. Its odds are below e⁻⁸ = 0.0003, which no answer shows, and rows that it has
/// not seen would make it worse. More of them cost time.
inline constexpr double out_of_sight = 8;
/// Part of what an effect takes off in a record that is held out, below which the others hardly show it: thirds of that
/// record are held out in its place. Reason: what is not in the other records cannot be fitted to them. Evidence: of
/// 333 values in 47 other cases none lies between 0.05 and 0.12.
inline constexpr double hardly_in_others = 0.1;

}  // namespace stickslip::gap::policy
