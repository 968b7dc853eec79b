// How candidates are searched: a first look on excerpts of the records, then all levels on all data.
#pragma once
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/search/attribute.h"

#include <vector>

namespace stickslip::gap {

inline constexpr std::size_t brief_ticks = 24000;  ///< of all records together, for a first look
inline constexpr double coarse = 2;                ///< numerical: and time steps longer by this
inline constexpr int full_effort = 25;             ///< evaluations a parameter where the misfit is jagged
inline constexpr int iterations = 12;

bool jagged(const Candidate& candidate);
/// Whether it divides the mass, or edits what lies between two.
bool two_mass_edit(const Candidate& candidate);
/// Whether it makes two masses of a joint documented as one: ten times as slow as the others.
bool divides_mass(const Candidate& candidate);
/// Whether it moves the encoder of a joint documented as one mass behind its transmission.
bool moves_encoder(const Candidate& candidate);
/// Whether it gives two known masses backlash: where the link rests within it is history, which excerpts cut off, and a
/// wrong flank at their start outweighs the right width. Such a candidate is looked at on whole records.
bool needs_history(const Candidate& candidate);
/// About how long a candidate takes to fit, against others.
double cost_of(const Candidate& candidate);
/// Neighbours in groups of at most so many, of which none costs more than so many usual ones, unless it is one alone;
/// the dearest group first: what takes longest must not begin last.
std::vector<std::vector<std::size_t>> in_groups(std::span<const double> costs, std::size_t most);
bool better(const Attribution& a, const Attribution& b);

inline constexpr std::size_t refine_ticks = 45000;  ///< of all records together, for all levels

/// One descent, or a search of `effort` evaluations a parameter where the misfit is jagged.
LevelFit improve(const FitProblem& problem, const Eigen::VectorXd& x, int effort, int descents = iterations);

Fitting<LevelFit> improving(FitProblem problem, Eigen::VectorXd x, int effort, int descents = iterations);

/// The number of the best of these starts.
Fitting<std::size_t> nearest_start(FitProblem problem, std::vector<Eigen::VectorXd> from);

/// The best of descents from the given starts. With many starts, or a jagged misfit, all are evaluated
/// and the two best go on, or the best of each value that the form wants apart.
LevelFit best_of(const FitProblem& problem, const std::vector<Eigen::VectorXd>& from, int effort = full_effort,
                 int descents = iterations);

/// The descents that it is the best of, to be run beside others, and the best of what they came to.
std::vector<Fitting<LevelFit>> fits_from(const FitProblem& problem, const std::vector<Eigen::VectorXd>& from,
                                         int effort = full_effort, int descents = iterations);
LevelFit best_of(std::span<LevelFit> fits);

/// A candidate as it stands after a first look: judged on all data, everywhere at the same parameters.
Attribution as_screened(const Fit& fit, const Candidate& candidate, const LevelFit& screened);

/// Carries the best `most` through all levels, fastest first. Once one of the first few is accepted, those far behind
/// it are left as they are.
void refine_best(const Fit& fit, std::vector<Attribution>& ranked, std::size_t most);

/// Searches all numbers of the best `most` refined candidates with a jagged misfit at once, fastest level first: what
/// is fitted in turn creeps along the valley in which backlash, shares of the mass and a partner make up for each
/// other. Those that explain little are left as they are, those far behind at the fastest level are left there.
void polish_best(const Fit& fit, std::vector<Attribution>& ranked, std::size_t most);

/// The fastest level at which the nominal joint clearly fails: there a fit is least troubled by what stick-slip
/// amplifies.
double screening_level(const Nominal& nominal);

}  // namespace stickslip::gap
