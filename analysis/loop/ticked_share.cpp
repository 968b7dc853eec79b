#include "analysis/loop/ticked_share.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/numerics/beyond_one.h"
#include "analysis/numerics/quotient.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

Eigen::MatrixXd readings_of(const LoopPlant& plant)
{
    Eigen::MatrixXd rows(2, plant.A.cols());
    rows << plant.C, plant.C_v;
    return rows;
}

/// What the controller makes of a reading and of an exact velocity, at z: u = −(…).
std::pair<Complex, Complex> controller_at(const LoopTiming& t, const LoopGains& g, Complex z)
{
    const Complex change = (z - 1.0) / z;  // 1 − 1/z
    Complex of_reading = g.position, of_velocity = 0;
    if (g.integral != 0) of_reading += g.integral * t.period / change;
    if (!g.estimates()) return {of_reading, of_velocity};
    if (t.exact) {
        of_velocity = g.velocity;
        if (g.travelled != 0) of_velocity += g.travelled * t.period / change;
        return {of_reading, of_velocity};
    }
    Complex mean = 0, back = 1;
    for (int i = 0; i < t.average; ++i, back /= z) mean += back;
    const double share = t.period / (t.tau + t.period);
    const Complex smooth = share / (1.0 - (1 - share) / z) * mean / static_cast<double>(t.average);
    return {of_reading + (g.velocity * change / t.period + g.travelled) * smooth, of_velocity};
}

/// n over k.
double binomial(int n, int k)
{
    double ways = 1;
    for (int i = 1; i <= k; ++i) ways *= static_cast<double>(n - k + i) / i;
    return ways;
}

}  // namespace

TickedShare::TickedShare(const TickedFriction& ticked, const std::vector<DelayedFriction>& friction,
                         const Resolvent& responses)
    : ticked_(ticked),
      period_(ticked.timing.period),
      friction_(friction),
      share_(ticked.plant.A, ticked.plant.B, readings_of(ticked.plant), friction)
{
    constexpr double whole = 1e-12;  // as in discrete_loop()
    const double ticks = ticked_.timing.delay / period_, part = ticks - std::floor(ticks + whole);
    fraction_ = part > whole ? part * period_ : 0;
    take_answers();
    take_turns();
    choose_aliases(responses);
}

/// Two delays of one friction answer each other alike in either order. What is left for the aliases falls with the
/// frequency by one power more a term: of one friction with few delays further terms cost less than the aliases that
/// they spare (two delays, a lag of friction: 100 aliases with two terms, 12 with four).
void TickedShare::take_answers()
{
    constexpr std::size_t few = 2;
    constexpr int further = 4;
    std::vector<Delayed> all;
    for (const auto& f : friction_)
        for (const auto& d : f.delays) all.push_back({&f, d});
    if (friction_.size() == 1 && all.size() <= few) {
        terms_ = further;
        for (int term = 1; term <= terms_; ++term)
            for (int second = 0; second <= (all.size() > 1 ? term : 0); ++second) {
                std::vector<Delayed> behind(static_cast<std::size_t>(term - second), all[0]);
                behind.insert(behind.end(), static_cast<std::size_t>(second), all.back());
                take_answer(behind, binomial(term, second));
            }
        return;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        take_answer({all[i]}, 1);
        for (std::size_t k = 0; k < all.size(); ++k)
            if (all[i].friction != all[k].friction)
                take_answer({all[i], all[k]}, 1);
            else if (k <= i)
                take_answer({all[i], all[k]}, k < i ? 2 : 1);
    }
}

/// The mechanism behind itself, the speed of each pushing the next, `times` over.
void TickedShare::take_answer(const std::vector<Delayed>& delays, double times)
{
    const auto& plant = ticked_.plant;
    const auto n = plant.A.rows(), all = n * static_cast<Eigen::Index>(delays.size() + 1);
    LoopPlant chain;
    chain.A = Eigen::MatrixXd::Zero(all, all);
    for (Eigen::Index at = 0; at < all; at += n) chain.A.block(at, at, n, n) = plant.A;
    double time = fraction_;
    for (std::size_t i = 0; i < delays.size(); ++i) {
        const auto& [friction, delay] = delays[i];
        const auto at = n * static_cast<Eigen::Index>(i);
        chain.A.block(at + n, at, n, n) = delay.weight * friction->push * friction->speed;
        time += delay.time;
    }
    chain.B = Eigen::VectorXd::Zero(all);
    chain.B.head(n) = times * plant.B;
    chain.C = chain.C_v = Eigen::RowVectorXd::Zero(all);
    chain.C.tail(n) = plant.C;
    chain.C_v.tail(n) = plant.C_v;
    const LoopTiming timing{period_, time, 0, 1, true};
    const auto ticked = loop_without_whole_ticks(chain, timing, {}, {1, 0, 0, 0});
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, ticked->loop.input.size());
    rows.leftCols(all) = readings_of(chain);
    answers_.push_back({Resolvent(ticked->loop.difference, ticked->loop.input, rows), ticked->whole_ticks});
}

void TickedShare::take_turns()
{
    const auto turn = [this](double time) { return std::polar(1.0, -2 * pi * std::fmod(time / period_, 1.0)); };
    turns_ = {turn(fraction_)};
    for (const auto& f : friction_)
        for (const auto& d : f.delays) turns_.push_back(turn(d.time));
}

/// As many as leave less than the digits that matter; what is left falls with a high power of the frequency.
void TickedShare::choose_aliases(const Resolvent& responses)
{
    constexpr double left = 1e-12;
    constexpr int fewest = 4, most = 4096;
    for (aliases_ = fewest; aliases_ < most; aliases_ += aliases_ / 2) {
        bool enough = true;
        for (const double share : {0.03, 0.3, 0.9}) {  // at half the sampling rate a mass answers nothing
            const Complex s(0, share * pi / period_);
            const Added fewer = answered_further(s, aliases_), more = answered_further(s, 2 * aliases_);
            const auto [K, K_v] = controller_at(ticked_.timing, ticked_.turned, std::exp(s * period_));
            std::array<Complex, 2> all;
            responses.at(beyond_one(s * period_), all.data());
            enough &= std::abs(K * (more.reading - fewer.reading)) + std::abs(K_v * (more.rate - fewer.rate)) <
                      left * std::abs(all[0]);
        }
        if (enough) return;
    }
}

TickedShare::Added TickedShare::answered_early(Complex s) const
{
    Added sum{};
    std::array<Complex, 2> values;
    for (const auto& a : answers_) {
        a.of_ticks.at(beyond_one(s * period_), values.data());
        const Complex delayed = std::exp(-s * (a.whole_ticks * period_));
        sum.reading += delayed * values[0];
        sum.rate += delayed * values[1];
    }
    return sum;
}

/// What the delays answer beyond that, and tables to everything: the response of the mechanism to the hold, sampled by
/// its aliases, Σ P(s + 2πin/T) (1 − e^{−sT})/(T (s + 2πin/T)). From alias to alias delays only turn.
TickedShare::Added TickedShare::answered_further(Complex s, int aliases) const
{
    const double step = 2 * pi / period_;
    const Complex held = -beyond_one(-s * period_) / period_;
    constexpr std::size_t few = 16;
    std::array<Complex, few> some;
    std::vector<Complex> many(turns_.size() > few ? turns_.size() : 0);
    Complex* const delayed = turns_.size() > few ? many.data() : some.data();
    Added sum{};
    std::array<Complex, 2> added;
    std::array<DelayedShare::Answer, DelayedShare::most_delayed> answers;
    const auto take = [&](double shift) {
        const Complex at = s + Complex(0, shift);
        std::size_t next = 1;
        for (std::size_t i = 0; i < friction_.size(); ++i) {
            Complex delays = 0;
            for (const auto& d : friction_[i].delays) delays += d.weight * delayed[next++];
            answers[i] = {friction_[i].only_delays ? delays : friction_[i].answer(at), delays};
        }
        share_.at(at, terms_, answers.data(), added.data());
        const Complex hold = quotient(held, at) * delayed[0];
        sum.reading += hold * added[0];
        sum.rate += hold * added[1];
    };
    const auto begin = [&] {
        delayed[0] = std::exp(-s * fraction_);
        std::size_t next = 1;
        for (const auto& f : friction_)
            for (const auto& d : f.delays) delayed[next++] = std::exp(-s * d.time);
    };
    for (const int side : {1, -1}) {
        begin();
        if (side > 0) take(0);
        for (int n = 1; n <= aliases; ++n) {
            for (std::size_t k = 0; k < turns_.size(); ++k) delayed[k] *= side > 0 ? turns_[k] : std::conj(turns_[k]);
            take(side * n * step);
        }
    }
    return sum;
}

std::pair<Complex, Complex> TickedShare::at(Complex s) const
{
    const Added early = answered_early(s), further = answered_further(s, aliases_);
    const Complex reading = early.reading + further.reading, rate = early.rate + further.rate,
                  z = std::exp(s * period_);
    const auto [K, K_v] = controller_at(ticked_.timing, ticked_.turned, z);
    const auto [B, B_v] = controller_at(ticked_.timing, ticked_.base, z);
    return {K * reading + K_v * rate, -(B * reading + B_v * rate)};
}

}  // namespace stickslip
