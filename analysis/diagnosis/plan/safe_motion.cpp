#include "analysis/diagnosis/plan/safe_motion.h"

#include "analysis/diagnosis/policy/page_and_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip::gap {
namespace {

constexpr double window = 0.04;                // numerical: s, over which a motion has a speed
constexpr double turn = 2 * std::numbers::pi;  // numerical: rad

/// Writes a motion piece by piece, each from rest to rest.
class Writer {
  public:
    Writer(const Reach& reach, double period) : reach_(reach), period_(period), at_(reach.start) { put(at_); }

    double time() const { return static_cast<double>(motion_.time.size()) * period_; }
    void rest(double seconds)
    {
        for (const double end = time() + seconds; time() < end;) put(at_);
    }
    /// To a place with this part of the speed: acceleration constant, then none, then constant.
    void go(double to, double part = 1)
    {
        const double distance = std::abs(to - at_), side = to < at_ ? -1 : 1, from = at_;
        const double a = policy::within_seen * reach_.acceleration;
        const double v = std::min(part * policy::within_seen * reach_.speed, std::sqrt(distance * a));
        if (!(distance > 0) || !(v > 0)) return;
        const double ramp = v / a, whole = distance / v + ramp, begin = time();
        while (time() - begin < whole) {
            const double t = time() - begin, back = whole - t;
            const double gone = t < ramp      ? 0.5 * a * t * t
                                : back < ramp ? distance - 0.5 * a * back * back
                                              : v * (t - 0.5 * ramp);
            put(from + side * gone);
        }
        put(to);
    }
    /// A sine of rising frequency about the present place; begins and ends with amplitude 0.
    void swing(double amplitude, double from_hertz, double to_hertz, double seconds)
    {
        const double middle = at_, begin = time(), sweep = std::log(to_hertz / from_hertz) / seconds;
        const double fade = std::min(0.25 * seconds, 2 / from_hertz);
        while (time() - begin < seconds) {
            const double t = time() - begin, hertz = from_hertz * std::exp(sweep * t), w = turn * hertz;
            const double phase = sweep != 0 ? turn * from_hertz * std::expm1(sweep * t) / sweep : w * t;
            const double s = std::min({1.0, t / fade, (seconds - t) / fade});
            // half of each limit: fading and sweeping have a share of their own. A smooth least, without a kink in
            // speed
            const double size = 1 / std::sqrt(std::pow(amplitude, -2) + std::pow(2 * w / reach_.speed, 2) +
                                              std::pow(2 * w * w / reach_.acceleration, 2));
            put(middle + size * s * s * (3 - 2 * s) * std::sin(phase));
        }
        put(middle);
    }
    SafeMotion done(TestMotion kind)
    {
        go(reach_.start);
        rest(0.5);
        motion_.kind = kind;
        return std::move(motion_);
    }

  private:
    void put(double q)
    {
        motion_.time.push_back(time());
        motion_.position.push_back(at_ = q);
    }
    const Reach& reach_;
    double period_, at_;
    SafeMotion motion_;
};

}  // namespace

Reach reach_of(const std::vector<double>& time, const std::vector<double>& position)
{
    Reach r;
    if (position.empty()) return r;
    const auto [low, high] = std::minmax_element(position.begin(), position.end());
    r.low = *low, r.high = *high, r.start = position.front();
    const double step = time.size() > 1 ? (time.back() - time.front()) / static_cast<double>(time.size() - 1) : 1;
    const auto reach = static_cast<std::size_t>(std::max(1.0, std::round(0.5 * window / step)));
    for (std::size_t k = reach; k + reach < position.size(); ++k) {
        // least squares of a parabola through 2·reach + 1 readings
        double linear = 0, squares = 0, bend = 0, bends = 0;
        const double n = static_cast<double>(reach), mean = n * (n + 1) / 3;
        for (std::size_t i = 0; i <= 2 * reach; ++i) {
            const double x = static_cast<double>(i) - n, q = position[k - reach + i] - position[k];
            const double parabola = x * x - mean;
            linear += x * q, squares += x * x, bend += parabola * q, bends += parabola * parabola;
        }
        r.speed = std::max(r.speed, std::abs(linear / squares) / step);
        r.acceleration = std::max(r.acceleration, 2 * std::abs(bend / bends) / (step * step));
    }
    return r;
}

Reach together(const Reach& one, const Reach& other)
{
    return {std::min(one.low, other.low), std::max(one.high, other.high), std::max(one.speed, other.speed),
            std::max(one.acceleration, other.acceleration), one.start};
}

std::vector<SafeMotion> safe_motions(const Reach& reach, double duration, double period)
{
    const double stroke = reach.high - reach.low, middle = 0.5 * (reach.low + reach.high);
    const double low = middle - 0.5 * policy::within_seen * stroke, high = middle + 0.5 * policy::within_seen * stroke;
    std::vector<SafeMotion> all;
    if (!(stroke > 0) || !(reach.speed > 0) || !(reach.acceleration > 0)) return all;
    const auto to_and_fro = [&](Writer& w, double part, double until) {
        const double travel = 0.5 * part * policy::within_seen * reach.speed * (until - w.time());
        const double far = std::min(high, low + std::max(travel, 0.02 * stroke));
        do w.go(far, part), w.go(low, part);
        while (w.time() < until);
    };
    {
        Writer w(reach, period);
        w.go(low);
        to_and_fro(w, 0.02, duration);
        all.push_back(w.done(TestMotion::slow_stroke));
    }
    {
        Writer w(reach, period);
        w.go(middle);
        w.swing(0.03 * stroke, 1, 1, duration);
        all.push_back(w.done(TestMotion::small_sine));
    }
    {
        Writer w(reach, period);
        w.go(middle);
        w.swing(0.4 * stroke, 0.2, 5, duration);
        all.push_back(w.done(TestMotion::falling_sine));
    }
    {
        Writer w(reach, period);
        do {
            w.go(high), w.rest(1.5);
            w.go(low), w.rest(1.5);
        } while (w.time() < duration);
        all.push_back(w.done(TestMotion::steps_and_rests));
    }
    {
        Writer w(reach, period);
        w.go(low);
        for (const double part : {0.1, 0.33, 1.0}) to_and_fro(w, part, w.time() + duration / 3);
        all.push_back(w.done(TestMotion::steps_of_speed));
    }
    return all;
}

}  // namespace stickslip::gap
