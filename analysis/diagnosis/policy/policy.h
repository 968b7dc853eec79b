// The policy of the diagnosis: every threshold that decides an answer, with its unit, its reason and the evidence for
// it. Numerical limits stand with their algorithms. A threshold that tells no evidence of its own has that of the blind
// batches (docs/validation.md), which were answered with this value; others were not tried.
// In one file: the policy, so that its page can be made from it.
#pragma once
#include "analysis/diagnosis/policy/rules.h"

#include <array>

namespace stickslip::gap::policy {

/// Parts of each number. Reason: catalogues, CAD masses and single-run identifications of machines miss by so much;
/// identified friction is the least certain, and differs from day to day. Evidence: in the blind cases that look like
/// machines files are 2-10 % off in all three numbers, and records of one joint differ by 3-10 % in their Coulomb
/// level. `small_term`: ripple of gears and windings, asymmetry and warm-up of a per cent or two stand in no document.
inline constexpr CorrectionPrior correction_prior{
    .inertia = 0.04,
    .coulomb = 0.05,
    .viscous = 0.08,
    .coulomb_of_record = 0.03,
    .load = 0.05,     // of the Coulomb level: that of a measured ball screw (EMPS) is 15 %
    .gravity = 0.04,  // mass times lever, as an inertia is mass times lever squared
    .least = 0.02,    // of the usual effort
    .small_term = 0.02,
    .widest = 3,  // standard deviations: beyond that a number is a cause, not a correction
};

/// Physical ranges. Outside, a cause has no rung.
inline constexpr std::array physical_ranges{
    PhysicalRange{"sensor-offset", "scale", 0.8, 1.25, Per::scale,
                  "lines and gear teeth are counted: a scale is off by a slipping wheel or a unit, not by a half"},
    PhysicalRange{"supply-sag", "resistance", 0, 3, Per::winding,
                  "a source weaker than a third of the motor could not run it (maximum power at equal resistances)"},
    PhysicalRange{"frictional-memory", "A", 0, 0.25, Per::coulomb,
                  "direct effects of 0.005-0.02 beside friction of 0.3-0.7 are published for rock, metal, paper and "
                  "plastics (Dieterich 1979, Heslot 1994, Marone 1998), ten times that for no surface"},
    PhysicalRange{"frictional-memory", "B", 0, 0.25, Per::coulomb, "as A: they differ by less than either"},
    PhysicalRange{"frictional-memory", "L", 1, 1e9, Per::reading,
                  "a slip that the encoder does not resolve is not seen as slip: what acts there goes with the time at "
                  "rest"},
    PhysicalRange{"periodic-disturbance", "frequency", 2, 1e9, Per::period_of_record,
                  "less than two periods are a drift, not a period"},
    PhysicalRange{"cogging", "periods", 1.5, 1e9, Per::period_of_travel,
                  "a wave that does not come back within the travel is a slope or gravity"},
    PhysicalRange{"position-dependent-friction", "periods", 1, 1e9, Per::period_of_travel,
                  "a wave that does not come back within the travel is a trend"},
};

inline constexpr LadderRules ladder{
    .prior = correction_prior,
    .most_rungs = 4,       // no record of one joint has distinguished more causes
    .first_look = 40,      // causes
    .finalists = 5,        // causes; in 33 of 37 imperfect cases the right one led all others even without corrections
    .worth_a_rung = 0.02,  // of held-out mean log square: a hundredth of the RMS
    .of_the_rest = 0.15,   // of the squares that are left: less is what an imperfect form of another cause leaves
    .lost_in_a_fold = 0.25,  // of what it gains: a limit that one step reaches does nothing elsewhere; seen in one case
    .margin = 0.14,          // of held-out mean log square, i.e. 7 % of the RMS: rivals that near are model error apart
    .rows_of_margin = 60,    // four readings of 15 rows each, see rows_per_reading
    .ranges = physical_ranges,
    .far_off = 2,          // of twenty documents one is so far off in a given number
    .worth_telling = 0.1,  // of the squares: what a signal explains less of is the scatter of blocks, not a dependence
};

/// Of what is explainable beyond the corrections. Reason: a first rung that takes less is not "the effect".
inline constexpr double least_of_explainable = 0.5;
/// Of the whole gap, where corrections are all that is found. Reason: where most of the gap is left, it is not the
/// document's numbers that are wrong, though they may be a little wrong as well. Evidence: an encoder that drops
/// samples leaves three quarters of the gap, and none of that is a function of the signals; documents that are off by
/// 2-5 % and nothing else leave less than a fiftieth.
inline constexpr double least_of_gap = 0.5;
/// The same for several causes together where the first alone takes less. Reason: effects can be more than their sum.
inline constexpr double least_of_explainable_together = 0.8;
/// Part of the gap beyond the corrections that a ladder leaves, from which on a free force of the same signal as its
/// first rung, which takes more than half of that, means that the cause is only the nearest in shape. Evidence: a
/// cubic spring leaves more than a tenth behind gravity; other shapes of Stribeck curves and bristles leave less.
inline constexpr double nearest_in_shape = 0.12, taken_by_free_force = 0.5;
/// Of the gap beyond the corrections: where one cause leaves more of what is explainable, pairs get a search of their
/// own. Reason: effects can be more than their sum; less than that, climbing on finds the second.
inline constexpr double worth_a_search_of_pairs = 0.1;
/// Chance that a rung is not the cause although all that the ladder leaves is noise. Reason: twice that of a cause
/// which needs no corrections (`doubt_of_accepted`), since corrections may have taken over a part of another one.
inline constexpr double doubt_of_noise = 0.03;
/// What a rest adds to that, in proportion up to `nearest_in_shape` of the gap beyond the corrections; what the ladder
/// leaves of the explainable is added in full. Reason: another cause could be as near as the rest is large. Evidence:
/// in documents that are 2-5 % off the causes that left less than a hundredth were right, of those that left more than
/// `nearest_in_shape` some were a friction that no formula of the catalogue has.
inline constexpr double doubt_of_rest = 0.22;
/// Chance below which a further rung is not named where more than noise is left. Reason: what is less likely than not
/// would make the named set wrong more often than right; it stays in what remains. Evidence: in documents that are off
/// the right second rungs had 0.78 and more and the wrong one 0.30; on a measured ball screw a second rung beside the
/// published asymmetry had 0.22.
inline constexpr double least_chance_of_further_rung = 0.5;
/// Of what the corrections take of the gap, in squares: a rung that takes less, where more than noise is left or where
/// it is a small term that every machine has (`small_term`), is not named, and where none is left the document's
/// numbers are the answer. Reason: half as far as the corrections move the joint, such a cause is one of the small
/// things that every machine has (a ripple, an uneven winding), not what the gap comes from. Evidence: in a joint whose
/// four numbers were 2-9 % off and nothing else, a cogging of 1.7 % of the Coulomb level took 8 % of the gap beside
/// corrections that took 86 %. A number of the document itself stands however little it takes: it has a rung only where
/// it is further off than documents are. Evidence: a viscous friction of a tenth of the documented one took 9 % of the
/// gap, and all but 4 % of what corrections of inertia and Coulomb friction left. The same part of what a finding about
/// the controller takes lets causes in the mechanism stand with it first.
inline constexpr double least_against_corrections = 0.25;
/// Of what the causes of a ladder take: a number of the document that is `far_off`, and without which so much more
/// would be left, has a rung with them. Reason: what shrinks the gap by as much as a cause belongs to the answer,
/// whether it is called a cause or a document that is off; less, and it is one of the corrections that every joint
/// needs. Evidence: an inertia of 1.10 of its document took 32 % of a gap of which the periodic force that was named
/// alone took 44 %; in blind cases that look like machines all that a document is off by makes at most 0.44 of the
/// squares of the cause.
inline constexpr double as_much_as_causes = 0.5;
/// Odds of a rival against the named cause from which on the records cannot tell the two apart: one margin, over which
/// odds fall by e. Reason: what an answer calls indistinguishable must have its part of the probability. So
/// `ambiguous_with` goes by the same odds as the probabilities do, and a cause beside such a rival has
/// 1/(1 + 1/e) = 0.73 at most. Evidence: a cause at 0.985 "could not be told" from one with less than a thousandth
/// of that, since the one number came from the likelihood of all rows and the other from scores that noise cuts off.
inline constexpr double odds_of_indistinguishable = 0.368;  // 1/e
/// Chance that a finding of the controller's audit is not what differs. Reason: it is read off the command, the reading
/// and the reference alone, no model of the mechanism takes part, and it has to stand out from what the audited
/// controller leaves of the command; what can still stand in for it is another term of the same controller.
inline constexpr double doubt_of_finding = 0.02;
/// That such a finding is all that causes the gap, where more than noise is left and no effect was found for it.
/// Reason: the finding is certain, and as likely as not alone.
inline constexpr double finding_and_more = 0.5;
/// Chances that numbers of the document are all that is off: where only noise is left, and where more is.
/// Reason: several numbers together come near many causes.
inline constexpr double numbers_to_noise = 0.9, numbers_and_more = 0.6;
/// A correction is told as what is wrong with the document where leaving it out costs so much of what all of them take.
/// Reason: less is the share of a number that follows the others.
inline constexpr double worth_correcting = 0.05;

// Deciding between causes (verdict/, search/, heldout/) and the audit of the controller (audit/).

/// Of score: among causes this close the likelihood decides. Reason: scores of causes that explain to within noise are
/// those of the floor and tell nothing.
inline constexpr double margin_of_score = 0.02;

/// From evidence to probabilities: rows that count as one reading, and the width of the odds as a part of the best
/// score. Reason: innovations of a true joint would be white, every row a reading of its own; far above the floor
/// margins are model error, and grow with the best score itself. Evidence: the nine nearest ties in two draws of sealed
/// cases.
inline constexpr double rows_per_reading = 15, relative_temperature = 0.007;

/// Odds against a rival with one more parameter that gains nothing by it. Reason: it holds the winner as a special
/// case, and a true one would have used its parameter. Schwarz's √n for a thousand independent readings.
inline constexpr double needless_parameter = 30;

/// Chance that a cause is not the one although it is named: where what is left is noise, where it is not, and at most.
/// Reason: the answer is one of a catalogue, and the world has causes outside it. Evidence: the calibration of the
/// blind batches in docs/validation.md.
inline constexpr double doubt_of_accepted = 0.015, doubt = 0.15, most_doubt = 0.95;

/// Parts of the misfit beyond the noise at which a cause still counts as found although a rest remains: one cause, two,
/// backlash, and a single whose best partner hardly helps. Reason: stick-slip amplifies what two integrators do
/// differently; backlash leaves a little wherever its contact is not quite the simulated one; what a single leaves, and
/// no partner takes, is no second effect.
inline constexpr double explained_single = 0.97, explained_pair = 0.985, explained_by_backlash = 0.99,
                        explained_alone = 0.9;

/// Part of the misfit beyond the noise below which nothing is named. Reason: a cause that leaves more is one among
/// others.
inline constexpr double nameable = 0.75;

/// What a pair with backlash or a spring explains, and the part of that one's rest which its partner takes, for the
/// pair to be the answer. Reason: the contact of real backlash is none of those that can be simulated, so a rest
/// remains of both.
inline constexpr double completed = 0.94, taken_by_partner = 0.75;

/// Part explained from which on runs of the closed loop may accept a cause, and from which on one that acts nowhere by
/// itself has its signature. Reason: runs of the whole are noisy, and would let pass what predictions show to be wrong.
inline constexpr double mostly_explained = 0.9;

/// Of the mean square, on top of the noise floor, and standard deviations of repeated simulations: what still counts as
/// noise. Reason: two integrators differ, and a documented noise is a little off. Evidence: of 300 joints without an
/// effect none raised an alarm (docs/validation.md).
inline constexpr double slack_of_floor = 0.06, deviations_of_floor = 4;

/// Misfit in noise floors at the fastest level from which on a cause is not accepted whatever the noise. Reason: no
/// joint's own noise does this within a few rows.
inline constexpr double hopeless = 3;

/// Periods that a wave must show. Reason: before that it has not turned back and is a bend that other shapes make as
/// well.
inline constexpr double turned_back = 2.0 / 3;

/// How near to the end of its range a number is at its bound, as a part of it; how many times its usual size is
/// implausible; and the least usual size. Reason: a number at a bound is the search's, not the joint's.
inline constexpr double beside_bound = 0.001, implausible_size = 10, least_prior = 0.1;

/// Of the correlation between what an effect takes out of the residual and the residual, second by second; and the mean
/// square, in noise floors, from which on it acts there. Reason: half of the squares of a second are then the effect's.
inline constexpr double signature_correlation = 0.7, acting_square = 4;

/// Noise standard deviations from which on an effect of usual size could have shown itself. Reason: INTERFACE of
/// `insufficient-data`: five times the noise.
inline constexpr double shown = 5;

/// Probability at most of a cause that comes nearest and is not named. Reason: it is in the list for a reader to look
/// at.
inline constexpr double believed_unnamed = 0.1;

/// Part of the mean square beyond the noise: a named cause that leaves more on unseen data is withdrawn. Reason: it is
/// not what the gap comes from.
inline constexpr double mostly_left = 0.5;

/// Floors that nobody documented: an unsettled cause that leaves more is withdrawn. Reason: an estimated floor is off
/// by less. Evidence: of the unsettled causes in ten draws of sealed cases the one that left less than two was right,
/// the two that left more than seven were an inertia that changed with time.
inline constexpr double many_floors = 3;

/// Documented floors: an unsettled cause that leaves more has at most the probability behind it. Reason: a second
/// effect, or another one. Evidence: of ten unsettled causes in two draws of sealed cases the six that left less were
/// right, and the four that left more were wrong, or lacked a second effect.
inline constexpr double more_than_noise = 1.5, believed_doubted = 0.2;

/// Floors by which a simulation of whole records may be off without a gap. Reason: from row to row noise may hide what
/// adds up. Evidence: of 470 sealed joints without an effect none was further away than 1.25 floors.
inline constexpr double far_from_noise = 1.5;

/// Of the mean square: what runs of the closed loop may differ by beyond their own spread. Reason: so few runs (4) do
/// not know that spread better.
inline constexpr double slack_of_runs = 1.25;

/// Of the span, and standard deviations of a reading: what runs of one joint may differ by for their spread to be
/// noise. Reason: a simulation that is unstable or chaotic differs from itself by a good part of the motion, and
/// anything would then be within what it does.
inline constexpr double own_part = 0.02, own_readings = 20;

/// Mean square in noise floors, at the fastest and the middle observer bandwidth, and the part of the misfit beyond the
/// noise, at which a cause explains to within noise. Reason: as `slack_of_floor`, with room for numbers that are not
/// quite fitted; runs of the joint's own noise confirm it afterwards.
inline constexpr double accepted_fast = 1.12, accepted_middle = 1.15, accepted_part = 0.8;

/// Of score, a parameter. Reason: among thousands of rows a parameter that fits nothing but noise gains less.
inline constexpr double price_of_parameter = 0.003;

/// Of the mean square beyond the floor: the fastest observer bandwidth that shows so much screens the causes. Reason:
/// where a level shows less, noise decides the ranking.
inline constexpr double visible_excess = 0.3;

/// Of the limit: a command below it is the controller's own. Reason: logs round.
inline constexpr double below_limit = 0.999;

/// Of the usual speed: slower is standing, or slow. Reason: shares of regimes are for a reader; the words "stuck" and
/// "low speed" of the page mean this.
inline constexpr double standing = 0.005, slow = 0.2;

/// A gain this far from its document is a finding, and so is an added term that makes up this part of the command.
/// Reason: documents give three digits.
inline constexpr double flagged_gain = 0.004;

/// Misfit of the command over its rms: the digits of a file, and below which the controller is understood. Reason: logs
/// with five digits leave the first, a controller whose every term is known hardly more than the second.
inline constexpr double digits = 2e-5, understood = 2e-3;

/// Misfit over rms up to which a controller is judged at all; the multiple of it, and the least part, by which a gain
/// must then be off to be a finding. Reason: a controller between the samples of a slow log, or with a coarse output,
/// is reproduced roughly at best.
inline constexpr double rough_command = 0.05, rough_multiple = 5, rough_gain = 0.03;

/// Of the misfit without it: what a filter, a dead zone or a derivative part that no document tells must leave at most;
/// and the same of an undocumented term against free gains. Reason: a term that is there takes nearly all of what it
/// leaves out.
inline constexpr double much_less = 0.5, much_better = 0.25;

/// Times what every term together leaves, or what rounding makes: no further term is needed. Reason: terms share a
/// little of what rounding leaves.
inline constexpr double enough = 1.2;

/// Factor within which an undocumented gain agrees between records. Reason: a gain of the controller is the same in
/// all.
inline constexpr double agreeing = 2;

/// Of a plateau of the command: what the controller wanted must be more for it to be a limit. Reason: a reference that
/// rests makes plateaus as well.
inline constexpr double wanted_more = 1.01;

/// Of the rows: a regression that leaves more of them out as outliers says nothing. Reason: the majority is the rule.
inline constexpr double most_rows = 0.5;

/// Of the known reading error, below which a grid is not felt; of the documented step, and of the noise, above which a
/// grid is coarser than documented. Reason: a third of a step more is another converter; below half the noise no grid
/// is seen.
inline constexpr double felt_grid = 0.1, coarser_grid = 1.3, grid_over_noise = 0.5;

/// Part of the squares of a logged supply's drop that follows the current, and of the supply that the drop makes up.
/// Reason: a source with a resistance, and one that matters: two parts in a thousand are the digits of a voltmeter.
inline constexpr double supply_follows = 0.8, supply_matters = 0.002;

/// Of score, and of what the cause leaves: a force of free shape that is better by the larger of both says that the
/// cause is another one of the same signal. Reason: a free shape has more parameters, which gain a little from noise.
inline constexpr double least_of_free_force = 0.004, better_than_cause = 0.25;

/// Of the rows of a table of outcomes: what a law that is named may misjudge beyond rows that contradict each other,
/// and how many of those a table may have. Reason: who notes stick-slip by ear is now and then wrong; a law that misses
/// every eighth row is not that of the joint.
inline constexpr double most_misjudged = 0.12, most_contradicting = 0.15;

}  // namespace stickslip::gap::policy
