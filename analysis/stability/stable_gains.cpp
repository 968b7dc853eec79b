// In one file: one scan over a gain that moves the sliding itself.
#include "analysis/stability/stable_gains.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/stability/characteristic.h"
#include "analysis/stability/crossings.h"
#include "analysis/stability/joint_crossings.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/winding.h"

namespace stickslip {
namespace {

bool same(const LinearFriction& a, const LinearFriction& b)
{
    if (a.f_v != b.f_v || a.states != b.states || a.delays.size != b.delays.size || a.table != b.table) return false;
    for (int i = 0; i < a.states; ++i)
        if (a.lambda[i] != b.lambda[i] || a.b[i] != b.b[i] || a.h[i] != b.h[i]) return false;
    return std::equal(a.delays.begin(), a.delays.end(), b.delays.begin(),
                      [](const auto& x, const auto& y) { return x.weight == y.weight && x.time == y.time; });
}

/// What the roots say of one gain.
struct AtGain {
    int right = 0;              ///< roots right of the axis
    double nearest = infinity;  ///< |Re s|/|s| of the root that is nearest to the axis
    double omega = missing;     ///< its frequency
};

/// The joint at any k_p, linearised where it then slides.
class Turned {
  public:
    Turned(const Joint& joint, Theory theory) : joint_(joint), theory_(theory)
    {
        const auto linear = at(joint.control.k_p);
        late_ = linear && !linear->rational();
    }
    bool late() const { return late_; }

    /// Nothing where the joint does not slide steadily or numbers overflow.
    std::optional<AtGain> look(double k_p)
    {
        const auto linear = at(k_p);
        if (!linear) return std::nullopt;
        AtGain seen;
        if (late_) {
            const auto count = count_right_of(*linear, 0);
            if (!count) return std::nullopt;
            seen.right = count->roots;
            double steepest = 0;
            for (const auto& node : count->nodes)
                if (node.steepness > steepest && node.omega > 0) steepest = node.steepness, seen.omega = node.omega;
            return seen;
        }
        const bool plain = is_plain_mass(joint_) && theory_ == Theory::state_variable;
        const auto roots = plain ? spectrum(linear_mass(joint_, commanded_velocity(joint_))) : spectrum(*linear);
        if (roots.empty()) return std::nullopt;
        for (const Complex& s : roots) {
            if (!std::isfinite(s.real())) return std::nullopt;
            if (s.real() > 0) ++seen.right;
            if (s.imag() <= 0 || !(std::abs(s.real()) < seen.nearest * std::abs(s))) continue;
            seen.nearest = std::abs(s.real()) / std::abs(s);
            seen.omega = s.imag();
        }
        return seen;
    }

    /// The gain and frequency that put a root on the axis, by Newton's method in ω and ln k_p from a near start.
    std::optional<Crossing> polished(Crossing near)
    {
        constexpr double probe = 1e-6, exact = 1e-13;
        double log_k = std::log(near.k_p), omega = near.omega;
        for (int i = 0; i < 12; ++i) {
            const auto here = at(std::exp(log_k)), above = at(std::exp(log_k + probe)),
                       below = at(std::exp(log_k - probe));
            if (!here || !above || !below) return std::nullopt;
            const Complex s(0, omega);
            const auto F = closed_loop(*here, s);
            const Complex by_omega = Complex(0, 1) * F.slope;
            const Complex by_gain = (closed_loop(*above, s).value - closed_loop(*below, s).value) / (2 * probe);
            const double det = (std::conj(by_omega) * by_gain).imag();
            const double d_omega = -(std::conj(F.value) * by_gain).imag() / det;
            const double d_log = -(std::conj(by_omega) * F.value).imag() / det;
            if (!std::isfinite(d_omega) || !std::isfinite(d_log)) return std::nullopt;
            omega += d_omega;
            log_k += d_log;
            if (std::abs(log_k - std::log(near.k_p)) > 0.1 || !(omega > 0)) return std::nullopt;
            if (std::abs(d_omega) < exact * omega && std::abs(d_log) < exact) break;
        }
        return Crossing{std::exp(log_k), omega, near.direction};
    }

  private:
    std::optional<LinearJoint> at(double k_p)
    {
        joint_.control.k_p = k_p;
        const auto steady = steady_sliding(joint_);
        if (steady.reason != Reason::none) return std::nullopt;
        auto linear = linear_joint(joint_, steady.velocity);
        return theory_ == Theory::velocity_only ? velocity_only(std::move(linear)) : linear;
    }
    Joint joint_;
    Theory theory_;
    bool late_ = false;
};

/// The scan over k_p.
class GainScan {
  public:
    GainScan(const Joint& joint, Theory theory) : turned_(joint, theory)
    {
        const double own = joint.control.k_p, decades = turned_.late() ? late_gain_decades : gain_decades;
        const int steps = turned_.late() ? 36 : 240;
        low_ = own * std::pow(10, -decades), high_ = own * std::pow(10, decades);
        std::vector<Place> places;
        for (int i = 0; i <= steps; ++i) {
            const double k_p = i == steps / 2 ? own : low_ * std::pow(high_ / low_, double(i) / steps);
            if (const auto seen = turned_.look(k_p)) places.push_back({k_p, *seen});
        }
        if (places.empty()) return;
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            if (i > 0) dip(places[i - 1], places[i], places[i + 1]);
            between(places[i], places[i + 1]);
        }
        std::sort(found_.begin(), found_.end(), [](const Crossing& a, const Crossing& b) { return a.k_p < b.k_p; });
        result(places.front());
    }
    StableGains gains;

  private:
    struct Place {
        double k_p;
        AtGain seen;
    };

    void between(const Place& a, const Place& b)
    {
        if (a.seen.right == b.seen.right) return;
        const double close = turned_.late() ? 1e-3 : 1e-6;
        if (b.k_p - a.k_p < close * b.k_p) {
            Crossing crossing{std::sqrt(a.k_p * b.k_p), a.seen.omega, b.seen.right > a.seen.right ? 1 : -1};
            if (const auto exact = turned_.polished(crossing);
                exact && std::abs(std::log(exact->k_p / crossing.k_p)) < 10 * close)
                return found_.push_back(*exact);
            if (b.k_p - a.k_p < 1e-12 * b.k_p) return found_.push_back(crossing);
        }
        const double middle = std::sqrt(a.k_p * b.k_p);
        const auto seen = turned_.look(middle);
        if (!seen || !(middle > a.k_p && middle < b.k_p)) return;
        between(a, {middle, *seen});
        between({middle, *seen}, b);
    }

    /// Between three places with as many roots on the right, where one comes nearest to the axis: does it cross?
    void dip(const Place& a, const Place& b, const Place& c)
    {
        if (turned_.late() || a.seen.right != b.seen.right || b.seen.right != c.seen.right) return;
        if (b.seen.nearest > a.seen.nearest || b.seen.nearest > c.seen.nearest || b.seen.nearest > 0.1) return;
        constexpr double golden = 0.6180339887498949;
        double low = std::log(a.k_p), high = std::log(c.k_p);
        for (int i = 0; i < 24; ++i) {
            const double x = high - golden * (high - low), y = low + golden * (high - low);
            const auto at_x = turned_.look(std::exp(x)), at_y = turned_.look(std::exp(y));
            if (!at_x || !at_y) return;
            for (const auto& [k, seen] : {std::pair(x, *at_x), std::pair(y, *at_y)})
                if (seen.right != b.seen.right) {
                    between(a, {std::exp(k), seen});
                    between({std::exp(k), seen}, c);
                    return;
                }
            (at_x->nearest < at_y->nearest ? high : low) = at_x->nearest < at_y->nearest ? y : x;
        }
    }

    void result(const Place& first)
    {
        gains.searched_to = high_;
        gains.crossings = found_;
        int right = first.seen.right;
        double from = first.k_p;
        for (std::size_t i = 0; i <= found_.size(); ++i) {
            const double to = i == found_.size() ? high_ : found_[i].k_p;
            // a pair changes the number by two; nothing else can cross at k_p > 0
            if (right <= 0 && to > from) gains.stable.push_back({from, to});
            if (i < found_.size()) right += 2 * found_[i].direction;
            from = to;
        }
    }

    Turned turned_;
    double low_ = 0, high_ = 0;
    std::vector<Crossing> found_;
};

}  // namespace

void take_single_gain(StableGains& gains)
{
    const auto& stable = gains.stable;
    if (gains.crossings.size() != 1 || stable.size() != 1 || stable[0].low != gains.crossings[0].k_p) return;
    gains.k_cr = gains.crossings[0].k_p;
    gains.omega = gains.crossings[0].omega;
}

bool gain_moves_sliding(const Joint& joint)
{
    if (joint.control.kind != ControlKind::force || !(joint.control.k_p > 0)) return false;
    const double V = commanded_velocity(joint);
    const bool ramp = is_set(joint.control.force_rate);
    const Chain chain = chain_of(joint);
    for (int i = 0; i < chain.bodies; ++i) {
        if (!ramp && i == chain.bodies - 1) continue;  // the link slides at V_0 whatever the gain
        const auto& friction = *chain.body[i].friction;
        const double own = chain.body[i].velocity(V);
        const auto here = linearise(friction, own);
        for (const double times : {0.37, 2.3})
            if (!same(here, linearise(friction, times * own))) return true;
    }
    return false;
}

StableGains stable_gains(const Joint& joint, Theory theory)
{
    const double V = commanded_velocity(joint);
    StableGains gains;
    if (loop_kind(joint) != LoopKind::ideal) {
        const double sliding = sliding_velocity(joint, V);
        auto linear = linear_joint(joint, sliding);
        if (theory == Theory::velocity_only) linear = velocity_only(std::move(linear));
        const auto loop = real_loop(joint, linear, sliding, TurnedGain::k_p);
        if (loop) return turned_gains(*loop);
        gains.known = false;
        return gains;
    }
    if (gain_moves_sliding(joint)) {
        gains = GainScan(joint, theory).gains;
        take_single_gain(gains);
        return gains;
    }
    if (theory == Theory::velocity_only) {
        const auto curve = velocity_only(linear_joint(joint, V));
        gains.crossings = rational_crossings(curve, Gain::k_p);
        gains.stable = stable_intervals(curve, gains.crossings, gains.searched_to);
        take_single_gain(gains);
        return gains;
    }
    if (is_plain_mass(joint)) {
        const auto mass = linear_mass(joint, V);
        if (mass.friction.rational()) {
            gains.crossings = crossings(mass);
            gains.stable = stable_intervals(mass, gains.crossings);
            take_single_gain(gains);
            return gains;
        }
    }
    const auto linear = linear_joint(joint, V);
    auto search = crossings(linear);
    gains.crossings = std::move(search.crossings);
    gains.searched_to = search.searched_to;
    gains.doubtful = std::move(search.doubtful);
    gains.stable = stable_intervals(linear, gains.crossings, gains.searched_to);
    // where delays go on, so may the crossings
    if (gains.searched_to == infinity) take_single_gain(gains);
    return gains;
}

}  // namespace stickslip
