// What decides the answers of tables of outcomes and of friction rigs (outcomes/, rig/).
#pragma once
#include <cstddef>

namespace stickslip::gap::policy {

/// Part of the rows of a table of outcomes that a named law may misjudge beyond contradicting rows. Reason: stick-slip
/// noted by ear is sometimes wrong; a law that misses every eighth row is not the joint's. Evidence: in the tests of
/// tables, of five laws none misjudges between 0.056 and 0.55.
inline constexpr double most_misjudged = 0.12;
/// Part of its rows that may contradict each other. Reason: a table of two joints is no table of one. Evidence: in the
/// tests of tables, of six values none lies between 0 and 0.33.
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
/// one wrong row would outweigh all others in a likelihood without it. Evidence: with half and with twice of this,
/// `amplitude_spread` and `worst_amplitude` together the tests of tables keep their answers. It bounds the cost of a
/// row at ln 100.
inline constexpr double wrong_rows = 0.02;
/// Spreads of a measured amplitude that it costs at most. Reason: as `wrong_rows`, of amplitudes. Evidence: as
/// `wrong_rows`. It bounds the cost of a row.
inline constexpr double worst_amplitude = 3;
/// Kinds of friction that explain a table alike from which on none of them is named. Reason: a choice among so many is
/// no answer. Definition: "insufficient data" of a table; an answer names one kind, or one of two.
inline constexpr double too_many_kinds = 3;
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
/// Probability of all laws of a rig together. Reason: the catalogue is finite. Evidence: the four rigs that were
/// answered with a law, two measured and two of another simulator, have it. A twentieth is left for laws outside the
/// catalogue; it scales every probability of a rig and decides no name.
inline constexpr double any_law_of_rig = 0.95;
/// Difference of the probabilities of stick-slip by two laws from which on a row is proposed as the next to measure.
/// Reason: less is no experiment. Definition: a row "worth measuring"; it decides whether a proposal is made, and no
/// name.
inline constexpr double least_apart = 0.3;
/// Held-out log-likelihood behind the likeliest law beyond which the motion of a law is not simulated. Reason:
/// amplitudes cost `worst_amplitude` a row at most, and so much is not made up for. Evidence: of 18 values in the tests
/// of tables none lies between 13.2 and 24.
inline constexpr double worth_following = 20;
/// Standard deviation of the logarithm of a measured amplitude, and its floor in the gap. Reason: a measurement that is
/// repeated differs by so much. Evidence: as `wrong_rows`. It scales what amplitudes say of a law.
inline constexpr double amplitude_spread = 0.15;
/// Distance to stick-slip within which the motion of a joint with memory is simulated. Reason: further away small and
/// large disturbances end alike. Evidence: values lie on both sides (of 426 in the tests of tables 253 within a factor
/// of two), so that no gap supports it; further rows cost a simulation each.
inline constexpr double near_stick_slip = 0.5;
/// Distance to the end of a law's range, as a part of it, within which a number of a law is implausible. Reason: as
/// `beside_bound`; the search among rows is coarser. Evidence: of 82 values in the tests of tables none lies between 0
/// and 0.08.
inline constexpr double beside_bound_of_law = 0.02;
/// Part of the travel by which the load point of a rig must go back for a turn. Reason: that is more than noise.
/// Evidence: a load point goes through it row by row, so that values lie on both sides; with half of it and with twice
/// of it two measured rigs keep their answers.
inline constexpr double turned_of_rig = 0.01;
/// Part of the normal load by which two runs must differ to tell what depends on it. Reason: less is the scatter of a
/// load cell. Evidence: of three values, two measured rigs and one in tests, none lies between 0 and 0.75.
inline constexpr double loads_of_rig_differ = 0.01;
/// Part of the travel, or of the time, that a rig's memory may take at most. Reason: a longer one would never have been
/// seen to fade. Evidence: with 0.25 and with 1 two measured rigs keep their answers, with 0.25 one of another
/// simulator as well. Sepiolite's record wants 43 mm, twenty times its travel, which is no answer.
inline constexpr double longest_memory_of_rig = 0.5;

}  // namespace stickslip::gap::policy
