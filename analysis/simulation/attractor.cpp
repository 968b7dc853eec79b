#include "analysis/simulation/attractor.h"

#include "analysis/simulation/mode.h"
#include "analysis/simulation/repeats.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace stickslip {
namespace {

constexpr double settled_distance = 1e-6;    ///< of steady sliding, in units of the flow's scale
constexpr double alike = 0.05;               ///< gap of two turns, per amplitude, from which shooting is tried
constexpr double closed = 1e-7;              ///< gap of a closed orbit, per amplitude
constexpr double longest_turn = 1e4;         ///< of which a turn is given up, in times of the slowest linear rate
constexpr double shortest_turn = 1e-6;       ///< in times of the fastest linear rate: less is rounding on the section
constexpr double watched = 1e-8;             ///< the same for a motion that is only watched, at the noise of its steps
constexpr double no_rate = 1e-14;            ///< per largest rate
constexpr double by_the_linear_rate = 0.02;  ///< relative difference to the spectral abscissa
constexpr int linear_turns = 20;             ///< in succession at that rate: the rest of the decay is known
constexpr int most_idle_turns = 10;          ///< in succession: what happens lies below what doubles tell apart
/// Growth of the amplitude per turn (its logarithm) below which a turn is followed more finely, what such a turn is
/// followed to, and the growth that its errors may be taken for.
constexpr double fine_growth = 1e-3, fine_rtol = 1e-12, no_growth = 1e-10;

constexpr double runaway = 1e12;  ///< speed in units of V_0: no slip reaches it

/// Contraction of a turn, 1 − |μ|, that the variational equations of shooting resolve.
constexpr double clear_contraction = 1e-5;
constexpr double located = 1e-4;        ///< of an amplitude that growth turns at
constexpr double inward = 0.9;          ///< of a step towards an amplitude that growth seems to turn at further in
constexpr int most_settling = 8;        ///< turns that a scaled motion gets to forget how it was scaled
constexpr double settled_growth = 0.3;  ///< change of growth, relative, of one that has
constexpr int settling_turns = 60;      ///< before a motion that neither closes nor settles is tested for repeats

/// The longest time that bodies stick [s]: V_0 winds the springs up from what pushes them back to what drives them on.
/// Such a phase has a closed form, however long it is.
double wind_up_time(const Flow& flow)
{
    double force = 0, compliance = 1 / std::abs(flow.gain());
    if (const auto* sliding = dynamic_cast<const SlidingFlow*>(&flow)) force = sliding->static_force();
    if (const auto* chain = dynamic_cast<const ChainFlow*>(&flow)) {
        for (int i = 0; i < chain->bodies; ++i) force += chain->body[i].ratio * static_force(chain->body[i].friction);
        for (int i = 1; i < chain->bodies; ++i) compliance += 1 / std::abs(chain->loop.stiffness_at(i - 1, i));
    }
    const double time = 2 * force * compliance / flow.commanded_velocity();
    return std::isfinite(time) ? time : 0;
}

/// The smallest |s| of a mode and the largest Re s; states that do not evolve are no modes.
struct LinearRates {
    double slowest = infinity, fastest = 0, abscissa = -infinity;
};
LinearRates linear_rates(const Flow& flow)
{
    FlowMatrix J;
    flow.jacobian(flow.steady(), J);
    const Eigen::VectorXcd modes = J.eigenvalues();
    const double largest = modes.cwiseAbs().maxCoeff();
    LinearRates rates;
    rates.fastest = largest;
    for (const auto& s : modes)
        if (std::abs(s) > no_rate * largest) {
            rates.slowest = std::min(rates.slowest, std::abs(s));
            rates.abscissa = std::max(rates.abscissa, s.real());
        }
    return rates;
}

/// The bookkeeping of one motion.
class Follower {
  public:
    Follower(const Flow& flow, bool steady_attracts, const FollowOptions& options)
        : flow_(flow),
          options_(options),
          steady_attracts_(steady_attracts),
          scale_(flow.scale()),
          steady_(flow.steady()),
          motion_(std::make_unique<SlidingMotion>(flow, options.solver, options.rtol))
    {
        const auto rates = linear_rates(flow);
        turn_limit_ = longest_turn / rates.slowest + wind_up_time(flow);
        abscissa_ = rates.abscissa;
        least_turn_ = shortest_turn / rates.fastest;
    }

    Attractor run(const FlowVector& y);

  private:
    double distance(const FlowVector& a, const FlowVector& b) const
    {
        return (a - b).cwiseQuotient(scale_).cwiseAbs().maxCoeff();
    }
    Attractor ended(Attractor::Kind kind, Reason reason = Reason::none);
    Attractor from_turn(const Turn& turn);
    bool shoot(const FlowVector& guess);
    bool makes_turn(const Cycle& cycle) const;
    void refine();
    void start_anew(const FlowVector& y);
    bool jump(double growth);
    double still_amplitude(double growth) const;
    double amplitude() const { return distance(points_.back(), steady_); }
    bool repeats();
    bool wild() const;
    bool smooth(const Turn& turn) const { return turn.sticks == 0 && !turn.reversed; }

    const Flow& flow_;
    const FollowOptions& options_;
    bool steady_attracts_;
    FlowVector scale_, steady_;
    std::unique_ptr<SlidingMotion> motion_;
    bool fine_ = false;
    Attractor result_;
    std::deque<FlowVector> points_;  ///< on the section, newest last
    std::deque<Turn> turns_;
    double turn_limit_ = 0, least_turn_ = 0;  ///< s
    double abscissa_ = 0;                     ///< 1/s
    int linear_turns_ = 0;                    ///< in succession that decayed at the linear rate
    double last_growth_ = missing;            ///< ln of the amplitude ratio of the last two turns
    /// Amplitudes seen to grow and to shrink, and by how much a turn.
    double grows_at_ = 0, shrinks_at_ = infinity, grows_by_ = missing, shrinks_by_ = missing;
    int next_shot_ = 0, patience_ = 1;  ///< turns
    int idle_turns_ = 0;                ///< in succession that were shorter
    int quiet_turns_ = 0;               ///< turns since the amplitude was last scaled
};

Attractor Follower::ended(Attractor::Kind kind, Reason reason)
{
    result_.kind = kind;
    result_.reason = reason;
    result_.used_fallback = motion_->used_fallback();
    return result_;
}

Attractor Follower::from_turn(const Turn& turn)
{
    result_.period = turn.period();
    result_.velocity_min = turn.velocity_min;
    result_.velocity_max = turn.velocity_max;
    result_.position_min = turn.position_min;
    result_.position_max = turn.position_max;
    result_.rest_time = turn.rest_time;
    result_.reversed = turn.reversed;
    result_.start = turn.state;
    return ended(Attractor::Kind::cycle);
}

/// Shooting continues the branch on which a body slides through its V = 0, where the body may stick: there a cycle is
/// believed only if the motion itself goes around it without a stop.
bool Follower::makes_turn(const Cycle& cycle) const
{
    const auto* sliding = dynamic_cast<const SlidingFlow*>(&flow_);
    if (!(sliding && sliding->can_rest()) && !dynamic_cast<const SwitchingFlow*>(&flow_)) return true;
    SlidingMotion motion(flow_, options_.solver, options_.rtol);
    motion.start(cycle.start);
    const Turn turn = motion.turn(2 * cycle.period);
    return turn.end == Turn::End::crossing && smooth(turn) && std::abs(turn.period() / cycle.period - 1) < alike;
}

bool Follower::shoot(const FlowVector& guess)
{
    // each miss doubles the wait: a motion that creeps past a fold would be shot at in every turn for nothing
    if (result_.turns < next_shot_) return false;
    next_shot_ = result_.turns + patience_;
    patience_ = std::min(2 * patience_, 32);
    CycleOptions options;
    options.rtol = fine_ ? 1e-11 : std::min(1e-9, options_.rtol);
    const auto cycle = find_cycle(flow_, guess, options);
    if (!cycle || !cycle->attracts() || std::abs(cycle->multipliers[0]) > 1 - clear_contraction) return false;
    const double size = distance(cycle->start, steady_);
    if (distance(cycle->start, guess) > 0.5 * size) return false;  // another orbit than the one at hand
    if (!makes_turn(*cycle)) return false;
    result_.path = DecisionPath::shooting;
    result_.period = cycle->period;
    result_.velocity_min = cycle->velocity_min;
    result_.velocity_max = cycle->velocity_max;
    result_.position_min = cycle->position_min;
    result_.position_max = cycle->position_max;
    result_.rest_time = cycle->rest_time;
    result_.reversed = cycle->velocity_min < 0;
    result_.start = cycle->start;
    result_.multipliers = cycle->multipliers;
    return true;
}

/// Amplitude at which the growth per turn would vanish if it were a line in amplitude²; not a number if nowhere.
double Follower::still_amplitude(double growth) const
{
    const double a = amplitude(), b = amplitude() * std::exp(-growth);  // newest and the one before
    const double squared = a * a - growth * (a * a - b * b) / (growth - last_growth_);
    return std::sqrt(squared);
}

void Follower::start_anew(const FlowVector& y)
{
    motion_->start(y, motion_->time());
    points_.clear();
    turns_.clear();
    last_growth_ = missing;
    quiet_turns_ = 0;
}

/// Where a turn changes little, what a multistep method adds or takes by its errors decides; a one-step method at the
/// limit of doubles goes on from here.
void Follower::refine()
{
    fine_ = true;
    const double now = motion_->time();
    motion_ = std::make_unique<SlidingMotion>(flow_, Solver::rodas5p, fine_rtol);
    motion_->start(points_.back(), now);
    start_anew(FlowVector(points_.back()));
    grows_at_ = 0, shrinks_at_ = infinity;
}

/// Scales the amplitude of a creeping motion towards where its growth changes sign; true when that found the cycle.
bool Follower::jump(double growth)
{
    const FlowVector y = points_.back();
    const double size = amplitude(), still = still_amplitude(growth);
    (growth > 0 ? grows_at_ : shrinks_at_) = size;
    (growth > 0 ? grows_by_ : shrinks_by_) = growth;
    const bool bracketed = grows_at_ < shrinks_at_ && grows_at_ > 0 && shrinks_at_ < infinity;
    // where a line in amplitude² vanishes, kept off the ends that it would creep along
    const double share = std::clamp(grows_by_ / (grows_by_ - shrinks_by_), 0.1, 0.9);
    const double middle = std::sqrt(grows_at_ * grows_at_ * (1 - share) + shrinks_at_ * shrinks_at_ * share);
    const double slope = (grows_by_ - shrinks_by_) / (shrinks_at_ * shrinks_at_ - grows_at_ * grows_at_);
    if (bracketed && std::abs(growth) < 2 * located * slope * size * size) {
        from_turn(turns_.back());
        result_.path = DecisionPath::shooting;
        return true;
    }
    const bool ahead = growth > 0 ? still > size && still < 4 * size : still < size && still > 0.2 * size;
    if (ahead && shoot(steady_ + still / size * (y - steady_))) return true;
    if (bracketed && shoot(steady_ + middle / size * (y - steady_))) return true;
    // what creeps inwards may be passing a fold: only where nothing lies ahead may it be moved on
    const bool passing = growth < 0 && ahead && !bracketed;
    if (passing && !fine_) return false;
    const double factor = bracketed ? middle / size : growth > 0 ? 2 : passing ? std::max(inward, still / size) : 0.6;
    start_anew(steady_ + factor * (y - steady_));
    return false;
}

bool Follower::repeats()
{
    const auto gap = [this](int i, int j) { return distance(points_[i], points_[j]); };
    const int m = turns_to_repeat(static_cast<int>(points_.size()), gap, 100 * closed * amplitude());
    if (m == 0 || (m == 1 && fine_)) return false;  // what creeps seems closed: its growth decides
    from_turn(merged(turns_, m));
    result_.repeats = full_turns(turns_, m);
    return true;
}

Attractor Follower::run(const FlowVector& y)
{
    using Kind = Attractor::Kind;
    motion_->start(y);
    const auto settled = [this](const FlowVector& now) {
        return steady_attracts_ && distance(now, steady_) < settled_distance;
    };
    for (; result_.turns < options_.turn_limit; ++result_.turns) {
        const Turn turn = motion_->turn(motion_->time() + turn_limit_, settled);
        if (result_.turns == 0) result_.first_peak = turn.position_max;
        switch (turn.end) {
            case Turn::End::settled:
                return ended(Kind::steady);
            case Turn::End::held:
                return ended(Kind::held);
            case Turn::End::failure:
                result_.diverged = turn.velocity_max > runaway * flow_.commanded_velocity();
                return ended(Kind::failure, Reason::solver_failed);
            case Turn::End::time:
                return ended(Kind::undecided, Reason::not_converged);
            case Turn::End::crossing:
                break;
        }
        idle_turns_ = turn.period() > least_turn_ ? 0 : idle_turns_ + 1;
        if (idle_turns_ > most_idle_turns) return ended(Kind::undecided, Reason::not_converged);
        points_.push_back(turn.state);
        turns_.push_back(turn);
        ++quiet_turns_;
        if (points_.size() > 2 * longest_repeat + 2) points_.pop_front(), turns_.pop_front();
        if (points_.size() < 2) continue;
        const FlowVector& now = points_.back();
        const FlowVector& before = points_[points_.size() - 2];
        const double size = amplitude(), gap = distance(now, before);
        const double growth = std::log(size / distance(before, steady_));
        // a motion that rests forgets everything but the spring: two equal turns are a closed orbit
        const bool equal = gap <= std::max(closed, 10 * options_.rtol) * std::max(size, 1.0);
        const Turn& last = turns_[turns_.size() - 2];
        if (turn.sticks > 0 && last.sticks > 0 && equal) return from_turn(turn);
        if (options_.accelerate && smooth(turn)) {
            const bool due = gap < alike * size || quiet_turns_ % 12 == 11;
            if (due && shoot(now)) return ended(Kind::cycle);
            // near rest, speeds span more decades than shooting through them resolves
            if (turn.rest_time > 0 && last.rest_time > 0 && equal) return from_turn(turn);
            const bool creeping = std::abs(growth) < 0.3 && std::abs(growth - last_growth_) < 0.05;
            if (creeping && flow_.size() <= 3 && quiet_turns_ >= 3) {
                if (steady_attracts_ && growth < 0 && size < 1e-3) return ended(Kind::steady);
                if (!fine_ && std::abs(growth) < fine_growth) {
                    refine();
                    continue;
                }
                const bool forgotten = std::abs(growth - last_growth_) < settled_growth * std::abs(growth);
                if (!fine_ || forgotten || quiet_turns_ > most_settling) {
                    if (jump(growth)) return ended(Kind::cycle);
                    if (std::abs(growth) < no_growth) return ended(Kind::undecided, Reason::not_converged);
                }
                if (points_.empty()) continue;
            }
        } else if (!options_.accelerate && points_.size() > 3) {
            const double last_gap = distance(before, points_[points_.size() - 3]);
            const double ratio = std::min(gap / last_gap, 0.999);
            if (gap < watched * size || gap / (1 - ratio) < closed * size) return from_turn(turn);
        }
        last_growth_ = growth;
        if (result_.turns >= settling_turns && repeats())
            return ended(result_.repeats > 1 ? Kind::period_n : Kind::cycle);
        const bool linear = abscissa_ < 0 && std::abs(growth / (abscissa_ * turn.period()) - 1) < by_the_linear_rate;
        linear_turns_ = linear ? linear_turns_ + 1 : 0;
        if (steady_attracts_ && linear_turns_ >= linear_turns) return ended(Kind::steady);
    }
    if (!wild()) return ended(Kind::undecided, Reason::not_converged);
    from_turn(merged(turns_, static_cast<int>(turns_.size())));
    return ended(Kind::irregular);
}

/// Bounded, and neither creeping nor in a flow too small for chaos.
bool Follower::wild() const
{
    if (flow_.size() <= 3 || points_.size() < 3) return false;
    int grew = 0, shrank = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
        ++(distance(points_[i], steady_) > distance(points_[i - 1], steady_) ? grew : shrank);
    return grew > 0 && shrank > 0;
}

}  // namespace

Attractor follow(const Flow& flow, const FlowVector& y, bool steady_attracts, const FollowOptions& options)
{
    return Follower(flow, steady_attracts, options).run(y);
}

}  // namespace stickslip
