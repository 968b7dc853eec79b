// What decides between single causes and pairs, and what is never named (verdict/).
#pragma once

namespace stickslip::gap::policy {

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
/// Probability that a named single or pair is wrong. Reason: the catalogue is finite, and real causes may lie outside
/// it. Evidence: the calibration of the blind batches in docs/validation.md.
inline constexpr double doubt_of_accepted = 0.015;
/// Part of the misfit beyond the noise above which one cause may be all there is although a pair explains to within
/// noise: then the ladder tells. Reason: stick-slip amplifies the differences of two integrators. Evidence: in other
/// cases, of 26 values none lies between 0.943 and 0.977.
inline constexpr double explained_single = 0.97;
/// Difference of score by which a pair must be better than its best single where the single explains to within noise.
/// Reason: a second effect has to earn its place. Evidence: the one pair of other cases that was compared with it, two
/// causes that are there, is better by 3.06.
inline constexpr double worth_a_partner = 0.06;
/// The same where that single is backlash or a spring. Reason: a second effect has to earn its place, the more
/// so where the contact leaves a remainder in any case. Evidence: of two values in other cases, a needless partner of
/// backlash and a pair that is there, none lies between 0.0018 and 3.06.
inline constexpr double worth_a_doubted_partner = 0.15;
/// Part of the misfit beyond the noise. A cause that explains less is not simulated to see how much of what it leaves
/// is its own noise. Reason: it is one cause among others. Evidence: values lie on both sides (of 95 in 46 other cases
/// the nearest are 0.72 and 0.757), so that no gap supports it; the ladder gives the answer wherever more than noise is
/// left.
inline constexpr double nameable = 0.75;
/// Part explained above which closed-loop simulations may accept a cause, and above which a cause that acts nowhere by
/// itself has its signature. Reason: simulations of the whole loop are noisy and would accept causes that predictions
/// show to be wrong. Evidence: values lie on both sides (of 212 in 53 other cases the nearest are 0.871 and 0.9003), so
/// that no gap supports it.
inline constexpr double mostly_explained = 0.9;
/// Misfit in multiples of the prediction floor, at the fastest observer, above which a cause is rejected whatever the
/// noise. Reason: no joint's own noise reaches this within a few rows. Evidence: values lie on both sides (of 226 in
/// 115 other cases the nearest are 2.93 and 3.001), so that no gap supports it.
inline constexpr double hopeless = 3;
/// Periods of a wave that a record must contain. Reason: a shorter piece is a bend that other shapes describe as well.
/// Definition: a "wave" of a free shape, in place of a bend. In none of 71 other cases was a wave one of two free
/// shapes.
inline constexpr double turned_back = 2.0 / 3;
/// Multiple of the usual size of a parameter that is implausible. Reason: a document is wrong by a part of what it
/// states; ten times as much is something else. Evidence: in 50 cases of two other simulators, of 1953 values none is
/// above 8.8.
inline constexpr double implausible_size = 10;
/// Correlation, second by second, of the residual and what an effect takes out of it, from which on a second shows the
/// signature of the effect. Reason: half of the squares of such a second (0.7² = 0.49) are due to the effect.
/// Definition: "signature" on the page.
inline constexpr double signature_correlation = 0.7;
/// Mean square of what an effect makes, in multiples of the prediction floor, from which on it acts in a second.
/// Reason: where it makes less than twice the noise, noise decides. Definition: the seconds of "signature", those in
/// which the effect makes twice the noise.
inline constexpr double acting_square = 4;
/// Part of the seconds in which an effect acts that must have its signature. Reason: a second may be disturbed by
/// something else. Definition: "signature" on the page, which decides no name.
inline constexpr double most_seconds = 2.0 / 3;
/// Largest probability of a nearest cause that is not named. Reason: it is listed only as a hint, and the verdict is
/// unknown. Evidence: of 23 hints in answers of earlier versions to cases of other simulators five are the whole truth,
/// and of eleven that have this probability three. It is shown beside the hint and decides no name.
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
/// Multiple of the noise floor that a simulation of whole records may reach without a gap. Reason: noise may hide from
/// row to row what adds up over a record. Evidence: none of 470 blind joints without an effect exceeded 1.25.
inline constexpr double far_from_noise = 1.5;
/// Part of the gap that an unmodelled force must take to be told beside "unexplained". Reason: a hint at what is
/// missing has to explain most of the gap. Definition: the words "most of it follows the …", half.
inline constexpr double worth_a_hint = 0.5;

}  // namespace stickslip::gap::policy
