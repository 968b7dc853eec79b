#include "analysis/stability/real_response.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "analysis/numerics/beyond_one.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/steady.h"

namespace stickslip {
namespace {

using Complex = std::complex<double>;

constexpr int past_nodes = 24;  ///< over the dead time, in which what is drawn turns less than they resolve

/// ln(z)/T. A multiplier of 0 forgets at once: its root is as far left as any number of digits can tell.
std::vector<Complex> rates(const std::vector<Complex>& multipliers, double period)
{
    constexpr double nothing = 1e-300;
    std::vector<Complex> roots;
    for (const Complex& z : multipliers) roots.push_back(std::log(std::abs(z) > nothing ? z : nothing) / period);
    return roots;
}

DelayedSpectrum spectrum_of(const RealLoop& loop, double gain)
{
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop.loop))
        return {rates(multipliers(*sampled, gain), sampled->period), sampled_growth(*sampled, gain)};
    return delayed_spectrum(std::get<DelayedLoop>(loop.loop), gain);
}

}  // namespace

std::optional<LoopResponse> LoopResponse::of(const Joint& joint, Theory theory, Input input)
{
    const auto steady = steady_sliding(joint);
    if (steady.reason != Reason::none) return std::nullopt;
    const bool ideal = loop_kind(joint) == LoopKind::ideal;
    const double velocity = steady.slides_at;
    LoopResponse answer;
    answer.linear_ = linear_joint(joint, velocity);
    const auto& linear = answer.linear_;
    if (theory == Theory::velocity_only) answer.linear_ = velocity_only(std::move(answer.linear_));
    if (ideal) {
        answer.roots_ = spectrum(linear), answer.growth_ = spectral_abscissa(linear);
        return answer;
    }
    answer.loop_ = real_loop(joint, linear, velocity, TurnedGain::all);
    if (!answer.loop_) return std::nullopt;
    const auto* delayed = std::get_if<DelayedLoop>(&answer.loop_->loop);
    if (delayed && delayed->period > 0 && !delayed->friction.empty()) {
        if (input == Input::force) return std::nullopt;
        const auto carried = link_by_command(joint, linear, velocity);
        if (!carried) return std::nullopt;
        answer.opened_.emplace(*delayed);
        answer.carried_.emplace(*carried);
    }
    answer.sums_aliases_ = answer.opened_.has_value();
    answer.read_at_command();
    auto spectrum = spectrum_of(*answer.loop_, answer.loop_->gain);
    answer.roots_ = std::move(spectrum.roots), answer.growth_ = spectrum.growth;
    answer.period_ = delayed ? delayed->period : std::get<DiscreteLoop>(answer.loop_->loop).period;
    answer.plant_ = loop_plant(joint, linear, velocity);
    answer.speed_ = linear.bodies + linear.link();
    const Eigen::VectorXd pushed = rates_per_force(linear, linear.link());
    answer.pushed_ = Eigen::VectorXd::Zero(answer.plant_.A.rows());
    answer.pushed_.head(pushed.size()) = pushed;
    return answer;
}

Complex LoopResponse::at(double omega) const
{
    if (!loop_) return disturbance_response(linear_, {0, omega});
    const Complex s(0, omega);
    const auto n = plant_.A.rows();
    if (period_ == 0) {
        Eigen::VectorXcd d = Eigen::VectorXcd::Zero(size());
        d.head(n) = pushed_.cast<Complex>();
        return closed(omega, d)[linear_.link()];
    }
    // ∫ e^{A(T−t)} e^{iωt} dt d; for slow sines by the integral of the exponential alone, as (iω − A) may be singular
    Eigen::MatrixXcd shifted = plant_.A.cast<Complex>();
    shifted.diagonal().array() -= s;
    Eigen::MatrixXcd wide = Eigen::MatrixXcd::Zero(n + 1, n + 1);
    wide.topLeftCorner(n, n) = shifted * period_;
    wide.col(n).head(n) = pushed_.cast<Complex>() * period_;
    const Eigen::VectorXcd held = std::exp(s * period_) * wide.exp().col(n).head(n);
    Eigen::VectorXcd d = Eigen::VectorXcd::Zero(size());
    d.head(n) = held;
    return closed(omega, d)[linear_.link()];
}

Eigen::Index LoopResponse::size() const
{
    const auto* delayed = std::get_if<DelayedLoop>(&loop_->loop);
    return delayed ? delayed->A.rows() : std::get<DiscreteLoop>(loop_->loop).difference.rows();
}

Eigen::VectorXcd LoopResponse::closed(double omega, const Eigen::VectorXcd& input) const
{
    const Complex s(0, omega);
    // e^{iωT} − 1 with its digits
    const Complex variable = period_ > 0 ? beyond_one(s * period_) : s;
    Eigen::MatrixXcd Z;
    if (const auto* delayed = std::get_if<DelayedLoop>(&loop_->loop)) {
        Z = -delayed->A.cast<Complex>();
        for (const auto& f : delayed->friction) Z -= f.push * (f.answer(s) * f.speed);
        Z -= delayed->input * ((delayed->held - loop_->gain * delayed->output) * std::exp(-s * delayed->delay));
    } else {
        Z = -std::get<DiscreteLoop>(loop_->loop).closed(loop_->gain).cast<Complex>();
    }
    Z.diagonal().array() += variable;
    return Z.partialPivLu().solve(input);
}

/// What by_command asks at every frequency, with one back-substitution each: the loop opened at its command, or, where
/// it maps tick to tick, closed.
void LoopResponse::read_at_command()
{
    if (const auto* sampled = std::get_if<DiscreteLoop>(&loop_->loop)) {
        Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, size());
        rows(0, linear_.link()) = 1;
        rows.row(1) = sampled->output;
        closed_.emplace(sampled->closed(loop_->gain), sampled->input, rows);
        return;
    }
    if (opened_) return;
    auto link = std::get<DelayedLoop>(loop_->loop);
    opened_.emplace(link);
    link.output.setZero(), link.held.setZero();
    link.output[linear_.link()] = 1;
    carried_.emplace(link);
}

LoopResponse::ByCommand LoopResponse::by_command(double omega) const
{
    const Complex s(0, omega);
    if (closed_) {
        // e^{iωT} − 1 with its digits
        std::array<Complex, 2> per_command;
        closed_->at(beyond_one(s * period_), per_command.data());
        return {per_command[0], 1.0 - loop_->gain * per_command[1]};
    }
    const auto [out, held] = opened_->prompt(s);
    const Complex remains = 1.0 / (1.0 + (loop_->gain * out - held) * opened_->delayed(s));
    return {carried_->prompt(s).first * carried_->delayed(s) * remains, remains};
}

ResponsePeak LoopResponse::peak(int points) const
{
    if (!loop_) return response_peak(linear_, points);
    if (!(growth_ <= 0)) return {missing, missing};
    const double highest = period_ > 0 ? std::numbers::pi / period_ : infinity;
    return response_peak([this](double omega) { return std::abs(at(omega)); }, roots_, points, highest);
}

ForcedResponse LoopResponse::forced(const SampledForce& force) const
{
    if (!loop_) return forced_response(linear_, force);
    return period_ > 0 ? ticks(force) : continuous(force);
}

ForcedResponse LoopResponse::ticks(const SampledForce& force) const
{
    const auto n = plant_.A.rows();
    const Eigen::VectorXd held = integral_of_exponential(plant_.A, period_) * pushed_;
    const auto* delayed = std::get_if<DelayedLoop>(&loop_->loop);
    const Eigen::MatrixXd change = delayed ? delayed->A : std::get<DiscreteLoop>(loop_->loop).closed(loop_->gain);
    // commands on their way, where they are no states
    std::deque<double> line(delayed ? static_cast<std::size_t>(std::lround(delayed->delay / period_)) + 1 : 0, 0.0);
    Eigen::VectorXd X = Eigen::VectorXd::Zero(change.rows());
    X.head(n) = force.impulse * pushed_;
    ForcedResponse response;
    const double end = force.step * static_cast<double>(force.value.size());
    for (std::size_t tick = 0;; ++tick) {
        const double t = static_cast<double>(tick) * period_;
        response.time.push_back(t);
        response.position.push_back(X[linear_.link()]);
        response.velocity.push_back(X[speed_]);
        if (t >= end) return response;
        const auto at = std::min(force.value.size() - 1, static_cast<std::size_t>(t / force.step));
        Eigen::VectorXd moved = change * X;
        if (delayed) {
            line.push_back(((delayed->held - loop_->gain * delayed->output) * X)(0));
            line.pop_front();
            moved += line.front() * delayed->input;
        }
        X += moved;
        X.head(n) += force.value[at] * held;
    }
}

ForcedResponse LoopResponse::continuous(const SampledForce& force) const
{
    const auto& delayed = std::get<DelayedLoop>(loop_->loop);
    const Eigen::MatrixXd A = delayed_matrix(delayed, loop_->gain, past_nodes);
    const Eigen::MatrixXd sum = integral_of_exponential(A, force.step);
    Eigen::VectorXd pushed = Eigen::VectorXd::Zero(A.rows());
    pushed.head(pushed_.size()) = pushed_;
    Eigen::VectorXd y = force.impulse * pushed;
    ForcedResponse response;
    const auto keep = [&](double t) {
        response.time.push_back(t);
        response.position.push_back(y[linear_.link()]);
        response.velocity.push_back(y[speed_]);
    };
    keep(0);
    for (std::size_t i = 0; i < force.value.size(); ++i) {
        y += sum * (A * y + force.value[i] * pushed);
        keep(force.step * static_cast<double>(i + 1));
    }
    return response;
}

std::vector<std::vector<Complex>> root_locus(const Joint& joint, const std::vector<double>& gains)
{
    const double velocity = sliding_velocity(joint);
    if (loop_kind(joint) == LoopKind::ideal) return root_locus(linear_joint(joint, velocity), gains);
    const auto loop = real_loop(joint, linear_joint(joint, velocity), velocity, TurnedGain::k_p);
    if (!loop || joint.control.structure == Structure::cascade) return {};
    std::vector<std::vector<Complex>> rows;
    for (const double k_p : gains) rows.push_back(spectrum_of(*loop, k_p).roots);
    follow_branches(rows);
    return rows;
}

}  // namespace stickslip
