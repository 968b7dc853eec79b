#include "analysis/simulation/set_point/start_search.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double far = 100;  ///< of the larger of the least start and the slips

}  // namespace

Starts::Starts(double first, double lowest, double natural, int per_decade)
    : least(first),
      low(lowest),
      high(std::max(natural, first) * far),
      last(static_cast<int>(std::ceil(per_decade * std::log10(high / low))))
{
}

double Starts::distance(int i) const
{
    return least + low * std::pow(high / low, static_cast<double>(i) / last);
}

SetPoint no_cycle(const Starts& starts, double dead_zone, SetPointMethod method)
{
    SetPoint none;
    none.method = method;
    none.hunting = Hunting::no;
    none.reason = starts.least > dead_zone ? SetPointReason::held
                  : dead_zone > 0          ? SetPointReason::dead_zone
                                           : SetPointReason::slips_shrink;
    none.rest_error = std::max(starts.least, 0.0);
    none.searched_from = starts.least + starts.low, none.searched_to = starts.least + starts.high;
    return none;
}

double growth_of_distance(double beyond, double distance)
{
    return beyond > 0 ? std::max(std::log(beyond / distance), short_of_it) : short_of_it;
}

SearchedStarts search_starts(const Starts& starts, const std::function<TriedStart(double)>& slip_from,
                             const std::function<std::optional<SetPoint>(double, double)>& judged)
{
    SearchedStarts searched;
    for (int i = starts.last; i >= 0; --i) {
        const double distance = starts.distance(i);
        const auto [growth, failed] = slip_from(distance);
        searched.all_followed = searched.all_followed && !failed;
        searched.largest = std::max(searched.largest, growth);
        searched.answer = judged(distance, growth);
        if (searched.answer) break;
    }
    return searched;
}

SetPoint no_cycle_found(SetPoint none, const SearchedStarts& searched)
{
    if (!searched.all_followed) none.hunting = Hunting::undecided, none.reason = SetPointReason::not_converged;
    none.largest_ratio = std::exp(searched.largest);
    return none;
}

}  // namespace stickslip
