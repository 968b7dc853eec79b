// What decides the findings of the audit of the controller (audit/).
#pragma once
#include <cstddef>

namespace stickslip::gap::policy {

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
/// `made_by_controller` for the documented structure beside a feed-forward that the document lacks. Reason: what moves
/// a joint is nearly a function of the reference whatever controller ran: only one that fed it forward leaves no rest.
/// Evidence: of seven records of a test machine under a feed-forward of acceleration, friction or both it leaves at
/// most 0.012, of twelve under a PID 0.011 to 0.34, where the PID itself leaves at most 0.0006 and is preferred.
inline constexpr double made_by_feed_forward = 0.02;
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
/// digits. Evidence: of 68 values in the tests of the audit none lies between 0.001 and 0.024, of 74 in 56 other cases
/// none between 0.0018 and 0.01.
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
/// too. Evidence: of 20 values in other cases and in the tests of the audit none lies between 1.1e-6 and 0.01.
inline constexpr double made_of_velocities = 2e-3;
/// Part of what the documented filter leaves of the command that logged velocities of another filter may leave, where
/// they are taken for the controller's own. Reason: velocities of a neighbouring tick come near, too, where the
/// velocity is a small part of the command. Evidence: of a simulated axis its own leave 0.0002, in a test 1e-13, those
/// of the tick before 0.14.
inline constexpr double of_own_velocities = 0.02;
/// Misfit of the command over its rms that is the digits of a file. Reason: logs with five digits leave this. Evidence:
/// values lie on both sides (of 413 in 134 other cases the nearest are 1.97e-5 and 2.05e-5), so that no gap supports
/// it.
inline constexpr double digits = 2e-5;
/// Misfit of the command over its rms below which the controller is understood. Reason: a controller whose terms are
/// all known leaves hardly more than digits and noise. Evidence: of 355 values in 134 other cases none lies between
/// 0.00066 and 0.0023.
inline constexpr double understood = 2e-3;
/// Misfit over rms up to which a controller is judged at all. Reason: a controller between the samples of a slow log,
/// or with a coarse output, can be reproduced only roughly. Evidence: of 20 misfits in the tests of the audit none lies
/// between 0.027 and 0.073, of 144 in 133 other cases none between 0.044 and 0.2.
inline constexpr double rough_command = 0.05;
/// Multiple of that misfit by which a gain must be off, or a term that the file lacks change the command, to be a
/// finding where the controller is reproduced only roughly. Reason: what is not reproduced may be a part of the gain.
/// Evidence: in two joints a feed-forward of the acceleration is 71 and 99 times what all changes leave, and those of
/// gains and rates that follow its jumps are 2.6 to 3.3 times that; behind filters of two poles velocity gains that are
/// right seem off by 2.9 and 4.3 times it; of nine further values in other cases and in tests none lies between 3.9 and
/// 104.
inline constexpr double rough_multiple = 5;
/// Least relative error of a gain that is a finding there, or in a log slower than its loop. Reason: as
/// `rough_multiple`. Evidence: in the tests of the audit gains of efforts that drive are off by 0.0001 or 0.5; in 19
/// slow logs of another generator gains that are as documented seem off by at most 0.015 beside a misfit below
/// `rough_command`, and wrong ones by 0.087 and 0.15.
inline constexpr double rough_gain = 0.03;
/// Part of a change of a gain or a term by which a record that tells it by itself may differ from all records together,
/// in a log slower than its loop. Reason: one controller ran in all records. Evidence: of another generator's slow logs
/// three joints have such a change, all of them truly; their nine records differ from all together by at most 0.07. A
/// test has gains that differ from record to record.
inline constexpr double alike_in_records = 0.5;
/// In a log slower than its loop: multiple of the noise that the controller makes of the encoder's, up to which the
/// logged commands are its own, and its commands from the positions alone drive the simulated joint. Reason: noise of
/// every fifth command, without that of the four between that cancels it, pushes the joint about. Evidence: 8 s of an
/// arm at 1 kHz, logged at 200 Hz with command and velocity: twice the noise remained with the true model, and it was
/// within noise as soon as both columns were removed.
inline constexpr double noise_of_commands = 2;
/// Part of the misfit without a term that an undocumented filter, dead zone or derivative term may leave at most; in a
/// log slower than its loop every change. Reason: a term that exists takes most of what its absence leaves. Evidence:
/// values lie on both sides (0.499 and 0.5002), so that no gap supports this number; with 0.4 and with 0.6 eight other
/// cases keep their answers. In slow logs of another generator the right change leaves at most 0.16 (4 joints), and
/// where the controller is as documented the best gain or filter at least 0.75 (24 joints).
inline constexpr double much_less = 0.5;
/// The same of any undocumented term compared with free gains. Reason: free gains imitate a part of a term. Evidence:
/// values lie on both sides (of 79 in 55 other cases the nearest are 0.227 and 0.273), so that no gap supports it.
inline constexpr double much_better = 0.25;
/// Where the joint file gives no period: part of the way from held to straight commands above which the motion says
/// that they are straight. Reason: halfway is nearer to neither. Evidence: simulated records of continuous loops lie at
/// 1.0, of sampled ones at 0.0, while nothing else is wrong.
inline constexpr double straight = 0.5;
/// Standard errors by which it must be above. Reason: a record of little motion says nothing of it. Evidence: of
/// estimates with normal errors, whose true value is `straight`, 2.3 % lie further above (closed form). In 142 other
/// cases two values were compared with it, both of one measured servo: -9.4 and 2.6.
inline constexpr double straight_errors = 2;
/// Multiple of what all terms together leave, or of rounding, below which no further term is needed. Reason: terms
/// share a little of what rounding leaves. Evidence: values lie on both sides (of 226 in 45 other cases 91 within a
/// factor of two, the nearest 1.198 and 1.27), so that no gap supports it.
inline constexpr double enough = 1.2;
/// Multiple of a plateau of the command that the unlimited controller must exceed for the plateau to be a limit.
/// Reason: a reference at rest makes plateaus, too. Evidence: in the tests of the audit the plateaus that are no limits
/// reach 0.9942.
inline constexpr double wanted_more = 1.01;
/// Part of the rows. A regression that leaves out more of them as outliers is rejected. Reason: the majority is the
/// rule. Evidence: in the tests of the audit all 1236 regressions use at least 0.988 of their rows.
inline constexpr double most_rows = 0.5;
/// Part of the squares of a logged supply's changes that the current must explain. Reason: a drop that follows
/// something else is not the source's resistance. Evidence: of 3000 simulated supplies without resistance that wander
/// by 10 mV to 0.5 V none reaches 0.67; of 1000 with 20 mohm to 1 ohm, read to 10 mV, 966 are above. In none of 142
/// other cases does a logged supply fall with the current.
inline constexpr double supply_follows = 0.8;
/// Mean square of what the first rows are off the prediction from rest, in squares of a reading's error, above which a
/// record may start in motion. Reason: five standard deviations in each of ten rows are no noise. Evidence: of 466
/// values in 139 other cases and in tests none lies between 8.8 and 28; the three at 28 (an encoder coarser than
/// documented) are refused by `left_by_motion`.
inline constexpr double missed_at_rest = 25;
/// Part of that mean square that a start in motion may leave. Reason: an unmodelled force that sets a joint in motion
/// leaves a sixth. Evidence: of 34 values in 21 other cases and in tests none lies between 0.064 and 0.82; two dirty
/// records that do begin in motion leave 0.052 and 0.063.
inline constexpr double left_by_motion = 0.1;
/// Median deviation of what a command has beyond its other terms, as a part of it, up to which it is what the integral
/// held at the start. Reason: an integral changes little over twenty rows. Evidence: of 58 values in 18 other cases and
/// in tests none lies between 0.081 and 0.25.
inline constexpr double held_at_start = 0.1;

}  // namespace stickslip::gap::policy
