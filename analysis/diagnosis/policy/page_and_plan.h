// The words of the page, and how far a proposed motion may go beyond the records (plan/).
#pragma once

namespace stickslip::gap::policy {

/// Noise standard deviations that an effect of usual size must reach to be detectable. Reason: what hardly exceeds the
/// noise would be found in one record and not in the next. Definition: `insufficient-data` means that no effect of
/// usual size makes five times the noise.
inline constexpr double shown = 5;
/// Probability of the named cause from which on it is stated as a fact. Reason: a reader acts on it. Definition: the
/// words "comes from".
inline constexpr double stated_flatly = 0.9;
/// Probability from which on it is stated as probable. Reason: below a half the other causes together are likelier than
/// the named one. Definition: the words "probably comes from".
inline constexpr double stated_as_probable = 0.5;
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
/// a little. Evidence: of 80 values in eight other cases none is above 0.001.
inline constexpr double beyond_stroke = 0.05;
/// Multiple of the largest speed that the records have shown, up to which the simulated joint may go in a proposed
/// motion. Reason: what has not been shown may not be safe. Evidence: values lie on both sides (of 207 in 42 other
/// cases nine are above, from 1.12 to 1.22, and the nearest below is 1.09). It decides which motions are proposed, and
/// no name.
inline constexpr double beyond_speed = 1.1;
/// The same of the acceleration. Reason: breaking away is sharper than what a record's noise lets be seen. Evidence: of
/// 208 values in 43 other cases none lies between 1.62 and 2.41.
inline constexpr double beyond_acceleration = 2.2;
/// Part of the speed and acceleration of the records that a proposed reference uses. Reason: a closed loop overshoots.
/// Evidence: of 207 motions of 42 other cases that go by it 198 stay within `beyond_speed`.
inline constexpr double within_seen = 0.9;
/// Probability from which on a page says that the cause may not be listed. Reason: less is not worth a reader's time.
/// Definition: the words "that the cause is not listed".
inline constexpr double stated_none = 0.05;

}  // namespace stickslip::gap::policy
