// What decides the answer of a ladder: which rungs are named, with which probability (verdict/).
#pragma once

namespace stickslip::gap::policy {

/// Part of the explainable gap beyond the corrections that the first rung must take. Reason: a cause that takes less is
/// not the main cause. Evidence: in other cases, of eight values none lies between 0.3 and 0.64.
inline constexpr double least_of_explainable = 0.5;
/// Part of the whole gap that the corrections must take to be the answer on their own, and a load that no file states
/// to be climbed to as a cause. Reason: if most of the gap
/// remains, wrong parameters are not its cause, even if they are slightly wrong. Evidence: an encoder that drops
/// samples leaves three quarters of the gap, which is no function of the signals; a joint file that is 2-5 % off and
/// nothing else leaves less than a fiftieth.
inline constexpr double least_of_gap = 0.5;
/// The same as `least_of_explainable`, for several causes together where the first alone takes less. Reason: two
/// effects can explain more together than the sum of both alone; causes without a main one have to take nearly all.
/// Evidence: in three of 162 other cases the first of several rungs takes less than `least_of_explainable`; together
/// they take 0.83, 0.84 and 0.99, and one of these answers is right, while each of the others has one true cause.
/// It guards against answers of many small parts.
inline constexpr double least_of_explainable_together = 0.8;
/// Part of the gap beyond the corrections that a ladder may leave. If it leaves more and an unmodelled force of the
/// same signal as the first rung takes more than `taken_by_free_force` of that, the named cause is only the nearest in
/// shape, and the verdict is unknown. Reason: the right signal with the wrong curve is not the right cause. Evidence: a
/// cubic spring leaves more than a tenth behind gravity; Stribeck curves and bristles of another shape leave less.
inline constexpr double nearest_in_shape = 0.12;
/// Part of what the ladder leaves that an unmodelled force must take for the same. Reason: what a force of the same
/// signal does not take has another cause. Evidence: of three values in other cases none lies between 0 and 0.68.
inline constexpr double taken_by_free_force = 0.5;
/// Part of the gap beyond the corrections that a ladder may leave whatever an unmodelled force takes of it. Reason: the
/// force says that something small remains, not that what took nearly all is another cause. Evidence: a constant load
/// on a joint with a little cogging and asymmetry left 0.0006, and a force of the position was clearly better at that;
/// where such a force refuted a wrong cause (docs/validation-history.md) a tenth and more was left.
inline constexpr double all_but_explained = 0.01;
/// Part of the gap beyond the corrections. If one cause leaves more of the explainable gap, pairs are searched. Reason:
/// two effects can explain more together than the sum of both alone; below this part the next rung finds the second.
/// Evidence: of nine values in nine other cases none lies between 0.09 and 0.167.
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
/// Part of the whole gap that a second or later rung must take where more than noise remains. Reason: what takes less
/// is no cause of the gap; it follows the shape of what the first one only resembles, and stays in the remainder.
/// Evidence: of 70 rungs in answers to two sets of other cases those below 0.007, of four cases, are wrong, the next,
/// right, is at 0.022.
inline constexpr double least_of_further_rung = 0.01;
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
/// Part of a cause's size from which on another effect that its form mixes in is a rival with as much of the odds: a
/// lag in dead times, a dead time in time constants. Reason: an actuator of several poles is late by a dead time and a
/// lag that stand in for it together, and neither name is surer than its share. Evidence: a current loop of second
/// order was a dead time with a lag of 0.67 of it (`delay` at 0.96); two equal poles are a lag with a dead time of 0.37
/// of it, and a delay that is smeared over a bus has no lag.
inline constexpr double as_much_the_other = 0.5;
/// Probability that a finding of the controller's audit is wrong. Reason: it follows from command, reading and
/// reference alone, without a model of the mechanism, and has to exceed what the audited controller leaves of the
/// command; only another term of the same controller can imitate it. Evidence: the four findings with this probability
/// in other cases (k_p, k_v, a grid, a filter) are right.
inline constexpr double doubt_of_finding = 0.02;
/// Probability that such a finding is the only cause, where more than noise remains that neither an effect nor numbers
/// of the document were found for. Reason: the finding is certain, and as likely as not alone. Evidence: in some 180
/// answers to other cases one has this probability, an encoder's coarser step, and is right. A half says that nothing
/// is known of other causes; a ladder that is likelier stands before the finding.
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
/// that much. Reason: a parameter that only follows the others costs less. Evidence: in 50 cases of two other
/// simulators, of five values none lies between 0.0096 and 0.26.
inline constexpr double worth_correcting = 0.05;
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
/// Largest probability of the last rung of a ladder that leaves more than noise while a correction stands at its bound.
/// Reason: what holds a number of the document back bends all that is fitted with it, and the rest says that something
/// is missing. Evidence: of 48 answers to cases by a simulator of another's making two ladders are of this kind (a dead
/// zone in the drive, two constants of a motor at once): both are wrong, at 0.94 and 0.43; none of the 40 right ones
/// is. Two are few, hence no less than a half.
inline constexpr double believed_held_back = 0.5;
/// Probability that none of the catalogue is the cause, above which the only cause of a ladder is not named. Reason: a
/// cause is no answer beside one that is likelier. Definition: likelier than all causes together, a half.
inline constexpr double likelier = 0.5;
/// Findings of the audit from which on the record is called that of another joint and nothing else is concluded.
/// Reason: encoder and controller of one machine are set one by one, and seldom three of them wrongly. Evidence: of 141
/// values in 141 other cases none is above 2.
inline constexpr double findings_of_another_joint = 3;

/// Smallest readings (a step of the encoder, or its noise) up to which a slip length is not resolved. Reason: a memory
/// fades over a few slip lengths, and what fades between a few readings is a steady curve to them. Evidence: of three
/// curves without memory that other simulators made it was 1.0, 1.2 and 8; of five memories 20 (an ageing law whose
/// numbers were right to 2 %) and 126 to 400.
inline constexpr double resolved_slip = 12;

}  // namespace stickslip::gap::policy
