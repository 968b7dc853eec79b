// With how much care a lane searches its cycle: roughly first, then finer, turn by turn or more exactly, where the
// answer asks for it.
#include "analysis/simulation/lanes/lane_program.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::lanes {
namespace {

/// A rough search counts where every turn loses more than that of its amplitude. Elsewhere a fold or the linear
/// boundary is near, and tolerance decides. Evidence: over the 61 × 61 gains of the bistable strip
/// (examples/03-bistable-strip) every outcome and region is that of searches that are all fine and every number within
/// 2·10⁻⁵ of theirs; with all rough searches accepted an overshoot is off by 0.4 %.
constexpr double clear_decay = 0.95;
/// The same of a coarse search: a cycle keeps all of its amplitude, and turns near it nearly all. Evidence: of 15,042
/// joints, 1,405 of them bistable (random ones and heavy ones under the slip and the ageing law, the bistable strip
/// under both), every ending is that of searches that are all fine.
constexpr double coarse_decay = 0.8;
constexpr double rough_closure = 1e-4;  ///< as `closure`
/// Tolerance of the turn before, beside that of the sweep: it costs 0.6 of a turn of the sweep's and leads so near that
/// one of these mostly closes the cycle. Evidence: 398 lane steps a point of the 200 joints of the benchmark, 434
/// without.
constexpr double nearness = 10;
constexpr double refined = 1e-2;  ///< largest step of a refinement, per amplitude
constexpr int most_refinements = 5;
constexpr double weak_swing = 1;  ///< e-folds of speed, up to which a motion counts as weakly nonlinear
/// Of the growth of a turn, per tolerance. Evidence: next to the basin of two joints (ageing law, k_v 44 and 44.6 N·s/m
/// of the test of basins) growths at 1e-8 are off by 1.1e-7 from those of Rodas5P at 1e-12.
constexpr double growth_error = 10;
/// Where the return map hardly contracts, a turn must be known as much better, beside the tolerance of the sweep.
constexpr double exactness = 1e-2, least_tolerance = 1e-12;

}  // namespace

double Program::tolerance() const
{
    if (care_ == Care::coarse) return settings_->coarse;
    if (care_ == Care::rough) return settings_->rough;
    if (care_ == Care::nearing) return std::min(settings_->rough, nearness * settings_->rtol);
    return care_ == Care::exact ? std::max(exactness * settings_->rtol, least_tolerance) : settings_->rtol;
}

Action Program::all_again(Care care)
{
    care_ = care;
    return follow(phase_ == Phase::search ? job_->rest_start : job_->start);
}

/// With more care where there is more: secants that lead past the ghost of a cycle come back from it for ever, and turn
/// by turn the motion leaves it behind.
Action Program::with_more_care()
{
    if (care_ == Care::coarse) return all_again(Care::rough);
    if (care_ == Care::rough || care_ == Care::nearing || care_ == Care::refining) return all_again(Care::fine);
    return care_ == Care::fine && phase_ == Phase::search ? all_again(Care::patient) : give_up();
}

/// Whether every turn has lost so much that errors of this tolerance cannot have hidden a cycle.
bool Program::clearly_decays() const
{
    if (care_ == Care::coarse) return weakest_decay_ < coarse_decay;
    return care_ != Care::rough || weakest_decay_ <= clear_decay;
}

/// How a search for a coexisting cycle begins: as carelessly as what small disturbances lose in a turn allows.
Program::Care Program::first_care_of_search() const
{
    const double linear = std::exp(linear_growth());
    if (settings_->rough <= settings_->rtol || linear >= clear_decay) return Care::fine;
    return settings_->coarse > settings_->rough && linear < coarse_decay ? Care::coarse : Care::rough;
}

/// The cycle is closed again from here on with that care.
void Program::refine(Care care)
{
    care_ = care;
    refinements_ = 0;
    secants_.change_map();
}

/// Whether what a turn leaves of a distance is too near to all of it for the errors of a turn.
bool Program::weakly_contracting() const
{
    return secants_.multiplier() >
           (care_ == Care::exact ? 1 - exactness * (1 - uncertain_multiplier) : uncertain_multiplier);
}

/// Whether the motion is followed into what it ends in, turn by turn, and no secant may take it elsewhere.
bool Program::in_basin() const
{
    return phase_ == Phase::stated || care_ == Care::patient;
}

/// Where the next turn starts, after one from turn_start_ to `end`.
SecantSearch::State Program::next_turn(Point end, Point& start)
{
    if (in_basin()) return secants_.next_in_basin(turn_start_, end, start);
    secants_.use_one_secant(map_of_line());
    if (care_ == Care::nearing || care_ == Care::refining || care_ == Care::exact) {
        const auto state = secants_.refine(turn_start_, end, start);
        const bool near = length(start - turn_start_) < refined * length(end);
        if (near && care_ == Care::nearing) {
            refine(Care::refining);
            return SecantSearch::State::searching;
        }
        return near && ++refinements_ <= most_refinements ? state : SecantSearch::State::lost;
    }
    weakest_decay_ = std::max(weakest_decay_, length(end) / length(turn_start_));
    if (care_ == Care::coarse && !clearly_decays()) return SecantSearch::State::lost;
    const double close = care_ == Care::rough ? rough_closure : closure;
    return secants_.next(turn_start_, end, phase_ == Phase::search, start, close);
}

/// What the turns of a disturbance of stated size have told of its end, where they lie on a line.
BasinSide::Told Program::told_by_turns(Point end, Point& start)
{
    if (phase_ != Phase::stated || !map_of_line()) return BasinSide::Told::nothing;
    if (none_smaller(end)) return BasinSide::Told::decays;
    const bool weak = std::max(answer_.w_max, -answer_.w_min) < weak_swing;
    const auto told = basin_.after(turn_start_, end, linear_growth(), growth_error * settings_->rtol, weak, start);
    if (basin_.moved()) secants_.forget();
    return told;
}

/// Whether turns as long as the last one map a line onto itself.
bool Program::map_of_line() const
{
    const auto& g = job_->groups;
    return largest_determinant(answer_.period, g.c, g.M) <= off_the_line;
}

/// Growth a turn of a small disturbance, e-folds; without bounds where it does not turn.
double Program::linear_growth() const
{
    return 2 * std::numbers::pi * job_->rate / job_->frequency;
}

/// Of motions that turn about steady sliding and change speed by less than e: smaller ones are weakly nonlinear.
bool Program::none_smaller(Point end)
{
    const double swing = std::max(answer_.w_max, -answer_.w_min);
    if (!(swing < weak_swing) || !smaller_.none(turn_start_, end, linear_growth())) return false;
    weakest_decay_ = std::max(weakest_decay_, std::exp(linear_growth()));
    return true;
}

}  // namespace stickslip::lanes
