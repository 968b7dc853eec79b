// The policy of the diagnosis: every threshold that decides an answer, with its unit, its reason and its evidence.
// Numerical limits stand with their algorithms. A definition needs no evidence: it says what a word of the answer
// means. What numbers are compared with is measured by tests/evidence; "other cases" are 22 of the fifty made by others
// (docs/validation.md).
// In one file: the policy, so that its page can be made from it.
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
    /// Of gravity. Reason: mass times lever, as an inertia is mass times lever squared. Evidence: none yet; chosen.
    .gravity = 0.04,
    /// Part of the usual effort that every documented friction counts at least. Reason: a friction that is documented
    /// as zero is not exactly zero. Evidence: none yet; chosen.
    .least = 0.02,
    /// Of ripple, asymmetry and drift, as a part of the Coulomb level. Reason: ripple of gears and windings, asymmetry
    /// and warm-up of a per cent or two are in no data sheet. Evidence: none yet; chosen. A cogging of 1.7 % of the
    /// Coulomb level took 8 % of a gap (`least_against_corrections`).
    .small_term = 0.02,
    /// Standard deviations at which these distributions are cut off. Reason: a parameter beyond is a cause, not a
    /// correction. Evidence: none yet; chosen.
    .widest = 3,
};

/// Physical ranges of parameters: a cause with a parameter outside its range has no rung.
inline constexpr std::array physical_ranges{
    /// Evidence: none yet; chosen. Units differ by more than either end, slipping wheels by less.
    PhysicalRange{"sensor-offset", "scale", 0.8, 1.25, Per::scale,
                  "lines and gear teeth are counted: a scale is wrong by a slipping wheel or a unit, not by a half"},
    /// Evidence: none yet; chosen.
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
    /// Held-out mean log square that a rung must gain. Reason: less is a hundredth of the RMS. Evidence: none yet;
    /// chosen.
    .worth_a_rung = 0.02,
    /// Part of what remains (`part_taken`) that a rung must take. Reason: an imperfect form of another cause leaves
    /// more. Evidence: none yet; chosen.
    .of_the_rest = 0.15,
    /// Part of its gain that a rung may lose in one fold. Reason: a limit that one step reaches does nothing elsewhere.
    /// Evidence: none yet; chosen. It was set for one case with such a limit.
    .lost_in_a_fold = 0.25,
    /// Held-out mean log square by which rivals differ to be distinguished where all that is left is model error.
    /// Reason: closer rivals differ by model error, 7 % of the RMS. Evidence: none yet; chosen. Over it the odds fall
    /// by e, so that it scales the probability of every ladder.
    .margin = 0.14,
    /// The same where all is noise, times rows. Reason: four readings of 15 rows each (`rows_per_reading`). Evidence:
    /// none yet; chosen. As `margin`, it scales probabilities.
    .rows_of_margin = 60,
    .ranges = physical_ranges,
    /// Standard deviations from which on a documented parameter may be a cause beside others. Reason: one document in
    /// twenty is so far off in a given parameter. Evidence: none yet; chosen.
    .far_off = 2,
    /// Squared standard deviations that a common scale must take from a document's parameters. Reason: of two that are
    /// `far_off`. Evidence: none yet; chosen.
    .relieved = 8,
    /// Multiple of what the document's other parameters are off by, from which on one is far off. Reason: errors of one
    /// document are alike; three inertias beside causes were a cause of their own. Evidence: none yet; chosen.
    .beyond_the_others = 5,
    /// Share of the squares from which on a dependence of the remainder on a signal is reported. Reason: below, it is
    /// the scatter of blocks, not a dependence. Evidence: none yet; chosen.
    .worth_telling = 0.1,
};

/// Least mean square of a held-out window that counts, in squares of the prediction floor. Reason: a joint at rest
/// between two steps of its encoder is predicted to any number of digits by whatever holds it at rest, and the
/// logarithm of nothing outweighs all motion; a documented noise is less than three times too high. Evidence: on a
/// hobby servo with its motor off for three quarters of two records a drift gained 7.0 of mean log square there and
/// 0.03 to 0.15 in the other two folds, and hid the load-dependent friction, which took twice as much of the squares.
inline constexpr double least_square_of_window = 0.1;
/// Part of the explainable gap beyond the corrections that the first rung must take. Reason: a cause that takes less is
/// not the main cause. Evidence: in other cases, of eight values none lies between 0.3 and 0.64.
inline constexpr double least_of_explainable = 0.5;
/// Part of the whole gap that the corrections must take to be the answer on their own. Reason: if most of the gap
/// remains, wrong parameters are not its cause, even if they are slightly wrong. Evidence: an encoder that drops
/// samples leaves three quarters of the gap, which is no function of the signals; a joint file that is 2-5 % off and
/// nothing else leaves less than a fiftieth.
inline constexpr double least_of_gap = 0.5;
/// The same as `least_of_explainable`, for several causes together where the first alone takes less. Reason: two
/// effects can explain more together than the sum of both alone; causes without a main one have to take nearly all.
/// Evidence: none yet; chosen.
inline constexpr double least_of_explainable_together = 0.8;
/// Part of the gap beyond the corrections that a ladder may leave. If it leaves more and an unmodelled force of the
/// same signal as the first rung takes more than `taken_by_free_force` of that, the named cause is only the nearest in
/// shape, and the verdict is unknown. Reason: the right signal with the wrong curve is not the right cause. Evidence: a
/// cubic spring leaves more than a tenth behind gravity; Stribeck curves and bristles of another shape leave less.
inline constexpr double nearest_in_shape = 0.12;
/// Part of what the ladder leaves that an unmodelled force must take for the same. Reason: what a force of the same
/// signal does not take has another cause. Evidence: none yet; chosen.
inline constexpr double taken_by_free_force = 0.5;
/// Part of the gap beyond the corrections that a ladder may leave whatever an unmodelled force takes of it. Reason: the
/// force says that something small remains, not that what took nearly all is another cause. Evidence: a constant load
/// on a joint with a little cogging and asymmetry left 0.0006, and a force of the position was clearly better at that;
/// where such a force refuted a wrong cause (docs/validation-history.md) a tenth and more was left.
inline constexpr double all_but_explained = 0.01;
/// Part of the gap beyond the corrections. If one cause leaves more of the explainable gap, pairs are searched. Reason:
/// two effects can explain more together than the sum of both alone; below this part the next rung finds the second.
/// Evidence: in other cases, of four values none lies between 0.07 and 0.19.
inline constexpr double worth_a_search_of_pairs = 0.1;
/// Probability that a rung is wrong although the ladder leaves only noise. Reason: twice that of a cause that needs no
/// corrections (`doubt_of_accepted`), because corrections may have absorbed a part of another cause. Evidence: the nine
/// rungs with 0.97 in docs/validation-history.md and in other cases are right (seven machines of an arm, a cogging, an
/// asymmetry).
inline constexpr double doubt_of_noise = 0.03;
/// Added to `doubt_of_noise` in proportion to the remainder, in full at `nearest_in_shape` of the gap beyond the
/// corrections; the explainable part of the remainder is added in full. Reason: another cause could be as near as the
/// remainder is large. Evidence: with joint files that are 2-5 % off, all causes that left less than a hundredth were
/// right; some that left more than `nearest_in_shape` were a friction that no formula of the catalogue describes.
inline constexpr double doubt_of_rest = 0.22;
/// Least probability of a second or later rung where more than noise remains. Reason: a rung that is less likely than
/// not would make the named set wrong more often than right; it stays in the remainder. Evidence: with joint files that
/// are off, right second rungs had 0.78 and more and the wrong one 0.30; on a measured ball screw a second rung beside
/// the published asymmetry had 0.22.
inline constexpr double least_chance_of_further_rung = 0.5;
/// Multiple of what a ladder leaves that its last of several rungs must take (`part_taken`) to keep its chance, which
/// falls in proportion below. Reason: where more remains than the rung takes, what it takes may be a part of what
/// remains, which has another cause. Evidence: in dirty blind cases a delay of a third of a sample took 0.7 of what it
/// left and a sag half of it, both wrong; three right ones took 29 to 85 times as much, a right backlash 0.6 of the
/// squares and three times as much in the geometric mean. It does not catch all: two wrong ones took 4 and 22 times.
inline constexpr double taken_of_rest = 1;
/// Part of the squares that the corrections, or the causes above, take. A last rung that is a small term of every
/// machine (`small_term`) and takes less is not named; if no rung is left, the wrong parameters are the answer. The
/// same part of a controller finding's share decides whether such a term, or a cause beside which much remains, is
/// named with it. Reason: a ripple or an uneven winding that moves the joint by less than half as much is not what the
/// gap comes from; of any other cause the share says nothing, because it depends on how far the joint file is off.
/// Evidence: in a joint whose four documented parameters were 2-9 % off and nothing else, a cogging of 1.7 % of the
/// Coulomb level took 8 % of the gap and the corrections 86 %. On an arm under gravity whose file was 3 % off,
/// corrections took 98 % and hid a Stribeck peak of 60 % of the Coulomb level, and four periods of dead time.
inline constexpr double least_against_corrections = 0.25;
/// Part of a controller finding's share that any other cause in the mechanism must take to be named with it where the
/// ladder leaves less than `nearest_in_shape`, unless it is a documented number beyond `widest` beside which only noise
/// remains. Reason: as `worth_telling`: less is the scatter of blocks; where much remains, `least_against_corrections`
/// holds for every cause. Evidence: of eleven dirty blind cases whose ladder has such a cause beside a finding it is
/// there in ten, from 0.13 of the finding's share on, and an inertia told as backlash in one; with a quarter in its
/// place a viscous slope 71 % off (0.24) and an asymmetry of 5 % (0.18) were left out, though their rungs had 0.96 and
/// 0.94.
inline constexpr double least_beside_finding = 0.1;
/// Part of the squares that the causes of a ladder take. A documented parameter that is `far_off` and whose removal
/// costs more is a rung with them. Reason: a parameter that shrinks the gap as much as a cause belongs to the answer;
/// below this part it is one of the corrections that every joint needs. Evidence: an inertia of 1.10 of its document
/// took 32 % of a gap of which the periodic force named alone took 44 %; in dirty blind cases all errors of a joint
/// file together take at most 0.44 of the squares of the cause.
inline constexpr double as_much_as_causes = 0.5;
/// The same of a load, whatever the document's parameters are off by. Reason: a document is a few per cent off in what
/// it states; a load of a tenth of the Coulomb level that it does not mention is no error of that size. Evidence:
/// beside two compliances loads of 10 and 14 % of the Coulomb level took 0.27 and 1.3 of the causes' squares; in 41
/// other dirty joints no load was beyond 0.6 standard deviations.
inline constexpr double least_of_unstated = 0.25;
/// Odds of a rival against the named cause above which both are reported as indistinguishable: one margin, over which
/// odds fall by e. Reason: a rival that an answer calls indistinguishable must have a visible probability, so
/// `ambiguous_with` uses the same odds as the probabilities; a cause beside such a rival has 1/(1 + 1/e) = 0.73 at
/// most. Evidence: a cause at 0.985 was called indistinguishable from one with less than a thousandth, because one
/// number came from the likelihood of all rows and the other from scores that are cut off at the noise.
inline constexpr double odds_of_indistinguishable = 0.368;  // 1/e
/// Probability that a finding of the controller's audit is wrong. Reason: it follows from command, reading and
/// reference alone, without a model of the mechanism, and has to exceed what the audited controller leaves of the
/// command; only another term of the same controller can imitate it. Evidence: the four findings with this probability
/// in other cases (k_p, k_v, a grid, a filter) are right.
inline constexpr double doubt_of_finding = 0.02;
/// Probability that such a finding is the only cause, where more than noise remains that neither an effect nor numbers
/// of the document were found for. Reason: the finding is certain, and as likely as not alone. Evidence: none yet;
/// chosen. A half says that nothing is known of other causes; it is the probability of such answers and decides no
/// name.
inline constexpr double finding_and_more = 0.5;
/// Probability that such a finding is the only cause, where otherwise only documented parameters are off and more than
/// noise remains. Reason: the parameters may have absorbed another cause. Evidence: of 15 such answers on fresh dirty
/// draws 14 are right, one has an asymmetric friction as well: (14 + 1)/(15 + 2).
inline constexpr double finding_with_numbers = 0.88;
/// Probability that wrong documented parameters are the only cause, where only noise remains. Reason: several
/// parameters together can imitate many causes. Evidence: of 28 answers with wrong parameters alone on fresh dirty
/// draws (docs/validation-history.md) the two where only noise remained are right; two are few.
inline constexpr double numbers_to_noise = 0.9;
/// The same where more than noise remains. Reason: as `numbers_to_noise`. Evidence: of those 28 answers 21 are joints
/// whose file is off and nothing else, and seven have another cause (an effort gain, a compliance, a changing inertia,
/// an asymmetry of 5 %, a viscous friction, a Stribeck peak, an inertia with a filter).
inline constexpr double numbers_and_more = 0.75;
/// Part of the squares that all corrections take. A correction is reported as a wrong parameter if its removal costs
/// that much. Reason: a parameter that only follows the others costs less. Evidence: none yet; chosen.
inline constexpr double worth_correcting = 0.05;
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

// Which rows of long records are fitted (audit/).

/// Ticks of all records together up to which all of them are fitted. Reason: the errors of parameters fall with the
/// root of the rows and are below those of the model long before; the time of an answer grows with the rows. Evidence:
/// a load-dependent friction of 0.12 was fitted as 0.1207 to the whole of 25 s at 1 kHz and as 0.1200 to stretches of
/// 1,000 s, and named with 0.97. Nothing was tried between these numbers and half or twice as many.
inline constexpr double most_whole = 200'000;
/// About so many ticks of longer records are fitted. Reason: as `most_whole`. Evidence: the same load-dependent
/// friction was fitted as 0.1200 to stretches of 1,000 s at 1 kHz; all other rows are simulated to 1.00 × the noise
/// floor, where the document misses by 32 ×. Nothing was tried between this number and half or twice as many.
inline constexpr double fitted = 120'000;
/// Stretches of longer records that are fitted, or fewer. Reason: stretches of different motion say more than one of
/// the same length. Evidence: six of 48 s at 20 kHz gave that friction as 0.1219, and all other rows to 1.01 × the
/// noise floor. Nothing was tried between this number and half or twice as many.
inline constexpr double stretches_fitted = 8;
/// Seconds of a stretch at least. Reason: a stretch that is shorter than a motion holds only a part of it. Evidence:
/// none yet; chosen. Nothing was tried between it and half or twice as much.
inline constexpr double shortest_stretch = 1.5;

// Deciding between causes (verdict/, search/, heldout/) and the audit of the controller (audit/).

/// Difference of score. Among causes closer than this the likelihood decides. Reason: scores of causes that explain to
/// within noise differ only by noise. Evidence: in other cases, of 29 values none lies between 0.007 and 0.032.
inline constexpr double margin_of_score = 0.02;
/// Rows that count as one independent reading in the likelihood. Reason: the innovations of a true joint would be white
/// and every row a reading of its own; innovations of a model are not. Evidence: the nearest ties of two blind batches,
/// nine, of which this number and `relative_temperature` were set together.
inline constexpr double rows_per_reading = 15;
/// Width of the odds as a part of the best score. Reason: far above the floor margins are model error and grow with the
/// best score. Evidence: the same nine ties as of `rows_per_reading`.
inline constexpr double relative_temperature = 0.007;
/// Odds against a rival with one more parameter that gains nothing by it. Reason: the rival contains the winner as a
/// special case, and a true rival would have used its parameter; Schwarz's √n for a thousand independent readings.
/// Evidence: with 10 or 100 eight other cases keep their names; the largest change of a probability is from 0.95 to
/// 0.89.
inline constexpr double needless_parameter = 30;
/// Probability that a named cause is wrong where only noise remains. Reason: the catalogue is finite, and real causes
/// may lie outside it. Evidence: the calibration of the blind batches in docs/validation.md.
inline constexpr double doubt_of_accepted = 0.015;
/// The same where more than noise remains. Reason: as `doubt_of_accepted`. Evidence: the calibration of the blind
/// batches in docs/validation.md.
inline constexpr double doubt = 0.15;
/// Largest value of that probability. Reason: a named cause has a chance, or it would not be named. Evidence: none yet;
/// chosen. It is a cap: an answer with so much doubt is stated as the nearest cause at most.
inline constexpr double most_doubt = 0.95;
/// Part of the misfit beyond the noise that one cause must explain to be accepted although a remainder exists. Reason:
/// stick-slip amplifies the differences of two integrators. Evidence: in other cases, of nine values none lies between
/// 0.82 and 0.977.
inline constexpr double explained_single = 0.97;
/// The same of a pair. Reason: two causes have more parameters, so that more is asked of them. Evidence: in other
/// cases, of three values none lies between 0.89 and 0.993.
inline constexpr double explained_pair = 0.985;
/// The same of backlash. Reason: simulated contact differs slightly from real backlash. Evidence: none yet; chosen. In
/// other cases one value was compared with it, 0.9935.
inline constexpr double explained_by_backlash = 0.99;
/// Difference of score by which a pair must be better than its best single where the single explains to within noise.
/// Reason: a second effect has to earn its place. Evidence: none yet; chosen. In other cases a pair that is there is
/// better by 3.06.
inline constexpr double worth_a_partner = 0.06;
/// The same where a remainder exists or backlash alone leaves hardly any. Reason: a second effect has to earn its
/// place, the more so where a remainder is there in any case. Evidence: none yet; chosen. In other cases a partner of
/// backlash is better by 0.0018 and a pair that is there by 3.06.
inline constexpr double worth_a_doubted_partner = 0.15;
/// Part of the misfit beyond the noise. A cause that explains less is not named. Reason: it is one cause among others.
/// Evidence: in 12 blind cases (seed 4122), of 27 values that were compared with it none lies between 0.62 and 0.82.
inline constexpr double nameable = 0.75;
/// Part of the misfit beyond the noise that a pair with backlash or a spring must explain to be named in place of the
/// single. Reason: real backlash has a contact that cannot be simulated exactly, so that a remainder exists in any
/// case. Evidence: none yet; chosen.
inline constexpr double completed = 0.94;
/// Part of the remainder of backlash or a spring alone that its partner must take for the same. Reason: as `completed`.
/// Evidence: none yet; chosen.
inline constexpr double taken_by_partner = 0.75;
/// Part explained above which closed-loop simulations may accept a cause, above which a single is named whose best
/// partner hardly helps, and above which a cause that acts nowhere by itself has its signature. Reason: simulations of
/// the whole loop are noisy and would accept causes that predictions show to be wrong; a remainder of a single that no
/// partner takes is no second effect. Evidence: in other cases, of 71 values none lies between 0.89 and 0.96.
inline constexpr double mostly_explained = 0.9;
/// Part of the mean square above the prediction floor that still counts as noise. Reason: two integrators differ, and a
/// documented noise is slightly off. Evidence: with it and `deviations_of_floor` none of 300 joints without an effect
/// raised an alarm (docs/validation.md).
inline constexpr double slack_of_floor = 0.06;
/// Standard deviations of repeated simulations that still count as noise. Reason: a statistic of few runs exceeds three
/// of them now and then. Evidence: with it and `slack_of_floor` none of 300 joints without an effect raised an alarm
/// (docs/validation.md).
inline constexpr double deviations_of_floor = 4;
/// Misfit in multiples of the prediction floor, at the fastest observer, above which a cause is rejected whatever the
/// noise. Reason: no joint's own noise reaches this within a few rows. Evidence: in 12 blind cases (seed 4122), of 44
/// values that were compared with it none lies between 2.7 and 4.2.
inline constexpr double hopeless = 3;
/// Periods of a wave that a record must contain. Reason: a shorter piece is a bend that other shapes describe as well.
/// Evidence: none yet; chosen.
inline constexpr double turned_back = 2.0 / 3;
/// Distance to the end of a range, as a part of it, within which a parameter is at its bound. Reason: a parameter at a
/// bound comes from the search, not from the joint. Evidence: in 12 blind cases (seed 4122), of 308 values that were
/// compared with it none lies between 0 and 0.0025.
inline constexpr double beside_bound = 0.001;
/// Multiple of the usual size of a parameter that is implausible. Reason: a document is wrong by a part of what it
/// states; ten times as much is something else. Evidence: none yet; chosen.
inline constexpr double implausible_size = 10;
/// Least usual size that counts for `implausible_size`, in units of the parameter. Reason: a parameter whose usual size
/// is next to nothing would be implausible whenever it is there. Evidence: none yet; chosen.
inline constexpr double least_prior = 0.1;
/// Part of the largest deviation that a correction may have (`widest`) within which it is at its bound. Reason: a
/// descent may end just inside. Evidence: of 65 corrections that the tests of the ladder look at, those at their bound
/// stand at it to the last digit, and the nearest other at 0.90 of it.
inline constexpr double inside_bound = 0.01;
/// Correlation, second by second, of the residual and what an effect takes out of it, from which on a second shows the
/// signature of the effect. Reason: half of the squares of such a second (0.7² = 0.49) are due to the effect.
/// Definition: "signature" on the page.
inline constexpr double signature_correlation = 0.7;
/// Mean square of what an effect makes, in multiples of the prediction floor, from which on it acts in a second.
/// Reason: where it makes less than twice the noise, noise decides. Definition: the seconds of "signature", those in
/// which the effect makes twice the noise.
inline constexpr double acting_square = 4;
/// Part of the seconds in which an effect acts that must have its signature. Reason: a second may be disturbed by
/// something else. Evidence: none yet; chosen.
inline constexpr double most_seconds = 2.0 / 3;
/// Noise standard deviations that an effect of usual size must reach to be detectable. Reason: what hardly exceeds the
/// noise would be found in one record and not in the next. Definition: `insufficient-data` means that no effect of
/// usual size makes five times the noise.
inline constexpr double shown = 5;
/// Largest probability of a nearest cause that is not named. Reason: it is listed only as a hint, and the verdict is
/// unknown. Evidence: none yet; chosen. It is shown beside the hint and decides no name.
inline constexpr double believed_unnamed = 0.1;
/// Part of the mean square beyond the noise. A cause that leaves more on held-out data is rejected. Reason: it is not
/// the cause of the gap. Definition: the cause of a gap takes at least half of it.
inline constexpr double mostly_left = 0.5;
/// Multiple of an estimated (undocumented) noise floor. A cause that leaves more and is not explained to within noise
/// is rejected. Reason: an estimated floor is less wrong than this. Evidence: of such causes in ten blind batches the
/// one that left less than two was right; the two that left more than seven were an inertia that changed with time.
inline constexpr double many_floors = 3;
/// Multiple of a documented noise floor. A cause that leaves more and is not explained to within noise has at most the
/// probability `believed_doubted`. Reason: there is a second effect, or another one. Evidence: of ten such causes in
/// two blind batches the six that left less were right; the four that left more were wrong or lacked a second effect.
inline constexpr double more_than_noise = 1.5;
/// Largest probability of a cause that leaves `more_than_noise`. Reason: it may be one of two causes. Evidence: of the
/// four such causes in two blind batches none was the whole answer; (0 + 1)/(4 + 2) = 0.17.
inline constexpr double believed_doubted = 0.2;
/// Part of the gap that a ladder's causes have to explain where whole records that no fit has seen are simulated. If
/// they explain less and leave `more_than_noise`, their probability is at most `believed_simulated`. Reason: the ladder
/// predicts rows with the logged command, which hides what the controller does otherwise. Evidence: of 50 answers on
/// dirty blind cases 47 explain 0.92 and more, 33 of them right; two right ones that explain less are coarse encoder
/// steps, whose simulations differ among themselves; 0.82 is wrong, as was 0.64 (a limit named at 0.97 beside a wrong
/// filter).
inline constexpr double simulated_least = 0.87;
/// Largest probability of such a ladder. Reason: it is as likely wrong as right. Evidence: of the four answers below
/// `simulated_least` that its evidence counts two are right; (2 + 1)/(4 + 2).
inline constexpr double believed_simulated = 0.5;
/// Relative RMS, over strides of 1 to 6 rows, by which white noise and the jerk of the motion miss what third
/// differences show, above which the noise has a memory. Reason: estimates of white noise agree to a hundredth or two.
/// Evidence: in the first records of 13 dirty cases (seed 2026112704) white noise leaves at most 0.033, coloured noise
/// 0.098 to 0.38.
inline constexpr double noise_not_white = 0.06;
/// Part of that RMS that noise with a memory may leave. Reason: a memory that explains less is not the noise's.
/// Evidence: in the same 13 cases noise with a memory leaves a third at most.
inline constexpr double noise_with_memory_leaves = 0.5;
/// Multiple of the noise floor that a simulation of whole records may reach without a gap. Reason: noise may hide from
/// row to row what adds up over a record. Evidence: none of 470 blind joints without an effect exceeded 1.25.
inline constexpr double far_from_noise = 1.5;
/// Ratio of mean squares by which closed-loop simulations may exceed their own spread. Reason: the spread of so few
/// runs (4) is not known better. Evidence: in other cases, of 243 ratios none lies between 1.24 and 1.28.
inline constexpr double slack_of_runs = 1.25;
/// Part of the span up to which the spread of simulations of one joint counts as noise. Reason: an unstable or chaotic
/// simulation differs from itself by a large part of the motion, and any record would be within its spread. Evidence:
/// none yet; chosen.
inline constexpr double own_part = 0.02;
/// Standard deviations of a reading up to which the same spread counts as noise whatever its part of the span. Reason:
/// a joint that hardly moves has a small span. Evidence: none yet; chosen.
inline constexpr double own_readings = 20;
/// Mean square in multiples of the prediction floor, at the fastest observer, up to which a cause explains to within
/// noise. Reason: as `slack_of_floor`, with room for parameters that are not fitted exactly; simulations of the joint's
/// own noise confirm it afterwards. Evidence: none yet; chosen.
inline constexpr double accepted_fast = 1.12;
/// The same at the middle observer. Reason: as `accepted_fast`; over a longer horizon the errors of parameters add up.
/// Evidence: none yet; chosen.
inline constexpr double accepted_middle = 1.15;
/// Part of the misfit beyond the noise that a cause must explain for the same. Reason: a misfit that is hardly above
/// noise at all would be explained by anything. Evidence: in 12 blind cases (seed 4122), of 15 values that were
/// compared with it none lies between -0.049 and 0.91.
inline constexpr double accepted_part = 0.8;
/// Part of the records that must be within `accepted_middle`. Reason: one record may hold a lost step or a noise that
/// is not documented, which the middle observer shows for longer. Evidence: none yet; chosen.
inline constexpr double most_records = 2.0 / 3;
/// Penalty of score for each parameter. Reason: a parameter that fits only noise gains less in thousands of rows.
/// Evidence: with half of it and with twice of it eight other cases keep verdict and names.
inline constexpr double price_of_parameter = 0.003;
/// Part of the mean square above the floor. The fastest observer that shows so much screens the causes. Reason: at an
/// observer that shows less, noise decides the ranking. Evidence: in 12 blind cases (seed 4122), of 31 values that were
/// compared with it none lies between 0.24 and 0.6.
inline constexpr double visible_excess = 0.3;
/// Part of the squares of a measured effort. Where the documented controller leaves more of them at any gains, another
/// controller ran, and the measured effort drives the simulated joint. Reason: below that a gain, a delay or a lag that
/// differs is found as such; simulated with a controller that did not run, the joint moves otherwise than the machine,
/// and every cause would be fitted to that. Evidence: in 100 records of 50 joints (blind cases of another's making,
/// their commands removed) the documented structure leaves at most 0.07, in 90 of them less than 0.01; of a PID
/// documented as a PD controller it leaves 0.44 to 0.52.
inline constexpr double made_by_controller = 0.1;
/// `made_by_controller` for a PID that is named in place of the documented PD controller. Reason: the noise of the
/// effort hides less than that. Evidence: a PID documented as a PD controller leaves less than 0.005 in its three
/// records, and as documented 0.44 to 0.52.
inline constexpr double made_by_pid = 0.02;
/// Relative spread of the integral gain of such a PID between records. Reason: one controller ran in all records.
/// Evidence: of that PID the integral gains differ by 0.001.
inline constexpr double one_integral = 0.1;
/// numerical: rows by which an effort may follow what made it, that are tried. Reason: a bus and a filter take a row or
/// two each; a loop that answers later is named by its delay. A longer list costs a regression each.
inline constexpr std::size_t most_rows_late = 3;
/// Standard deviations of an effort's noise below its largest reading, from which on it may be at a limit. Reason: of
/// 16,000 readings of one effort the largest and the least are so far apart (plus and minus four standard deviations).
/// Evidence: without it, rows at a noisy limit count as the controller's own and another controller is found. The noise
/// is that about the fitted controller: a derivative makes noise that is none of a limit's, and with that of the effort
/// itself no row of a log of 10 N·m over 1.2 N·m was left.
inline constexpr double scatter_at_limit = 8;
/// Part of the limit. A command below it is not limited. Reason: logs are rounded. Evidence: in other cases, of 31
/// million values none lies between 0.9989 and 0.9998; of 24,000 of measured efforts in tests, none between 0.9987 and
/// 0.9996.
inline constexpr double below_limit = 0.999;
/// Part of the usual speed below which the joint counts as stuck. Reason: this regime is for the reader. Definition:
/// the word "stuck" of the page.
inline constexpr double standing = 0.005;
/// Part of the usual speed below which it counts as slow. Reason: this regime is for the reader. Definition: the words
/// "low speed" of the page.
inline constexpr double slow = 0.2;
/// Relative error of a gain, or part of the command of an added term, that is a finding. Reason: documents state three
/// digits. Evidence: of 68 values in the tests of the audit none lies between 0.001 and 0.024, of 14 in other cases
/// none between 0 and 0.8.
inline constexpr double flagged_gain = 0.004;
/// Part of the integral of one sample to which the error of a gain must agree with it (or with half of it) for the
/// controller's rule of integration to be the cause. Reason: a gain that is off by that is off by the rule. Evidence:
/// in one cascade that integrates by forward Euler the two agree to 1e-8; of the trapezoidal rule there is no case.
inline constexpr double same_sample = 0.01;
/// Standard errors by which a gain that was read from the encoder's noise must be off to be a finding. Reason: errors
/// of noise exceed five once in two million times. Definition: beyond doubt.
inline constexpr double flagged_gain_errors = 5;
/// Misfit over rms of the fifth differences of the command up to which it is made of the logged velocities, without a
/// reference. Reason: velocities that the command is made of are the controller's own, and tell its filter. Evidence:
/// logs of seven digits leave 1e-7 with the controller's own filter, and 4e-5 with one that is a quarter off.
inline constexpr double made_of_differences = 1e-5;
/// The same of the command itself with a reference. Reason: as `made_of_differences`; a logged reference has digits,
/// too. Evidence: none yet; chosen.
inline constexpr double made_of_velocities = 2e-3;
/// Misfit of the command over its rms that is the digits of a file. Reason: logs with five digits leave this. Evidence:
/// in 12 blind cases (seed 4122), of 15 values that were compared with it none lies between 0 and 5.2e-05.
inline constexpr double digits = 2e-5;
/// Misfit of the command over its rms below which the controller is understood. Reason: a controller whose terms are
/// all known leaves hardly more than digits and noise. Evidence: none yet; chosen.
inline constexpr double understood = 2e-3;
/// Misfit over rms up to which a controller is judged at all. Reason: a controller between the samples of a slow log,
/// or with a coarse output, can be reproduced only roughly. Evidence: of 20 misfits in the tests of the audit none lies
/// between 0.027 and 0.073.
inline constexpr double rough_command = 0.05;
/// Multiple of that misfit by which a gain must be off to be a finding where the controller is reproduced only roughly.
/// Reason: what is not reproduced may be a part of the gain. Evidence: none yet; chosen.
inline constexpr double rough_multiple = 5;
/// Least relative error of a gain that is a finding there. Reason: as `rough_multiple`. Evidence: in the tests of the
/// audit gains of efforts that drive are off by 0.0001 or 0.5.
inline constexpr double rough_gain = 0.03;
/// In a log slower than its loop: multiple of the noise that the controller makes of the encoder's, up to which the
/// logged commands are its own, and its commands from the positions alone drive the simulated joint. Reason: noise of
/// every fifth command, without that of the four between that cancels it, pushes the joint about. Evidence: 8 s of an
/// arm at 1 kHz, logged at 200 Hz with command and velocity: twice the noise remained with the true model, and it was
/// within noise as soon as both columns were removed.
inline constexpr double noise_of_commands = 2;
/// Part of the misfit without a term that an undocumented filter, dead zone or derivative term may leave at most.
/// Reason: a term that exists takes most of what its absence leaves. Evidence: values lie on both sides (0.499 and
/// 0.5002), so that no gap supports this number; with 0.4 and with 0.6 eight other cases keep their answers.
inline constexpr double much_less = 0.5;
/// The same of any undocumented term compared with free gains. Reason: free gains imitate a part of a term. Evidence:
/// of 22 values in other cases and in the tests of the audit none lies between 0 and 0.76.
inline constexpr double much_better = 0.25;
/// Where the joint file gives no period: part of the way from held to straight commands above which the motion says
/// that they are straight. Reason: halfway is nearer to neither. Evidence: simulated records of continuous loops lie at
/// 1.0, of sampled ones at 0.0, while nothing else is wrong.
inline constexpr double straight = 0.5;
/// Standard errors by which it must be above. Reason: a record of little motion says nothing of it. Evidence: none yet;
/// chosen.
inline constexpr double straight_errors = 2;
/// Multiple of what all terms together leave, or of rounding, below which no further term is needed. Reason: terms
/// share a little of what rounding leaves. Evidence: of 27 values in the tests of the audit none lies between 1.15 and
/// 1.2, of 75 in other cases none between 1.1 and 1.47.
inline constexpr double enough = 1.2;
/// Ratio within which an undocumented gain must agree between records. Reason: the controller has the same gain in all
/// of them. Evidence: none yet; chosen.
inline constexpr double agreeing = 2;
/// Multiple of a plateau of the command that the unlimited controller must exceed for the plateau to be a limit.
/// Reason: a reference at rest makes plateaus, too. Evidence: in the tests of the audit the plateaus that are no limits
/// reach 0.9942.
inline constexpr double wanted_more = 1.01;
/// Part of the rows. A regression that leaves out more of them as outliers is rejected. Reason: the majority is the
/// rule. Evidence: in the tests of the audit all 1236 regressions use at least 0.988 of their rows.
inline constexpr double most_rows = 0.5;
/// Part of the known reading error below which a grid has no influence. Reason: squares add, and a hundredth of a
/// square is nothing. Evidence: none yet; chosen.
inline constexpr double felt_grid = 0.1;
/// Multiple of the documented step above which a grid is coarser than documented. Reason: a step larger by a third is
/// another converter. Evidence: none yet; chosen.
inline constexpr double coarser_grid = 1.3;
/// Multiple of the documented noise above which a grid can be seen. Reason: noise of two steps hides them. Evidence:
/// none yet; chosen.
inline constexpr double grid_over_noise = 0.5;
/// Part of the squares of a logged supply's drop that the current must explain. Reason: a drop that follows something
/// else is not the source's resistance. Evidence: none yet; chosen.
inline constexpr double supply_follows = 0.8;
/// Part of the supply that the drop must make up. Reason: two parts in a thousand are the digits of a voltmeter.
/// Evidence: none yet; chosen.
inline constexpr double supply_matters = 0.002;
/// Difference of score by which an unmodelled force must be better to reject a cause. Reason: a free shape has more
/// parameters, which gain a little from noise. Evidence: in 12 blind cases (seed 4122), of 6 values that were compared
/// with it none lies between 0.0007 and 0.017.
inline constexpr double least_of_free_force = 0.004;
/// The same as a part of what the cause leaves. Reason: as `least_of_free_force`, where more is left. Evidence: in 12
/// blind cases (seed 4122), of 5 values that were compared with it none lies between 0.033 and 0.33.
inline constexpr double better_than_cause = 0.25;
/// Part of the rows of a table of outcomes that a named law may misjudge beyond contradicting rows. Reason: stick-slip
/// noted by ear is sometimes wrong; a law that misses every eighth row is not the joint's. Evidence: in the tests of
/// tables, of five laws none misjudges between 0.056 and 0.55.
inline constexpr double most_misjudged = 0.12;
/// Part of its rows that may contradict each other. Reason: a table of two joints is no table of one. Evidence: none
/// yet; chosen. In the tests no table of one joint contradicts itself.
inline constexpr double most_contradicting = 0.15;
/// Held-out log-likelihood by which one friction law must be better than another; laws that are nearer, and a nominal
/// joint that is, cannot be distinguished. Reason: rows are few, and their likelihood is rough. Definition: "cannot be
/// distinguished" of a table, odds below twenty to one (e³).
inline constexpr double clear_margin = 3;
/// Rows of a table of outcomes below which it is no answer. Reason: a boundary with two numbers needs rows on both of
/// its sides. Definition: "insufficient data" of a table.
inline constexpr double fewest_outcomes = 8;
/// Rows of its rarer outcome below which it is no answer. Reason: as `fewest_outcomes`. Definition: "insufficient data"
/// of a table.
inline constexpr double fewest_of_either = 3;
/// Probability above which a row of a table is predicted to stick and slip. Reason: the likelier outcome is the
/// predicted one. Definition: a half.
inline constexpr double likelier_than_not = 0.5;
/// Part of the rows of a table that are noted wrongly or disturbed: no row costs more than -ln of half of it. Reason:
/// one wrong row would outweigh all others in a likelihood without it. Evidence: none yet; chosen. It bounds the cost
/// of a row at ln 100.
inline constexpr double wrong_rows = 0.02;
/// Spreads of a measured amplitude that it costs at most. Reason: as `wrong_rows`, of amplitudes. Evidence: none yet;
/// chosen. It bounds the cost of a row.
inline constexpr double worst_amplitude = 3;
/// Kinds of friction that explain a table alike from which on none of them is named. Reason: a choice among so many is
/// no answer. Evidence: none yet; chosen.
inline constexpr double too_many_kinds = 3;
/// Multiple of what the encoder resolves (its step or its noise), peak to peak, up to which a position does not move.
/// Reason: of 16,000 readings of one position the largest and the least are so far apart (plus and minus four standard
/// deviations). Definition: "does not move" of a record.
inline constexpr double still = 8;
/// Ratio of the noise that readings show to the documented one, above which the estimate takes its place. Reason:
/// estimates of white noise agree to a hundredth or two (`noise_not_white`); a noise is documented for a type of
/// sensor. Evidence: none yet; chosen.
inline constexpr double noise_believed = 1.25;
/// The same beside a grid that is coarser than documented. Reason: a coarse grid makes third differences of its own.
/// Evidence: none yet; chosen.
inline constexpr double noise_beside_grid = 2;
/// The same of the rounding of an encoder step where no noise is documented. Reason: a step alone says nothing of
/// noise, and estimates agree to a hundredth or two. Evidence: none yet; chosen.
inline constexpr double noise_of_step = 1.02;
/// Rows below which a record is not judged. Reason: its noise is estimated from third differences and its misfit from
/// blocks of rows; both need some. Definition: "insufficient data" of a record.
inline constexpr double fewest_rows = 100;
/// Findings of the audit from which on the record is called that of another joint and nothing else is concluded.
/// Reason: encoder and controller of one machine are set one by one, and seldom three of them wrongly. Evidence: none
/// yet; chosen.
inline constexpr double findings_of_another_joint = 3;
/// Part of the gap that an unmodelled force must take to be told beside "unexplained". Reason: a hint at what is
/// missing has to explain most of the gap. Definition: the words "most of it follows the …", half.
inline constexpr double worth_a_hint = 0.5;

// Stating the answer (sweep/words).

/// Probability of the named cause from which on it is stated as a fact. Reason: a reader acts on it. Definition: the
/// words "comes from".
inline constexpr double stated_flatly = 0.9;
/// Probability from which on it is stated as probable. Reason: below a half the other causes together are likelier than
/// the named one. Definition: the words "probably comes from".
inline constexpr double stated_as_probable = 0.5;

// Deciding between laws of a friction rig (rig/).

/// numerical: rows of a rig's record that are held out together, every third block in turn. Reason: whoever measures
/// writes more rows where more happens, so that every third has its part of a transient.
inline constexpr std::size_t rows_of_rig_block = 20;
/// Part of the RMS on held-out rows by which a law of a rig must be better than its friction at one level to be named.
/// Reason: one number more takes a little from any scatter. Evidence: in the simulated rigs of the tests laws that are
/// there take 0.51 to 0.83 of it; of a constant friction the best law takes nothing.
inline constexpr double worth_a_rig_law = 0.1;
/// Difference of the logarithm of the RMS on held-out rows. Laws closer than this cannot be distinguished; over it, the
/// odds fall by e. Reason: what rigs leave is model error, not noise, and no law of the catalogue is exact. Evidence:
/// in the tests, laws that one step cannot distinguish are 0.003 to 0.03 apart, those that it can 0.09 and more.
inline constexpr double rig_margin = 0.05;
/// Penalty for each parameter of a law, as a logarithm of the RMS. Reason: a law contains simpler ones as limits, so
/// that its parameters have to earn their place. Evidence: in the tests' rigs laws are at most 0.03 or at least 0.09
/// apart (`rig_margin`), so that it decides only among those that are reported together.
inline constexpr double price_of_rig_parameter = 0.005;
/// RMS of a rig about its level, in multiples of the noise, up to which there is no gap. Reason: as `slack_of_floor` of
/// the mean square, twice that for the RMS. Evidence: in the tests a constant friction reaches 0.97, and rigs with
/// memory, Stribeck or viscous friction 2.0 to 5.7.
inline constexpr double quiet_rig = 1.06;
/// Probability of all laws of a rig together. Reason: the catalogue is finite. Evidence: none yet; chosen. A twentieth
/// is left for laws outside it; it scales every probability of a rig and decides no name.
inline constexpr double any_law_of_rig = 0.95;

/// Part of the misfit beyond the noise that a cause with a jagged misfit (backlash, a limit) must explain to be
/// searched for longer. Reason: long searches cost most of the time of an answer, and what explains less is not the
/// cause. Evidence: none yet; chosen.
inline constexpr double worth_a_long_search = 0.5;
/// Multiple of the least objective of these searches up to which a cause is searched at the slower observers, too.
/// Reason: what is further behind is not named. Evidence: none yet; chosen.
inline constexpr double near_the_best = 1.15;
/// Part of its objective below which an observer takes over the parameters that another one found. Reason: a search may
/// have ended in a hollow that the others found the way out of; parameters of another horizon that are hardly better
/// are not. Evidence: none yet; chosen.
inline constexpr double out_of_the_hollow = 0.8;
/// Difference of score from an accepted cause beyond which a cause is not refined. Reason: rivals matter within a tenth
/// of that (`margin_of_score`). Evidence: none yet; chosen.
inline constexpr double far_behind = 0.25;
/// Score below which no better parameters are searched. Reason: so little is left that they would decide nothing.
/// Evidence: none yet; chosen.
inline constexpr double clear_score = 0.04;
/// Margins of a ladder (`margin`) by which a set of causes must be worse to be no rival. Reason: its odds are e⁻⁴ =
/// 0.02. Evidence: none yet; chosen.
inline constexpr double out_of_question = 4;
/// Part of what an effect takes off in a record that is held out, below which the others hardly show it: thirds of that
/// record are held out in its place. Reason: what is not in the other records cannot be fitted to them. Evidence: none
/// yet; chosen.
inline constexpr double hardly_in_others = 0.1;
/// Multiple of an estimated noise of the effort that counts as its noise. Reason: an estimate that is a little low
/// would make a gap of plain noise. Evidence: none yet; chosen. Estimates of white noise agree to a hundredth or two
/// (`noise_not_white`).
inline constexpr double doubted_estimate = 1.03;
/// Part of the effort's RMS that counts as noise of its own. Reason: a lag or a delay is written down in slightly
/// different ways. Evidence: none yet; chosen. It is added to the square of the noise: it matters where a measured
/// effort has less noise than a thousandth.
inline constexpr double model_noise_of_effort = 1e-3;
/// Mean square of what the first rows are off the prediction from rest, in squares of a reading's error, above which a
/// record may start in motion. Reason: five standard deviations in each of ten rows are no noise. Evidence: none yet;
/// chosen.
inline constexpr double missed_at_rest = 25;
/// Part of that mean square that a start in motion may leave. Reason: an unmodelled force that sets a joint in motion
/// leaves a sixth. Evidence: none yet; chosen.
inline constexpr double left_by_motion = 0.05;
/// Median deviation of what a command has beyond its other terms, as a part of it, up to which it is what the integral
/// held at the start. Reason: an integral changes little over twenty rows. Evidence: none yet; chosen.
inline constexpr double held_at_start = 0.1;
/// Mean square over the floor at which a block of rows begins to count less. Reason: a disturbance that no cause
/// explains must not decide all parameters. Evidence: none yet; chosen. It shapes every objective that is minimised.
inline constexpr double large_block = 20;
/// Part of a row by which the median step of a log may differ from a multiple of the loop's period for its stamps to be
/// moved to an even clock. Reason: a log of another rate has no such clock. Evidence: none yet; chosen.
inline constexpr double whole_row = 0.05;
/// RMS scatter of stamps, part of a row, up to which they are moved to an even clock without asking the readings.
/// Reason: what is scattered by more may be uneven in truth: then readings decide. Evidence: none yet; chosen.
inline constexpr double jitter_unquestioned = 0.1;
/// Von Neumann's ratio of the deviations of stamps above which they scatter on their own. Reason: it is 2 where rows
/// scatter independently, and 0 where they wander as a clock does: halfway. Evidence: none yet; chosen.
inline constexpr double scattered_stamps = 1;
/// Rows lost in a row up to which they are filled in; more are a hole at which a record is cut. Reason: what a joint
/// does between two readings is known for some tens of milliseconds. Evidence: none yet; chosen.
inline constexpr double most_lost_rows = 20;
/// Difference of the probabilities of stick-slip by two laws from which on a row is proposed as the next to measure.
/// Reason: less is no experiment. Evidence: none yet; chosen. It decides whether a proposal is made.
inline constexpr double least_apart = 0.3;
/// Held-out log-likelihood behind the likeliest law beyond which the motion of a law is not simulated. Reason:
/// amplitudes cost `worst_amplitude` a row at most, and so much is not made up for. Evidence: none yet; chosen.
inline constexpr double worth_following = 20;
/// Standard deviation of the logarithm of a measured amplitude, and its floor in the gap. Reason: a measurement that is
/// repeated differs by so much. Evidence: none yet; chosen. It scales what amplitudes say of a law.
inline constexpr double amplitude_spread = 0.15;
/// Distance to stick-slip within which the motion of a joint with memory is simulated. Reason: further away small and
/// large disturbances end alike. Evidence: none yet; chosen.
inline constexpr double near_stick_slip = 0.5;
/// Distance to the end of a law's range, as a part of it, within which a number of a law is implausible. Reason: as
/// `beside_bound`; the search among rows is coarser. Evidence: none yet; chosen.
inline constexpr double beside_bound_of_law = 0.02;
/// Degrees by which the temperature must change for "cold" and "warm" to be regimes. Reason: less says nothing of
/// temperature. Definition: the words "cold" and "warm" of the page.
inline constexpr double felt_warming = 1;
/// Seconds after a reversal that count as one. Reason: this regime is for the reader. Definition: the word "reversal"
/// of the page.
inline constexpr double after_reversal = 0.1;
/// Hz up to which an error is slow. Reason: this regime is for the reader. Definition: the words "below 1 Hz" of the
/// page.
inline constexpr double end_of_low_band = 1;
/// Hz from which on it is fast. Reason: as `end_of_low_band`. Definition: the words "above 5 Hz" of the page.
inline constexpr double end_of_middle_band = 5;
/// Standard deviations of a 95 % interval, on either side. Reason: intervals are stated at 95 %. Definition: the normal
/// distribution's quantile.
inline constexpr double two_sided_95 = 1.96;
/// Part of the stroke by which a proposed motion may leave what the records have shown. Reason: a controller overshoots
/// a little. Evidence: none yet; chosen.
inline constexpr double beyond_stroke = 0.05;
/// Multiple of the largest speed that the records have shown, up to which the simulated joint may go in a proposed
/// motion. Reason: what has not been shown may not be safe. Evidence: none yet; chosen.
inline constexpr double beyond_speed = 1.1;
/// The same of the acceleration. Reason: breaking away is sharper than what a record's noise lets be seen. Evidence:
/// none yet; chosen.
inline constexpr double beyond_acceleration = 2.2;
/// Part of the speed and acceleration of the records that a proposed reference uses. Reason: a closed loop overshoots.
/// Evidence: none yet; chosen. With less a proposed motion is slower; `beyond_speed` judges it in any case.
inline constexpr double within_seen = 0.9;
/// Part of the travel by which the load point of a rig must go back for a turn. Reason: that is more than noise.
/// Evidence: none yet; chosen.
inline constexpr double turned_of_rig = 0.01;
/// Part of the normal load by which two runs must differ to tell what depends on it. Reason: less is the scatter of a
/// load cell. Evidence: none yet; chosen.
inline constexpr double loads_of_rig_differ = 0.01;
/// Part of the travel, or of the time, that a rig's memory may take at most. Reason: a longer one would never have been
/// seen to fade. Evidence: none yet; chosen. Sepiolite's record wants 43 mm, twenty times its travel, which is no
/// answer.
inline constexpr double longest_memory_of_rig = 0.5;
/// Multiple of the last change of what a limited command is made of, by which it must have jumped for the reference to
/// have jumped. Reason: a smooth way into a limit goes on as it came. Evidence: none yet; chosen.
inline constexpr double jump_into_limit = 4;
/// Part of an encoder step below which noise moves a reading only in passing: then the noisiest record's noise is that
/// of all. Reason: a record that stands still between two steps shows none. Evidence: none yet; chosen.
inline constexpr double seldom_a_step = 0.5;
/// Probability from which on a page says that the cause may not be listed. Reason: less is not worth a reader's time.
/// Definition: the words "that the cause is not listed".
inline constexpr double stated_none = 0.05;

}  // namespace stickslip::gap::policy
