#include "analysis/simulation/set_point/start_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stickslip {
namespace {

constexpr double far = 100;        ///< of the larger of the least start and the slips
constexpr int most_slips = 40;     ///< after which a motion that goes on is one of a cycle
constexpr int decades_beyond = 3;  ///< in which a loop that is unstable is seen to diverge
constexpr double in_cycle = 0.02;  ///< of its stops, by which one differs that is taken to be of it

StartEnd end_of_start(double x, const SetPoint& cycle, const std::function<SlipEnd(double)>& slip_from)
{
    const bool even = is_set(cycle.amplitude) && !cycle.asymmetric && cycle.hunting == Hunting::yes;
    for (int i = 0; i < most_slips; ++i) {
        const auto slip = slip_from(x);
        if (slip.end) return *slip.end;
        x = slip.x;
        if (even && std::abs(std::abs(x) - cycle.amplitude) < in_cycle * cycle.amplitude) break;
    }
    return StartEnd::hunts;
}

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

Starts Starts::further() const
{
    constexpr double times = 10;
    Starts s = *this;
    s.last += static_cast<int>(std::ceil(last / std::log10(high / low)));
    s.high *= times;
    return s;
}

SetPoint with_ends(SetPoint s, Starts starts, double side, const StartSearch& search,
                   const std::function<SlipEnd(double)>& slip_from)
{
    const auto end_at = [&](double distance) { return end_of_start(side * distance, s, slip_from); };
    if (!search.by_start) {
        s.rests_nearby =
            s.hunting == Hunting::yes && (starts.least > 0 || end_at(starts.distance(0)) == StartEnd::rests);
        return s;
    }
    std::vector<StartRange> ends;
    if (starts.least > 0) ends.push_back({0, starts.least, StartEnd::rests});
    const auto follow_from = [&](int first) {
        for (int i = first; i <= starts.last; ++i) {
            const double distance = starts.distance(i);
            const auto end = end_at(distance);
            if (ends.empty() || ends.back().end != end) ends.push_back({distance, distance, end});
            ends.back().to = distance;
        }
    };
    follow_from(0);
    for (int i = 0; search.unstable && i < decades_beyond && ends.back().end != StartEnd::diverges; ++i) {
        const int first = starts.last + 1;
        starts = starts.further();
        follow_from(first);
    }
    s.by_start = std::move(ends);
    s.starts = starts.last + 1;
    s.searched_from = starts.distance(0), s.searched_to = starts.distance(starts.last);
    s.rests_nearby = s.hunting == Hunting::yes && is_set(s.rests_within());
    return s;
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
