// In one file: one method: the ways in which a motion of a sampled loop ends, with the numbers that separate them.
#include "analysis/simulation/sampled/cycles/loop_follow.h"

#include "analysis/base/work_limits.h"
#include "analysis/numerics/lasting.h"

#include <cmath>
#include <utility>

namespace stickslip {
namespace {

constexpr std::size_t block = 16;          ///< turns whose means are compared
constexpr double turning_into = 0.05;      ///< change of ln amplitude a turn, of a motion on its way to something else
constexpr std::size_t settling = 4;        ///< turns that a scaled motion gets to find back to its slow manifold
constexpr std::size_t short_block = 8;     ///< the same of turns that are nearly alike
constexpr double nearly_alike = 2e-5;      ///< their spread, per amplitude
constexpr double closed = 2e-6;            ///< change of a mean amplitude, what is still to come included, that is none
constexpr double small_turn = 1e-2;        ///< of V_0: speeds of a turn that the linear theory describes
constexpr double smallest_turn = 1e-7;     ///< of V_0: not distinguished from steady sliding
constexpr double alike = 0.25;             ///< by which a decay may miss the linear rate
constexpr double slow_growth = 4e-3;       ///< of ln amplitude a turn: slower motions are scaled, not waited for
constexpr double waits = 0.7;              ///< of the change over a block that the next one leaves
constexpr double jump = 0.4;               ///< of ln amplitude
constexpr double uneven_turns = 0.05;      ///< spread of amplitudes beyond which turns are not alike
constexpr double riding = 2;               ///< a whole motion over its mean turn, from which on it is the measure
constexpr double same_turn = 1e-3;         ///< to which turns of a period-n motion repeat
constexpr double same_of_spread = 0.02;    ///< the same, per their spread: ticks cut each of them elsewhere
constexpr std::size_t longest_repeat = 8;  ///< turns
constexpr double runaway = 1e9;            ///< of V_0
constexpr double patience = 60;            ///< turns without a crossing of V_0
constexpr int rounds_before_uneven = 12;   ///< blocks after which turns that are not alike are irregular

double speed_of(const LoopTurn& turn, double V0)
{
    return std::max(std::abs(turn.velocity_max - V0), std::abs(V0 - turn.velocity_min)) / std::abs(V0);
}

/// Means over the newest turns.
struct Means {
    double amplitude = 0, spread = 0;
};
Means means(const std::vector<LoopTurn>& turns, std::size_t skip, std::size_t count)
{
    Means m;
    double low = infinity, high = 0;
    const auto end = turns.end() - static_cast<std::ptrdiff_t>(skip);
    for (auto t = end - static_cast<std::ptrdiff_t>(count); t != end; ++t) {
        m.amplitude += t->amplitude() / static_cast<double>(count);
        low = std::min(low, t->amplitude()), high = std::max(high, t->amplitude());
    }
    m.spread = (high - low) / m.amplitude;
    return m;
}

/// After how many turns amplitudes come back, for each of the newest turns; 0 if they do not.
int turns_to_repeat(const std::vector<LoopTurn>& turns)
{
    if (turns.size() < 4 * 2) return 0;
    const double same = std::max(same_turn, same_of_spread * means(turns, 0, 4 * 2).spread);
    for (std::size_t n = 2; n <= longest_repeat; ++n) {
        bool repeats = turns.size() >= 4 * n;
        for (std::size_t i = turns.size() - 3 * n; repeats && i < turns.size(); ++i)
            repeats = std::abs(turns[i].amplitude() / turns[i - n].amplitude() - 1) < same;
        if (repeats) return static_cast<int>(n);
    }
    return 0;
}

}  // namespace

double CreepSearch::next(double at, double growth, double ahead)
{
    const bool grows = growth > 0;
    (grows ? below_ : above_) = {at, growth, true};
    const bool bracketed = below_.known && above_.known && below_.at < above_.at;
    if (!bracketed) return at + (grows ? jump : -std::min(jump, ahead));
    const double share = below_.growth / (below_.growth - above_.growth);
    return below_.at + std::clamp(share, 0.05, 0.95) * (above_.at - below_.at);
}

LoopFollower::LoopFollower(SampledLoop& loop, const std::vector<double>& steady, double origin,
                           const LoopFollowOptions& options)
    : watch(loop.frame(), origin),
      loop_(loop),
      steady_(steady),
      options_(options),
      V0_(loop.frame()),
      last_crossing_(loop.time())
{
    watch.reset(loop_.time());
    if (!options_.uneven) return;
    UnevenOptions uneven;
    uneven.V0 = V0_, uneven.tick = loop_.period();
    uneven.turn = options_.turn, uneven.held = options_.held, uneven.stays = options_.stays;
    uneven.decay = options_.decay, uneven.winds = options_.winds;
    uneven.steady_attracts = options_.steady_attracts;
    uneven.noise = options_.noise, uneven.lead = options_.lead, uneven.jitter = options_.jitter;
    uneven_.emplace(uneven);
}

LoopEnd LoopFollower::ended(LoopEnd::Kind kind, Reason reason) const
{
    LoopEnd end;
    end.kind = kind, end.reason = reason;
    end.turns = all_turns_, end.first_peak = first_peak_;
    return end;
}

/// Turns that go on as they are tell of the motion what twelve blocks of them would; others leave it open.
LoopEnd LoopFollower::cut_short() const
{
    if (uneven_) {
        LoopEnd end = uneven_->cut_short();
        end.cut_short = end.kind == LoopEnd::Kind::undecided;
        return end;
    }
    std::vector<double> sizes;
    for (const auto& turn : turns_) sizes.push_back(turn.amplitude());
    const bool like_steady = !turns_.empty() && options_.steady_attracts && speed_of(turns_.back(), V0_) < small_turn;
    if (!like_steady && lasts(sizes)) {
        if (const int repeats = turns_to_repeat(turns_); repeats > 1) return repeated(repeats);
        const bool alike = means(turns_, 0, turns_.size()).spread < uneven_turns;
        return measured(alike ? LoopEnd::Kind::cycle : LoopEnd::Kind::irregular, turns_.size());
    }
    LoopEnd end = ended(LoopEnd::Kind::undecided, Reason::not_converged);
    end.cut_short = true;
    return end;
}

/// The newest turns shrink as small disturbances do.
bool LoopFollower::decays_linearly() const
{
    if (turns_.size() < 4 || !options_.steady_attracts) return false;
    for (std::size_t i = turns_.size() - 3; i < turns_.size(); ++i) {
        if (!(speed_of(turns_[i], V0_) < small_turn)) return false;
        const double growth = std::log(turns_[i].amplitude() / turns_[i - 1].amplitude());
        const double expected = options_.decay * turns_[i].period();
        if (!(growth < 0) || !(std::abs(growth - expected) < alike * std::abs(expected))) return false;
    }
    return true;
}

/// The same of a motion that does not swing: an overdamped joint comes back to V_0 from one side, in no turns at all.
bool LoopFollower::dies_away()
{
    if (!options_.steady_attracts || !(options_.decay < 0)) return false;
    const double apart = 1 / std::abs(options_.decay);
    if (!(loop_.time() - last_crossing_ >= apart * static_cast<double>(excess_.size() + 1))) return false;
    const auto& j = loop_.motion.joint;
    excess_.push_back(j.velocity(loop_.motion.y.data(), j.link()) / V0_ - 1);
    if (excess_.size() < 4) return false;
    for (std::size_t i = excess_.size() - 3; i < excess_.size(); ++i) {
        if (!(std::abs(excess_[i - 1]) < small_turn)) return false;
        if (std::abs(excess_[i]) < smallest_turn) continue;
        if (!(std::abs(std::log(excess_[i] / excess_[i - 1]) + 1) < alike)) return false;
    }
    return true;
}

/// The newest turns are so much alike that short blocks tell the change a turn as well as long ones.
bool LoopFollower::repeats_evenly() const
{
    if (turns_.size() < skip_ + 2 * short_block) return false;
    if (speed_of(turns_.back(), V0_) < small_turn && options_.steady_attracts) return false;
    const Means both = means(turns_, 0, 2 * short_block);
    if (!(both.spread < nearly_alike)) return false;
    const double now = means(turns_, 0, short_block).amplitude;
    const double before = means(turns_, short_block, short_block).amplitude;
    return std::abs(std::log(now / before)) < closed * static_cast<double>(short_block) / static_cast<double>(block);
}

/// Of ln amplitude over the newest turn.
double LoopFollower::last_growth() const
{
    const auto n = turns_.size();
    return n < 2 ? missing : std::log(turns_[n - 1].amplitude() / turns_[n - 2].amplitude());
}

bool LoopFollower::on_its_way() const
{
    return !options_.uneven && (turns_.size() < 2 ? all_turns_ < 2 : std::abs(last_growth()) > turning_into);
}

void LoopFollower::scale_motion(double by)
{
    loop_.scale_about(steady_, by);
    watch.reset(loop_.time());
    turns_.clear();
    skip_ = settling;
    last_change_ = missing;
}

LoopEnd LoopFollower::measured(LoopEnd::Kind kind, std::size_t count) const
{
    LoopEnd end = ended(kind);
    auto first = turns_.end() - static_cast<std::ptrdiff_t>(std::min(count, turns_.size()));
    if (first == turns_.begin() && turns_.size() > 1) ++first;  // it began when the watch did, somewhere in a turn
    double time = 0, rest = 0, low = infinity, high = 0, squares = 0, left = infinity, right = -infinity;
    end.amplitude = 0, end.velocity_min = infinity, end.velocity_max = -infinity, end.cycle_peak = -infinity;
    for (auto t = first; t != turns_.end(); ++t) {
        end.amplitude += t->amplitude(), squares += t->amplitude() * t->amplitude();
        low = std::min(low, t->amplitude()), high = std::max(high, t->amplitude());
        left = std::min(left, t->position_min), right = std::max(right, t->position_max);
        time += t->period(), rest += t->rest_time;
        end.velocity_min = std::min(end.velocity_min, t->velocity_min);
        end.velocity_max = std::max(end.velocity_max, t->velocity_max);
        end.cycle_peak = std::max(end.cycle_peak, t->peak(V0_));
        end.reversed |= t->reversed;
    }
    end.velocity_min = or_rest(end.velocity_min, V0_), end.velocity_max = or_rest(end.velocity_max, V0_);
    const double n = static_cast<double>(turns_.end() - first);
    end.amplitude /= n;
    end.amplitude_spread = (high - low) / end.amplitude;
    const double swing = 0.5 * (right - left);
    if (kind == LoopEnd::Kind::irregular) {
        // a mean alone would pass for that of turns that are alike, and short turns may ride on a far larger swing
        end.jitter = std::sqrt(std::max(0.0, squares / n - end.amplitude * end.amplitude));
        if (swing > riding * end.amplitude) end.amplitude = swing;
    }
    // the cycle is all that repeats, as its period is
    if (kind == LoopEnd::Kind::period_n) end.amplitude = swing;
    end.period = time / n;
    end.stick_fraction = rest / time;
    return end;
}

LoopEnd LoopFollower::repeated(int turns) const
{
    const auto n = static_cast<std::size_t>(turns);
    LoopEnd end = measured(LoopEnd::Kind::period_n, std::min(4 * block, turns_.size() - 1) / n * n);
    end.repeats = turns;
    end.period *= turns;
    return end;
}

/// A slow integral is on its way beside the cycle and gets there within the limit of turns: scaled, it would begin
/// anew.
bool LoopFollower::waits_for_integral(const LoopTurn& turn) const
{
    constexpr double folds = 20;  // until nothing is left of it
    const double a_turn = options_.winds * turn.period();
    return a_turn * static_cast<double>(block) < 1 && a_turn * options_.turn_limit > folds;
}

/// An integral that gets there within the limit of turns has not yet found its level: turns that repeat each other, or
/// do not at all, go on changing with it.
bool LoopFollower::integral_on_its_way(const LoopTurn& turn) const
{
    constexpr double folds = 3;  // until a twentieth of its way is left
    const double a_turn = options_.winds * turn.period();
    return a_turn * options_.turn_limit > folds && a_turn * all_turns_ < folds;
}

std::optional<LoopEnd> LoopFollower::decide()
{
    const auto& last = turns_.back();
    // a displacement that has not yet reached the link of an unstable joint is no end
    if (speed_of(last, V0_) < smallest_turn && options_.steady_attracts) return ended(LoopEnd::Kind::steady);
    if (decays_linearly()) return ended(LoopEnd::Kind::steady);
    if (repeats_evenly()) return measured(LoopEnd::Kind::cycle, 2 * short_block);
    if (turns_.size() < skip_ + 2 * block || (turns_.size() - skip_) % block != 0) return {};
    ++blocks_;
    const Means now = means(turns_, 0, block), before = means(turns_, block, block);
    const double change = std::log(now.amplitude / before.amplitude), growth = change / static_cast<double>(block);
    const double ratio = change / last_change_;
    const double to_come = std::abs(ratio) < 0.95 ? std::abs(change * ratio / (1 - ratio)) : std::abs(change) * 20;
    // means of turns that the ticks cut differently differ by a share of their spread
    const double blur = now.spread / static_cast<double>(block);
    const bool still = std::abs(change) < closed || (to_come < closed && std::abs(change) < 100 * closed);
    const bool alternates = std::abs(change) < blur && std::abs(last_change_) < blur && now.spread < uneven_turns;
    const double before_change = std::exchange(last_change_, change);
    const bool rests = last.slowest(V0_) < 0.5 * std::abs(V0_);
    const bool like_steady = speed_of(last, V0_) < small_turn && options_.steady_attracts;
    // of the turns before those that were compared nothing is known: they may still have been on their way
    if (!like_steady && (still || (alternates && (blocks_ > 4 || rests)))) {
        // turns that take turns have a mean that stands still
        if (const int repeats = now.spread > uneven_turns ? turns_to_repeat(turns_) : 0; repeats > 1)
            return repeated(repeats);
        return measured(LoopEnd::Kind::cycle, still && std::abs(change) > closed ? block : 2 * block);
    }
    if (now.spread > uneven_turns && blocks_ >= rounds_before_uneven && std::abs(change) < now.spread &&
        !integral_on_its_way(last)) {
        const int repeats = turns_to_repeat(turns_);
        return repeats > 1 ? repeated(repeats) : measured(LoopEnd::Kind::irregular, 4 * block);
    }
    // what still shrinks from block to block gets there by itself, and sooner than a scaled motion
    if (ratio > waits && !waits_for_integral(last) && std::abs(growth) < slow_growth &&
        now.spread < 10 * std::abs(change) && !steady_.empty()) {
        const double at = std::log(now.amplitude);
        const double ahead = std::abs(0.5 * change * (change + before_change) / (change - before_change));
        scale_motion(std::exp(creep_.next(at, growth, ahead) - at));
    }
    return {};
}

std::optional<LoopEnd> LoopFollower::after_tick(bool moved)
{
    const auto& j = loop_.motion.joint;
    const bool gone = !(std::abs(j.velocity(loop_.motion.y.data(), j.link())) < runaway * std::abs(V0_));
    if (!moved || gone)
        return ended(LoopEnd::Kind::undecided, gone && !options_.uneven ? Reason::diverges : Reason::solver_failed);
    ++ticks_;
    return options_.uneven ? after_uneven_tick() : after_even_tick();
}

std::optional<LoopEnd> LoopFollower::after_even_tick()
{
    LoopTurn turn;
    if (watch.take(turn)) {
        if (std::isnan(first_peak_)) first_peak_ = turn.peak(V0_);
        turns_.push_back(turn);
        ++all_turns_;
        last_crossing_ = turn.t1;
        excess_.clear();
        if (auto end = decide()) return end;
    } else if (dies_away()) {
        if (std::isnan(first_peak_)) first_peak_ = watch.present().peak(V0_);
        return ended(LoopEnd::Kind::steady);
    } else if (!(loop_.time() - last_crossing_ < patience * options_.turn + 2 * options_.held)) {
        const auto& now = watch.present();
        if (std::isnan(first_peak_)) first_peak_ = now.peak(V0_);
        if (speed_of(now, V0_) < small_turn && options_.steady_attracts) return ended(LoopEnd::Kind::steady);
        last_crossing_ = loop_.time();
        excess_.clear();
        const bool slow = std::max(std::abs(now.velocity_min), std::abs(now.velocity_max)) < 0.01 * std::abs(V0_);
        if (slow && options_.stays) {
            LoopEnd held = ended(LoopEnd::Kind::held);
            held.stick_fraction = 1;
            return held;
        }
        watch.reset(loop_.time());
    }
    if (ticks_ < work::ticks_of_motion && all_turns_ < options_.turn_limit) return {};
    return ended(LoopEnd::Kind::undecided, Reason::not_converged);
}

std::optional<LoopEnd> LoopFollower::after_uneven_tick()
{
    const LoopTurn tick = watch.present();
    watch.reset(loop_.time());
    return uneven_->after_tick(tick);
}

}  // namespace stickslip
