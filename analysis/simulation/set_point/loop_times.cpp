#include "analysis/simulation/set_point/loop_times.h"

#include "analysis/numerics/polynomial.h"

#include <algorithm>
#include <complex>
#include <utility>

namespace stickslip {

LoopTimes times_of(const Regulator& r, double viscous)
{
    const double c = r.k_v + r.drag + viscous, m = r.inertia;
    LoopTimes times;
    const auto take = [&](const auto& roots) {
        for (const std::complex<double> s : roots) {
            const double time = 1 / std::abs(s);
            if (time > times.slow)
                times.next = std::exchange(times.slow, time), times.creeps = s.imag() == 0 && s.real() < 0;
            else
                times.next = std::max(times.next, time);
        }
    };
    if (r.k_i > 0)
        take(cubic_roots(c / m, r.k_p / m, r.k_i / m));
    else
        take(quadratic_roots(c / m, r.k_p / m));
    return times;
}

}  // namespace stickslip
