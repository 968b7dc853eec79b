// What the verdict of a ladder goes by: every threshold with its unit, its reason and the evidence for it. Rooms below
// take these numbers as arguments.
#pragma once
#include "analysis/diagnosis/ladder/rules.h"

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
    .rows_of_margin = 60,    // four readings of 15 rows each, see rows_per_reading of verdict.cpp
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
/// The same for several causes together where the first alone takes less: effects can be more than their sum.
inline constexpr double least_of_explainable_together = 0.8;
/// Part of the gap beyond the corrections that a ladder leaves, from which on a free force of the same signal as its
/// first rung, which takes more than half of that, means that the cause is only the nearest in shape. Evidence: a
/// cubic spring leaves more than a tenth behind gravity; other shapes of Stribeck curves and bristles leave less.
inline constexpr double nearest_in_shape = 0.12, taken_by_free_force = 0.5;
/// Of the gap beyond the corrections: where one cause leaves more of what is explainable, pairs get a search of their
/// own, since effects can be more than their sum. Less than that, climbing on finds the second.
inline constexpr double worth_a_search_of_pairs = 0.1;
/// Chance that a rung is not the cause although all that the ladder leaves is noise. Reason: twice that of a cause
/// which needs no corrections (verdict.cpp), since corrections may have taken over a part of another one.
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
inline constexpr double finding_and_more = 0.5;
/// Chances that numbers of the document are all that is off: where only noise is left, and where more is.
inline constexpr double numbers_to_noise = 0.9, numbers_and_more = 0.6;
/// A correction is told as what is wrong with the document where leaving it out costs so much of what all of them take.
inline constexpr double worth_correcting = 0.05;

}  // namespace stickslip::gap::policy
