// In one file: one method: the ways in which a motion that noise disturbs ends, with the numbers that separate them.
#include "analysis/simulation/sampled/cycles/uneven_follow.h"

#include "analysis/base/work_limits.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

// Evidence: 594 points of maps of five joints (a geared elbow, a linear stage, a direct-drive arm, a harmonic-drive
// wrist, a belt drive), each against a motion ten times as long under another seed. Outcomes differ at five of them:
// four have two cycles, of which either start takes one, and at one the link came to rest for a millionth of the time.
// Of 120 cycles whose amplitude noise scatters by less than 3 %, half agree to 1.3 % and four of five to 5 %.
constexpr int panes_of_turn = 2;
constexpr long fewest_ticks = 50;        ///< of a pane: noise takes that many to show its extrema
constexpr std::size_t first_panes = 12;  ///< in which the first peak is looked for, and by which rounds are counted
constexpr std::size_t fewest_panes = 4;  ///< of a stretch that tells alone: two turns
constexpr double alike = 0.1;            ///< by which ends of three stretches may differ, per amplitude, of cycles
constexpr double alike_noise = 0.3;      ///< the same where a small motion is all noise: its extrema differ as much
constexpr double roughly_alike = 0.5;    ///< the same of a motion that noise modulates, where no more ticks may follow
constexpr double would_show = 0.3;       ///< change of ln amplitude over a stretch of what is still on its way
constexpr double would_show_in_noise = 1;  ///< the same of small motions that are all noise
/// Of the growth that small motions have, in either direction: a cycle within 3 % of its amplitude grows by less, since
/// growth falls with the square of the amplitude. In a long time no more than the latter, of ln amplitude.
constexpr double still = 0.05, still_in_all = 0.03;
constexpr double standard_errors = 2;  ///< with which it is known
constexpr int fewest_rounds = 3;       ///< of a stretch whose mean amplitude has an error
constexpr double clear_of_noise = 30;  ///< of the noise: amplitude of cycles that it changes by some percent only
constexpr double integral_folds = 5;   ///< by which an integral has come to its level to a hundredth
/// Growth of ln amplitude that lifts a disturbance from far below the noise to what it leads to.
constexpr double out_of_noise_growth = 7;
/// Of V_0, of the speeds of a motion to which the linear loop applies: friction of memory departs from its slope by a
/// twentieth.
constexpr double linear_speed = 0.1;
constexpr double beyond_jitter = 2;      ///< of the jitter: amplitude of a motion that is more than that
constexpr double share_standing = 0.99;  ///< of a stretch of one long rest
constexpr double turns_held = 60;        ///< after which, and after what winds the spring up, a rest is for ever
constexpr int turns_at_most = 240;       ///< that are followed at least, however slowly the motion changes
constexpr double changes_at_most = 20;   ///< of ln amplitude by the linear rate, that are followed at least

}  // namespace

UnevenFollow::UnevenFollow(const UnevenOptions& options) : o_(options)
{
    const double unit = std::isfinite(o_.turn) ? o_.turn : 100 * o_.tick;
    pane_ = std::clamp(std::lround(unit / panes_of_turn / o_.tick), fewest_ticks, work::ticks_of_motion / 32);
}

Stretch UnevenFollow::newest(std::size_t count, std::size_t skip) const
{
    const std::size_t end = panes_.size() - skip;
    return panes_.sum(end - count, end);
}

UnevenFollow::Three UnevenFollow::three(std::size_t count) const
{
    Three t;
    for (std::size_t i = 0; i < 3; ++i) {
        t.part[i] = newest(count, (2 - i) * count);
        t.all.add(t.part[i]);
    }
    return t;
}

/// Of the speed in excess of V_0, per V_0.
double UnevenFollow::peak(const Stretch& s) const
{
    return std::max(std::abs(s.outer.velocity_max - o_.V0), std::abs(o_.V0 - s.outer.velocity_min)) / std::abs(o_.V0);
}

bool UnevenFollow::stands(const Stretch& s) const
{
    return s.outer.rest_time > share_standing * static_cast<double>(s.ticks) * o_.tick;
}

/// It has come to where only the jitter is left.
bool UnevenFollow::like_jitter(const Stretch& s) const
{
    const auto& j = o_.jitter;
    return j.known() && s.smooth() && s.outer.amplitude() < (1 + alike_noise) * j.amplitude &&
           s.outer.velocity_max - o_.V0 < (1 + alike_noise) * (j.velocity_max - o_.V0) &&
           o_.V0 - s.outer.velocity_min < (1 + alike_noise) * (o_.V0 - j.velocity_min);
}

/// What goes on and is no more than jitter about steady sliding: a cycle is larger, and faster than small motions.
bool UnevenFollow::only_jitters(const Stretch& s) const
{
    const bool larger = s.outer.amplitude() > beyond_jitter * o_.jitter.amplitude && peak(s) > linear_speed;
    return s.smooth() && o_.steady_attracts && !larger;
}

/// A motion that grows from small ones has had the time to leave the noise.
bool UnevenFollow::out_of_noise() const
{
    const double grown = o_.decay * static_cast<double>(ticks_) * o_.tick;
    return o_.steady_attracts || grown + o_.lead > out_of_noise_growth;
}

/// Small motions are those of the linear loop, and its multipliers tell that they decay: noise then keeps up no more
/// than it has made in this time, or would if it went on at the slow mode's own frequency until decay balances it.
bool UnevenFollow::small_and_linear(std::size_t count) const
{
    if (!o_.steady_attracts) return false;
    const Stretch s = newest(count);
    const double decayed = std::abs(o_.decay) * length(count);
    return s.smooth() && peak(s) < linear_speed * std::min(1.0, decayed);
}

/// Means of rounds change by less than small motions would in that time, and by a known amount: noise makes amplitudes
/// wander from round to round, until growth brings them back.
bool UnevenFollow::neither_grows_nor_fades(const Three& t, double between) const
{
    const double expected = std::abs(o_.decay) * between;
    const auto &first = t.part[0], &last = t.part[2];
    const double change = std::abs(std::log(last.size() / first.size()));
    if (std::min({first.rounds, t.part[1].rounds, last.rounds}) < fewest_rounds) {
        const bool clear = t.all.outer.amplitude() > clear_of_noise * o_.noise;
        return change < std::min(still * expected, still_in_all) &&
               0.5 * expected > (clear ? would_show : would_show_in_noise);
    }
    const double round = between / (0.5 * (first.rounds + 2 * t.part[1].rounds + last.rounds));
    const double wandering = std::min(between, 0.5 / std::abs(o_.decay)) / round;
    const double error = std::sqrt(t.all.changes / t.all.rounds * wandering) / t.all.size();
    return change < still_in_all && change + standard_errors * error < still * expected;
}

/// Three stretches of so many panes are as much alike as noise lets them, and what is still on its way would have
/// shown.
bool UnevenFollow::goes_on(const Three& t, std::size_t count) const
{
    const Stretch& all = t.all;
    const bool noise = only_jitters(all);
    const double apart = (noise ? alike_noise : alike) * all.outer.amplitude();
    for (const auto& s : t.part) {
        if (s.smooth() != all.smooth() || s.outer.reversed != all.outer.reversed || stands(s)) return false;
        if (!(all.outer.position_max - s.outer.position_max < apart)) return false;
        if (!(s.outer.position_min - all.outer.position_min < apart)) return false;
    }
    const bool wound = o_.winds * length(panes_.size()) > integral_folds && o_.winds * length(count) > would_show;
    if (o_.winds > 0 && !wound) return false;
    if (noise) return std::abs(o_.decay) * length(count) > would_show_in_noise;
    return out_of_noise() && neither_grows_nor_fades(t, length(2 * count));
}

std::optional<LoopEnd> UnevenFollow::decide() const
{
    const auto n = panes_.size();
    const double patience = turns_held * panes_of_turn + o_.held / length(1);
    if (static_cast<double>(n) > patience) {
        const Stretch long_ago = newest(static_cast<std::size_t>(patience));
        if (o_.stays && stands(long_ago)) {
            LoopEnd end = measured(long_ago);
            end.kind = LoopEnd::Kind::held, end.stick_fraction = 1;
            return end;
        }
    }
    if (n >= fewest_panes && like_jitter(newest(fewest_panes))) {
        LoopEnd end = measured(newest(fewest_panes));
        end.kind = LoopEnd::Kind::steady;
        return end;
    }
    for (std::size_t count = fewest_panes; count <= n; count *= 2)
        if (small_and_linear(count)) return measured(newest(count));
    // stretches of 2, 3, 4, 6, 8, 12, … panes, after one more that the motion has to settle
    for (std::size_t count = 2; 4 * count <= n; count += count % 3 == 0 ? count / 3 : (count + 1) / 2) {
        const Three t = three(count);
        if (goes_on(t, count)) return measured(t.all);
    }
    return {};
}

/// A round ends where the position turns upwards again, after turns by more than the amplitude: jitter makes none.
void UnevenFollow::follow_round(const LoopTurn& tick)
{
    if (rising_) {
        top_ = std::max(top_, tick.position_max);
        if (!(tick.position_min < top_ - turns_back_)) return;
        rising_ = false, bottom_ = tick.position_min;
        return;
    }
    bottom_ = std::min(bottom_, tick.position_min);
    if (!(tick.position_max > bottom_ + turns_back_)) return;
    const double size = 0.5 * (top_ - bottom_), time = static_cast<double>(ticks_) * o_.tick;
    Stretch round;
    round.rounds = 1, round.sizes = size, round.squares = size * size;
    if (last_size_ == last_size_) round.changes = (size - last_size_) * (size - last_size_);
    last_size_ = size;
    round.first_round = round.last_round = time;
    panes_.newest().add(round);
    rising_ = true, top_ = tick.position_max;
}

std::optional<LoopEnd> UnevenFollow::after_tick(const LoopTurn& extrema)
{
    Stretch tick;
    tick.outer = extrema, tick.ticks = 1;
    const bool slow = extrema.rest_time > 0;
    tick.rests = slow && !slow_;
    slow_ = slow;
    if (ticks_ % pane_ == 0) panes_.begin();
    ++ticks_;
    panes_.newest().add(tick);
    follow_round(extrema);
    if (ticks_ % pane_ != 0) return {};
    panes_.complete();
    turns_back_ = newest(std::min(panes_.size(), first_panes)).outer.amplitude();
    if (auto end = decide()) return end;
    const double at_most =
        std::max(static_cast<double>(turns_at_most * panes_of_turn) * length(1), changes_at_most / std::abs(o_.decay));
    const double time = static_cast<double>(ticks_) * o_.tick;
    if (ticks_ < work::ticks_of_motion && !(time > at_most)) return {};
    return cut_short();
}

/// Where small motions grow the joint does not slide steadily, and what has left the noise and goes on is what it does
/// instead, however noise modulates it. Otherwise a motion that rests or turns back goes on where it neither grows nor
/// fades.
LoopEnd UnevenFollow::cut_short() const
{
    LoopEnd open;
    open.reason = Reason::not_converged;
    const std::size_t quarter = panes_.size() / 4;
    if (quarter < fewest_panes || !out_of_noise()) return open;
    // the newest pane may be incomplete
    const Stretch before = newest(quarter, quarter + 1), now = newest(quarter, 1);
    Stretch both = before;
    both.add(now);
    const bool same = before.smooth() == now.smooth() && before.outer.reversed == now.outer.reversed;
    if (!same || stands(before) || stands(now) || (both.smooth() && o_.steady_attracts)) return open;
    const double change = std::min(std::abs(std::log(now.size() / before.size())),
                                   std::abs(std::log(now.outer.amplitude() / before.outer.amplitude())));
    const double expected = std::abs(o_.decay) * length(quarter);
    if (!(change < std::max(alike, roughly_alike * std::min(1.0, expected)))) return open;
    return measured(both);
}

LoopEnd UnevenFollow::measured(const Stretch& s) const
{
    LoopEnd end;
    const double time = static_cast<double>(s.ticks) * o_.tick;
    end.reversed = s.outer.reversed;
    const bool jitters = only_jitters(s);
    end.kind = jitters ? LoopEnd::Kind::steady : LoopEnd::Kind::cycle;
    end.first_peak = -infinity;
    for (std::size_t i = 0; i < std::min(panes_.size(), first_panes); ++i)
        end.first_peak = std::max(end.first_peak, panes_[i].outer.peak(o_.V0));
    end.amplitude = s.outer.amplitude();
    end.velocity_min = or_rest(s.outer.velocity_min, o_.V0);
    end.velocity_max = or_rest(s.outer.velocity_max, o_.V0);
    end.stick_fraction = s.outer.rest_time / time;
    if (jitters) return end;
    end.cycle_peak = s.outer.peak(o_.V0);
    if (s.rounds >= 2) {
        end.amplitude = s.size(), end.jitter = s.spread();
        end.amplitude_spread = 2 * standard_errors * end.jitter / end.amplitude;
        end.period = (s.last_round - s.first_round) / (s.rounds - 1);
        end.turns = s.rounds;
    } else if (s.rests > 1) {
        end.period = time / s.rests;
    }
    return end;
}

}  // namespace stickslip
