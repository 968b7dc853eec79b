#include "analysis/loop/discrete_loop.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/balance.h"

namespace stickslip {
namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;

/// Both over a time h.
struct Exponential {
    MatrixXd integral;    ///< ∫ e^{As} ds from 0 to h
    MatrixXd difference;  ///< e^{Ah} − 1 = A ∫
};

template <class Number>
using Square = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;

/// By doubling a short step. `A`, balanced, is of the shortest; what is found is in units of the whole.
template <class Number>
Exponential doubled(Square<Number> A, int doublings)
{
    A *= std::exp2(Number(-doublings));
    // Σ A^k/(k+1)! by Horner; |A| ≤ 1/2 leaves less than rounding behind the last term
    constexpr int terms = sizeof(Number) > sizeof(double) ? 17 : 13;
    const Square<Number> one = Square<Number>::Identity(A.rows(), A.cols());
    Square<Number> sum = one;
    for (int k = terms; k >= 1; --k) sum = one + A * sum / Number(k + 1);
    Square<Number> difference = A * sum;
    for (int i = 0; i < doublings; ++i) {
        // ∫ over 2h = (1 + e^{Ah}) ∫ over h, in units of their own h. The difference doubles by itself: A ∫ in its
        // place would multiply the errors of fast rows in slow columns by the fastest rate, each time anew
        sum = (sum + Number(0.5) * difference * sum).eval();
        difference = (Number(2) * difference + difference * difference).eval();
    }
    return {sum.template cast<double>(), difference.template cast<double>()};
}

Exponential exponential(const MatrixXd& given, double h)
{
    MatrixXd A = h * given;
    Eigen::VectorXd units = Eigen::VectorXd::Ones(given.rows());
    balance(A, &units);
    const double size = A.cwiseAbs().rowwise().sum().maxCoeff();
    int doublings = 0;
    if (std::isfinite(size) && size > 0.5) doublings = static_cast<int>(std::ceil(std::log2(size / 0.5)));
    // a doubling may lose a bit of a slow mode beside the fastest
    constexpr int few = 10;
    auto found =
        doublings > few ? doubled<long double>(A.cast<long double>(), doublings) : doubled<double>(A, doublings);
    const auto as_given = [&](MatrixXd& m) { m = (units.asDiagonal() * m * units.cwiseInverse().asDiagonal()).eval(); };
    as_given(found.integral), as_given(found.difference);
    found.integral *= h;
    return found;
}

/// What a whole period makes of the state, and of the commands that act in its first part and in the rest.
struct Period {
    MatrixXd difference;  ///< e^{AT} − 1
    Eigen::VectorXd delayed, fresh;
};

Period over_period(const LoopPlant& plant, double before, double after)
{
    const auto [rest, E] = exponential(plant.A, after);
    Period p{E, Eigen::VectorXd::Zero(plant.B.size()), rest * plant.B};
    if (before == 0) return p;
    const auto [first, E_first] = exponential(plant.A, before);
    const Eigen::VectorXd pushed = first * plant.B;
    p.delayed = pushed + E * pushed;
    p.difference = E + E_first + E * E_first;
    return p;
}

/// Where each part of the state stands.
struct Layout {
    int plant, readings, filter, integral, commands, size;
};

Layout layout_of(const LoopPlant& plant, const LoopTiming& timing, bool estimates, bool integrates, bool travels,
                 int held)
{
    Layout at{};
    at.plant = static_cast<int>(plant.A.rows());
    at.readings = at.plant;
    at.filter = at.readings + (estimates && !timing.exact ? timing.average - 1 : 0);
    at.integral = at.filter + (timing.exact ? travels : estimates);
    at.commands = at.integral + integrates;
    at.size = at.commands + held;
    return at;
}

}  // namespace

MatrixXd integral_of_exponential(const MatrixXd& A, double h)
{
    return exponential(A, h).integral;
}

namespace {

// `aside`: without the whole ticks of dead time, and with the commands of the base in a row of their own.
// In one piece: the discrete loop assembled block by block, as the figure shows it.
LoopOfTicks assembled(const LoopPlant& plant, const LoopTiming& t, const LoopGains& base, const LoopGains& turned,
                      bool aside)
{
    constexpr double whole = 1e-12;  // of a tick: what rounding of delay/period is
    const double ticks = t.delay / t.period;
    const int all = static_cast<int>(std::floor(ticks + whole)), delayed = aside ? 0 : all;
    const double fraction = std::max(0.0, ticks - all) > whole ? ticks - all : 0;
    const auto period = over_period(plant, fraction * t.period, (1 - fraction) * t.period);

    const bool estimates = base.estimates() || turned.estimates();
    const bool travels = base.travelled != 0 || turned.travelled != 0;
    const bool sums = base.integral != 0 || turned.integral != 0;
    // two sums that no estimate decays into each other are one integrator: apart, their difference would stay for ever
    const bool joined = sums && travels && t.exact, integrates = sums && !joined;
    const int held = delayed + (fraction > 0);
    const Layout at = layout_of(plant, t, estimates, integrates, travels, held);
    const auto unit = [&](int i) { return RowVectorXd(RowVectorXd::Unit(at.size, i)); };
    const auto of_plant = [&](const RowVectorXd& row) {
        RowVectorXd wide = RowVectorXd::Zero(at.size);
        wide.head(at.plant) = row;
        return wide;
    };

    LoopOfTicks found;
    found.whole_ticks = all;
    DiscreteLoop& loop = found.loop;
    loop.period = t.period;
    MatrixXd& D = loop.difference;
    D = MatrixXd::Zero(at.size, at.size);
    D.topLeftCorner(at.plant, at.plant) = period.difference;
    const RowVectorXd reading = of_plant(plant.C);
    RowVectorXd velocity = RowVectorXd::Zero(at.size), travelled = velocity, sum = velocity, joint_sum = velocity;
    const bool of_base = base.integral != 0 || base.travelled != 0;  ///< the joined sum acts by itself, or g times
    if (estimates && t.exact) {
        velocity = of_plant(plant.C_v);
        if (joined) {
            const LoopGains& own = of_base ? base : turned;
            D.row(at.filter) = t.period * (own.integral * reading + own.travelled * velocity);
            joint_sum = unit(at.filter);
            travelled = t.period * velocity;
            sum = t.period * reading;
        } else if (travels) {
            travelled = unit(at.filter) + t.period * velocity;
            D.row(at.filter) = t.period * velocity;
        }
    } else if (estimates) {
        // the filtered mean position S is all that the estimate remembers: T v_k = S_k − S_{k−1}
        RowVectorXd mean = reading / t.average;
        for (int i = at.readings; i < at.filter; ++i) mean += unit(i) / t.average;
        const double share = t.period / (t.tau + t.period);
        D.row(at.filter) = share * (mean - unit(at.filter));
        velocity = D.row(at.filter) / t.period;
        travelled = unit(at.filter) + D.row(at.filter);
        for (int i = at.readings; i < at.filter; ++i) D.row(i) = (i == at.readings ? reading : unit(i - 1)) - unit(i);
    }
    if (integrates) {
        D.row(at.integral) = t.period * reading;
        sum = unit(at.integral) + D.row(at.integral);
    }
    const auto command = [&](const LoopGains& g) {
        RowVectorXd sent = g.position * reading + g.velocity * velocity + g.integral * sum + g.travelled * travelled;
        if (&g == (of_base ? &base : &turned)) sent += joint_sum;
        return RowVectorXd(-sent);
    };
    // the command of `back` ticks ago; the newest is not yet a state
    loop.input = Eigen::VectorXd::Zero(at.size);
    const RowVectorXd of_base_gains = command(base), nothing = RowVectorXd::Zero(at.size);
    const RowVectorXd& newest = aside ? nothing : of_base_gains;
    found.held = of_base_gains;
    const auto drive = [&](const Eigen::VectorXd& push, int back) {
        if (back == 0) {
            D.topRows(at.plant) += push * newest;
            loop.input.head(at.plant) += push;
        } else {
            D.col(at.commands + back - 1).head(at.plant) += push;
        }
    };
    drive(period.fresh, delayed);
    if (fraction > 0) drive(period.delayed, delayed + 1);
    for (int i = 0; i < held; ++i) {
        D.row(at.commands + i) = (i == 0 ? newest : unit(at.commands + i - 1)) - unit(at.commands + i);
        if (i == 0) loop.input[at.commands] = 1;
    }
    loop.output = -command(turned);
    // of a cascade's position gain all that is turned reads the position, and so does its part of the joined sum
    if (joined && of_base) {
        const double read = turned.position + t.period * turned.integral;
        loop.input[at.filter] = -t.period * turned.integral / read;
        found.acts_twice = true;
    }
    return found;
}

}  // namespace

DiscreteLoop discrete_loop(const LoopPlant& plant, const LoopTiming& timing, const LoopGains& base,
                           const LoopGains& turned)
{
    return assembled(plant, timing, base, turned, false).loop;
}

std::optional<LoopOfTicks> loop_without_whole_ticks(const LoopPlant& plant, const LoopTiming& timing,
                                                    const LoopGains& base, const LoopGains& turned)
{
    auto found = assembled(plant, timing, base, turned, true);
    if (found.acts_twice) return std::nullopt;
    return found;
}

}  // namespace stickslip
