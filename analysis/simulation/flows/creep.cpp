#include "analysis/simulation/flows/creep.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double least_share = 0.1;            ///< of the bracket between its middle and an end
constexpr double close = 1e-4;                 ///< of an amplitude that growth turns at
constexpr double farthest = 4, nearest = 0.2;  ///< amplitudes within reach, per the present one
constexpr double outward = 2, homeward = 0.6;  ///< steps where nothing lies ahead
constexpr double passing = 0.9;                ///< the longest step towards an amplitude that growth may turn at

}  // namespace

void Creep::note(double size, double growth)
{
    (growth > 0 ? grows_at_ : shrinks_at_) = size;
    (growth > 0 ? grows_by_ : shrinks_by_) = growth;
}

bool Creep::bracketed() const
{
    return grows_at_ < shrinks_at_ && grows_at_ > 0 && std::isfinite(shrinks_at_);
}

double Creep::middle() const
{
    const double share = std::clamp(grows_by_ / (grows_by_ - shrinks_by_), least_share, 1 - least_share);
    return std::sqrt(grows_at_ * grows_at_ * (1 - share) + shrinks_at_ * shrinks_at_ * share);
}

bool Creep::located(double size, double growth) const
{
    const double slope = (grows_by_ - shrinks_by_) / (shrinks_at_ * shrinks_at_ - grows_at_ * grows_at_);
    return bracketed() && std::abs(growth) < 2 * close * slope * size * size;
}

double Creep::next(double size, double growth, double ahead) const
{
    if (bracketed()) return middle();
    if (growth > 0) return outward * size;
    // what creeps inwards may be passing a fold: it must not be thrown over a cycle that it would have stopped at
    return std::isfinite(ahead) ? std::max(passing * size, ahead) : homeward * size;
}

double amplitude_ahead(double size, double growth, double last_growth)
{
    const double before = size * std::exp(-growth);
    const double still = std::sqrt(size * size - growth * (size * size - before * before) / (growth - last_growth));
    const bool in_reach = growth > 0 ? still > size && still < farthest * size : still < size && still > nearest * size;
    return in_reach ? still : missing;
}

}  // namespace stickslip
