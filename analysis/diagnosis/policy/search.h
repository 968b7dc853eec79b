// What the search for causes goes by (search/, fit/).
#pragma once

namespace stickslip::gap::policy {

/// Mean square in multiples of the prediction floor, at the fastest observer, up to which a cause explains to within
/// noise. Reason: as `slack_of_floor`, with room for parameters that are not fitted exactly; simulations of the joint's
/// own noise confirm it afterwards. Evidence: values lie on both sides (of 6,626 in 112 other cases 1,531 within a
/// factor of two), so that no gap supports it; with 1.06 and with 1.24 four other cases keep their answers.
inline constexpr double accepted_fast = 1.12;
/// The same at the middle observer. Reason: as `accepted_fast`; over a longer horizon the errors of parameters add up.
/// Evidence: values lie on both sides (of 12,703 in 112 other cases 503 within a factor of two), so that no gap
/// supports it.
inline constexpr double accepted_middle = 1.15;
/// Part of the misfit beyond the noise that a cause must explain for the same. Reason: a misfit that is hardly above
/// noise at all would be explained by anything. Evidence: values lie on both sides (of 205 in 48 other cases the
/// nearest are 0.799 and 0.801), so that no gap supports it.
inline constexpr double accepted_part = 0.8;
/// Part of the records that must be within `accepted_middle`. Reason: one record may hold a lost step or a noise that
/// is not documented, which the middle observer shows for longer. Evidence: records are few: shares are 0, a half, two
/// thirds and 1 in 112 other cases, and two of three suffice.
inline constexpr double most_records = 2.0 / 3;
/// Part of the mean square above the floor. The fastest observer that shows so much screens the causes. Reason: at an
/// observer that shows less, noise decides the ranking. Evidence: of 190 values in 114 other cases none lies between
/// 0.245 and 0.33.
inline constexpr double visible_excess = 0.3;
/// Difference of score by which an unmodelled force must be better to reject a cause. Reason: a free shape has more
/// parameters, which gain a little from noise. Evidence: values lie on both sides (of 48 in 34 other cases the nearest
/// are 0.0038 and 0.0046), so that no gap supports it.
inline constexpr double least_of_free_force = 0.004;
/// The same as a part of what the cause leaves. Reason: as `least_of_free_force`, where more is left. Evidence: of five
/// values in 12 blind cases (seed 4122) and eight in others none lies between 0.043 and 0.33.
inline constexpr double better_than_cause = 0.25;
/// Part of the misfit beyond the noise that a cause with a jagged misfit (backlash, a limit) must explain to be
/// searched for longer. Reason: long searches cost most of the time of an answer, and what explains less is not the
/// cause. Evidence: of four values in three other cases none lies between 0.031 and 0.61.
inline constexpr double worth_a_long_search = 0.5;
/// Part of its objective below which an observer takes over the parameters that another one found. Reason: a search may
/// have ended in a hollow that the others found the way out of; parameters of another horizon that are hardly better
/// are not. Evidence: in 50 cases of two other simulators, of 1946 values none is below 0.88.
inline constexpr double out_of_the_hollow = 0.8;
/// Difference of score from an accepted cause beyond which a cause is not refined. Reason: rivals matter within a tenth
/// of that (`margin_of_score`). Evidence: of 195 values in 28 other cases none lies between 0.21 and 0.28.
inline constexpr double far_behind = 0.25;
/// Score below which no better parameters are searched. Reason: so little is left that they would decide nothing.
/// Evidence: of 45 values in 34 other cases none lies between 0.036 and 0.054.
inline constexpr double clear_score = 0.04;
/// Mean square over the floor at which a block of rows begins to count less. Reason: a disturbance that no cause
/// explains must not decide all parameters. Evidence: with 10 and with 40 four other cases keep their answers. It
/// shapes every objective that is minimised.
inline constexpr double large_block = 20;
/// Multiple of the last change of what a limited command is made of, by which it must have jumped for the reference to
/// have jumped. Reason: a smooth way into a limit goes on as it came. Evidence: in the tests, jumps of a reference into
/// a limit are 2,200 times that and more; smooth ways were not compared.
inline constexpr double jump_into_limit = 4;

}  // namespace stickslip::gap::policy
