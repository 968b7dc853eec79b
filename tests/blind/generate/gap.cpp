#include "tests/blind/generate/gap.h"

#include "tests/blind/generate/random.h"

#include <cmath>

namespace blind {
namespace {

double mean_square(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum / a.size();
}

/// Mean square difference between one record and every member of its ensemble.
double to_ensemble(const Record& record, const std::vector<Record>& members, const Signal& s)
{
    double sum = 0;
    for (const auto& member : members) sum += mean_square(record.*s.values, member.*s.values);
    return sum / members.size();
}

double within_ensemble(const std::vector<Record>& members, const Signal& s)
{
    double sum = 0;
    int pairs = 0;
    for (std::size_t i = 0; i < members.size(); ++i)
        for (std::size_t j = 0; j < i; ++j, ++pairs) sum += mean_square(members[i].*s.values, members[j].*s.values);
    return sum / pairs;
}

}  // namespace

Ensemble simulate_often(const std::vector<Machine>& machines, const std::vector<Excitation>& excitations, int count,
                        std::uint64_t seed, int stride)
{
    Ensemble ensemble(excitations.size());
    for (std::size_t r = 0; r < excitations.size(); ++r)
        for (int i = 0; i < count; ++i)
            ensemble[r].push_back(run_loop(machines[r], excitations[r], seed_of(seed, 100 * r + i), stride));
    return ensemble;
}

Gap closed_loop_gap(const std::vector<Record>& records, const Ensemble& nominal, const Ensemble& truth,
                    const std::vector<Signal>& signals)
{
    Gap gap;
    gap.before_by_record.assign(records.size(), 0);
    const double share = 1.0 / signals.size();
    for (const auto& s : signals) {
        double before = 0, after = 0, floor = 0, weight = 0;
        for (std::size_t r = 0; r < records.size(); ++r) {
            const double w = records[r].size(), own_before = to_ensemble(records[r], nominal[r], s);
            const double own_floor = within_ensemble(nominal[r], s);
            before += w * own_before;
            floor += w * own_floor;
            if (!truth.empty()) after += w * to_ensemble(records[r], truth[r], s);
            weight += w;
            gap.before_by_record[r] += share * own_before / own_floor;
        }
        gap.signals.push_back(
            {s.name, s.unit, std::sqrt(before / weight), std::sqrt(after / weight), std::sqrt(floor / weight)});
        gap.before += share * before / floor;
        gap.after += share * after / floor;
    }
    gap.before = std::sqrt(gap.before);
    gap.after = std::sqrt(gap.after);
    for (double& b : gap.before_by_record) b = std::sqrt(b);
    return gap;
}

}  // namespace blind
