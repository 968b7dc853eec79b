// What decides how records are read: noise, grids, times, and which rows of long records are fitted (records/,
// audit/).
#pragma once

namespace stickslip::gap::policy {

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
/// Seconds of a stretch at least. Reason: a stretch that is shorter than a motion holds only a part of it. Evidence: it
/// decides only above 10 kHz (`fitted`, `stretches_fitted`): at 20 kHz six stretches gave that friction as 0.1219.
/// Nothing was tried between it and half or twice as much.
inline constexpr double shortest_stretch = 1.5;
/// Relative RMS, over strides of 1 to 6 rows, by which white noise and the jerk of the motion miss what third
/// differences show, above which the noise has a memory. Reason: estimates of white noise agree to a hundredth or two.
/// Evidence: in the first records of 13 dirty cases (seed 2026112704) white noise leaves at most 0.033, coloured noise
/// 0.098 to 0.38.
inline constexpr double noise_not_white = 0.06;
/// Part of that RMS that noise with a memory may leave. Reason: a memory that explains less is not the noise's.
/// Evidence: in the same 13 cases noise with a memory leaves a third at most.
inline constexpr double noise_with_memory_leaves = 0.5;
/// Multiple of the documented step above which a grid is coarser than documented. Reason: a step larger by a third is
/// another converter. Evidence: in 50 cases of two other simulators, of 200 values none lies between 1 and 16.
inline constexpr double coarser_grid = 1.3;
/// Multiple of the documented noise above which a grid can be seen. Reason: noise of two steps hides them. Evidence: of
/// 15 values in other cases and in tests none is below 2.3.
inline constexpr double grid_over_noise = 0.5;
/// Multiple of what the encoder resolves (its step or its noise), peak to peak, up to which a position does not move.
/// Reason: of 16,000 readings of one position the largest and the least are so far apart (plus and minus four standard
/// deviations). Definition: "does not move" of a record.
inline constexpr double still = 8;
/// Ratio of the noise that readings show to the documented one, above which the estimate takes its place. Reason:
/// estimates of white noise agree to a hundredth or two (`noise_not_white`); a noise is documented for a type of
/// sensor. Evidence: of 259 values in 70 other cases and in tests none lies between 1.1 and 8.1.
inline constexpr double noise_believed = 1.25;
/// The same beside a grid that is coarser than documented. Reason: a coarse grid makes third differences of its own.
/// Evidence: of seven values in two other cases and in tests none is above 1.01.
inline constexpr double noise_beside_grid = 2;
/// The same of the rounding of an encoder step where no noise is documented. Reason: a step alone says nothing of
/// noise, and estimates agree to a hundredth or two. Evidence: of 35 values in eleven other cases and in tests none
/// lies between 0.74 and 1.027.
inline constexpr double noise_of_step = 1.02;
/// Rows below which a record is not judged. Reason: its noise is estimated from third differences and its misfit from
/// blocks of rows; both need some. Definition: "insufficient data" of a record.
inline constexpr double fewest_rows = 100;
/// Multiple of an estimated noise of the effort that counts as its noise. Reason: an estimate that is a little low
/// would make a gap of plain noise. Evidence: of 2000 simulated records of white noise 2.7 % have a lower estimate at
/// 5000 rows and a fifth at 1000, of 400 none at 20,000.
inline constexpr double doubted_estimate = 1.03;
/// Part of the effort's RMS that counts as noise of its own. Reason: a lag or a delay is written down in slightly
/// different ways. Evidence: the measured efforts of three records of one drive have noise of 0.019 to 0.27 of their
/// RMS; it matters for simulated efforts, which have less.
inline constexpr double model_noise_of_effort = 1e-3;
/// Part of a row by which the median step of a log may differ from a multiple of the loop's period for its stamps to be
/// moved to an even clock. Reason: a log of another rate has no such clock. Evidence: of 371 values in 138 other cases
/// none is above 0.001.
inline constexpr double whole_row = 0.05;
/// RMS scatter of stamps, part of a row, up to which they are moved to an even clock without asking the readings.
/// Reason: what is scattered by more may be uneven in truth: then readings decide. Evidence: of 62 values in 17 other
/// cases and in tests none lies between 0.05 and 0.18.
inline constexpr double jitter_unquestioned = 0.1;
/// Von Neumann's ratio of the deviations of stamps above which they scatter on their own. Reason: it is 2 where rows
/// scatter independently, and 0 where they wander as a clock does: halfway. Evidence: of 63 values in 17 other cases
/// and in tests none lies between 0.0007 and 1.84.
inline constexpr double scattered_stamps = 1;
/// Rows lost in a row up to which they are filled in; more are a hole at which a record is cut. Reason: what a joint
/// does between two readings is known for some tens of milliseconds. Evidence: of 2.4 million values in 90 other cases
/// none is above 6.1; in tests holes of 13 rows are filled in and one of 501 is not.
inline constexpr double most_lost_rows = 20;
/// Part of an encoder step below which noise moves a reading only in passing: then the noisiest record's noise is that
/// of all. Reason: a record that stands still between two steps shows none. Evidence: values lie on both sides (of 19
/// in other cases and in tests seven within a factor of two, the nearest 0.46 and 0.52), so that no gap supports it;
/// with twice of it the nearest joint without an effect (0.67) stays without a gap.
inline constexpr double seldom_a_step = 0.5;

}  // namespace stickslip::gap::policy
