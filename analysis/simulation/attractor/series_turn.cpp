#include "analysis/simulation/attractor/series_turn.h"

#include "analysis/simulation/attractor/taylor_series.h"
#include "analysis/simulation/flows/near_rest.h"

#include <array>
#include <cmath>

namespace stickslip {
namespace {

constexpr int looks = 8;                     ///< at the speed along a step, for its events
constexpr int most_steps = 500;              ///< of a turn: one that needs more is stiff, and cheaper step by step
constexpr double share_of_tolerance = 0.01;  ///< that a step may leave out: the coefficients fall by about 4 a term
constexpr int root_steps = 60;

/// ẋ = V_0 (v − 1), ẇ = −g (K x + C (v − 1) + a w + Σ s_i p_i), ṗ_i = v (c_i p_i + b_i w), v = e^w, g = e^−w: motion
/// about steady sliding, p_i = θ_i less its value there. All numbers are the flow's own at steady sliding, exact
/// because the law is linear in ln V and θ but for the factor V of θ̇.
template <int states>
struct SlipSeries {
    static constexpr int size = 2 + states;
    double V0 = 0, K = 0, C = 0, a = 0;
    std::array<double, states> s{}, b{}, c{};
    FlowVector steady;

    explicit SlipSeries(const SlidingFlow& flow) : V0(flow.V0), steady(flow.steady())
    {
        const auto r = respond(flow.friction, flow.V0, steady_state(flow.friction, flow.V0));
        const double per_inertia = 1 / (flow.inertia * flow.V0);
        K = flow.k_p * per_inertia, C = flow.k_v * flow.V0 * per_inertia, a = r.by_velocity * flow.V0 * per_inertia;
        for (int i = 0; i < states; ++i)
            s[i] = r.by_state[i] * per_inertia, b[i] = r.rate_by_velocity[i] * flow.V0, c[i] = r.rate_by_state[i];
    }
};

/// Where f changes its sign between a and b, to the last bits.
template <class Function>
double zero_between(Function&& f, double a, double b)
{
    double fa = f(a), fb = f(b);
    for (int i = 0; i < root_steps && fa != 0 && fb != 0; ++i) {
        double middle = b - fb * (b - a) / (fb - fa);
        if (i % 3 == 2 || !(middle > a && middle < b)) middle = 0.5 * (a + b);
        if (middle <= a || middle >= b) break;
        const double fm = f(middle);
        if ((fm < 0) == (fa < 0) && fm != 0)
            a = middle, fa = fm;
        else
            b = middle, fb = fm;
    }
    return fa == 0 ? a : fb == 0 ? b : std::abs(fa) < std::abs(fb) ? a : b;
}

template <int states>
class SeriesTurn {
    static constexpr int size = 2 + states;
    static constexpr std::size_t width = 1 + size;

  public:
    SeriesTurn(const SlidingFlow& flow, const FlowVector& start, const CycleOptions& options)
        : flow_(flow), motion_(flow), options_(options), scale_(flow.scale())
    {
        for (int i = 0; i < size; ++i) {
            y_[i][0] = start[i] - motion_.steady[i];
            for (int m = 0; m < size; ++m) y_[i][1 + m] = i == m;
        }
        Cycle& path = turn_.path;
        path.start = start;
        path.period = 0;
        path.velocity_min = path.velocity_max = flow.velocity(start);
        path.position_min = path.position_max = start[0];
    }

    std::optional<Revolution> run()
    {
        for (int step = 0; step < most_steps * options_.turns; ++step) {
            expand();
            const double h = step_length();
            if (!(h > 0) || !std::isfinite(h)) return {};
            Look before{0, y_[1][0], u_[1][1][0]};
            for (int look = 1; look <= looks; ++look) {
                const Look here = look_at(h * look / looks);
                if (passes_end(before, here)) return std::move(turn_);
                before = here;
            }
            turn_.path.period += h;
            for (int i = 0; i < size; ++i) y_[i] = value(u_[i], h);
            if (!(y_[1][0] > least_logarithm)) return {};
        }
        return {};
    }

  private:
    /// A time within a step, ln(V/V_0) there and how it rises.
    struct Look {
        double t, w, rise;
    };
    Look look_at(double t) const { return {t, at(u_[1], t), slope(u_[1], t)}; }

    /// The series of the motion and its displacements about where it is.
    void expand()
    {
        const double speed = std::exp(y_[1][0]), slowness = std::exp(-y_[1][0]);
        for (int i = 0; i < size; ++i) u_[i][0] = y_[i];
        for (std::size_t m = 0; m < width; ++m) {
            const double change = m == 0 ? 1 : y_[1][m];
            v_[0][m] = speed * change, g_[0][m] = m == 0 ? slowness : -slowness * change;
        }
        for (int k = 0; k < order; ++k) {
            if (k > 0) exponential(u_[1], k, v_, g_);
            for (std::size_t m = 0; m < width; ++m) {
                const double excess = v_[k][m] - (k == 0 && m == 0);
                double balance = motion_.K * u_[0][k][m] + motion_.C * excess + motion_.a * u_[1][k][m];
                for (int i = 0; i < states; ++i) {
                    balance += motion_.s[i] * u_[2 + i][k][m];
                    pull_[i][k][m] = motion_.c[i] * u_[2 + i][k][m] + motion_.b[i] * u_[1][k][m];
                }
                balance_[k][m] = balance;
                u_[0][k + 1][m] = motion_.V0 * excess / (k + 1);
            }
            const auto acceleration = product(g_, balance_, k);
            for (std::size_t m = 0; m < width; ++m) u_[1][k + 1][m] = -acceleration[m] / (k + 1);
            for (int i = 0; i < states; ++i) {
                const auto change = product(v_, pull_[i], k);
                for (std::size_t m = 0; m < width; ++m) u_[2 + i][k + 1][m] = change[m] / (k + 1);
            }
        }
    }

    /// So long that the last two terms stay below the tolerance, the displacements' beside their own size.
    double step_length() const
    {
        const double allowed = share_of_tolerance * options_.rtol;
        double shortest = HUGE_VAL;
        for (const int k : {order - 1, order}) {
            double term = 0;
            for (int i = 0; i < size; ++i)
                term = std::max(term, std::abs(u_[i][k][0]) / (scale_[i] + std::abs(u_[i][0][0])));
            for (std::size_t m = 1; m < width; ++m) {
                double moved = 0, there = 0;
                for (int i = 0; i < size; ++i) {
                    moved = std::max(moved, std::abs(u_[i][k][m]) / scale_[i]);
                    there = std::max(there, std::abs(u_[i][0][m]) / scale_[i]);
                }
                term = std::max(term, moved / there);
            }
            shortest = std::min(shortest, std::pow(allowed / term, 1.0 / k));
        }
        return shortest;
    }

    void widen(double t)
    {
        Cycle& path = turn_.path;
        const double x = at(u_[0], t), speed = motion_.V0 * std::exp(at(u_[1], t));
        path.position_min = std::min(path.position_min, x), path.position_max = std::max(path.position_max, x);
        path.velocity_min = std::min(path.velocity_min, speed), path.velocity_max = std::max(path.velocity_max, speed);
    }

    /// Between two looks at a step; true if the turn ends there.
    bool passes_end(const Look& from, Look to)
    {
        const auto logarithm = [this](double t) { return at(u_[1], t); };
        const bool returned = below_ && from.w > 0 && to.w <= 0 && ++returns_ == options_.turns;
        if (from.w * to.w < 0) {
            const double crossing = zero_between(logarithm, from.t, to.t);
            widen(crossing);
            if (returned) to = look_at(crossing), to.w = 0;
        }
        if (from.rise * to.rise < 0) widen(zero_between([this](double t) { return slope(u_[1], t); }, from.t, to.t));
        widen(to.t);
        const double limit = std::log(near_rest);
        const bool slow0 = from.w < limit, slow1 = to.w < limit;
        if (slow0 != slow1) {
            const double crossing = zero_between([&](double t) { return logarithm(t) - limit; }, from.t, to.t);
            turn_.path.rest_time += slow0 ? crossing - from.t : to.t - crossing;
        } else if (slow0) {
            turn_.path.rest_time += to.t - from.t;
        }
        if (to.w < 0) below_ = true;
        if (returned) end(to.t);
        return returned;
    }

    void end(double t)
    {
        turn_.path.period += t;
        turn_.end = motion_.steady;
        turn_.displacement.resize(size, size);
        for (int i = 0; i < size; ++i) {
            const auto there = value(u_[i], t);
            turn_.end[i] += there[0];
            for (int m = 0; m < size; ++m) turn_.displacement(i, m) = there[1 + m];
        }
    }

    const SlidingFlow& flow_;
    const SlipSeries<states> motion_;
    const CycleOptions& options_;
    const FlowVector scale_;
    std::array<TaylorTerm<width>, size> y_;
    std::array<TaylorSeries<width>, size> u_;
    TaylorSeries<width> v_{}, g_{}, balance_{};
    std::array<TaylorSeries<width>, states> pull_{};
    Revolution turn_;
    bool below_ = false;  ///< has left the section downwards
    int returns_ = 0;
};

/// The slip law with nothing beside it.
bool is_plain(const Friction& f)
{
    return f.asymmetry.coulomb == 0 && f.asymmetry.viscous == 0 && !f.has_bristle() && !f.has_memory() && !f.has_lag();
}

}  // namespace

std::optional<Revolution> series_revolution(const Flow& flow, const FlowVector& start, const CycleOptions& options)
{
    const auto* single = dynamic_cast<const SlidingFlow*>(&flow);
    if (!single || !single->logarithmic || single->force != 0 || !is_plain(single->friction)) return {};
    const auto* law = std::get_if<RateAndState>(&single->friction.law);
    if (!law || law->states() != single->states) return {};
    if (single->states == 1) return SeriesTurn<1>(*single, start, options).run();
    if (single->states == 2) return SeriesTurn<2>(*single, start, options).run();
    return {};
}

}  // namespace stickslip
