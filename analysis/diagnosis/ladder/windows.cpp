#include "analysis/diagnosis/ladder/windows.h"

#include "analysis/diagnosis/fit/residuals.h"
#include "analysis/diagnosis/policy/ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::gap {

HeldOutData::HeldOutData(std::vector<Case> documented) : documented_(std::move(documented)), fitted_(documented_)
{
    for (std::size_t fold = 0; fold < folds; ++fold) {
        rest_[fold] = documented_;
        for (std::size_t i = 0; i < documented_.size(); ++i) {
            const Ticks& t = documented_[i].ticks;
            const std::size_t part = (fold + i) % folds, rows = t.rows();
            const double length = t.duration() / folds;
            const double from =
                part == 0 ? std::numeric_limits<double>::lowest() : t.time.front() + static_cast<double>(part) * length;
            const double to = part + 1 == folds ? infinity : t.time.front() + static_cast<double>(part + 1) * length;
            rest_[fold][i].skip_from = from, rest_[fold][i].skip_to = to;
            Window w{i, rows, rows};
            std::size_t row = 0;
            for (std::size_t k = 0; k < t.size(); ++k) {
                if (!t.logged[k]) continue;
                if (t.time[k] >= from && w.from == rows) w.from = row;
                if (t.time[k] >= to && w.to == rows) w.to = row;
                ++row;
            }
            if (w.from < w.to) windows_[fold].push_back(w);
        }
    }
}

double HeldOutData::raise_floor(const Candidate& candidate, const std::vector<double>& si)
{
    const auto now = evaluate(documented_, candidate, si, levels[ladder_level]);
    double left = 0;
    for (std::size_t i = 0; i < documented_.size(); ++i) {
        const double raised = std::sqrt(std::max(1.0, now.records[i].position));
        const double sigma = documented_[i].sigma * raised, drive = documented_[i].drive_sigma * raised;
        const double effort = documented_[i].effort_sigma * std::sqrt(std::max(1.0, now.records[i].effort));
        const auto raise = [&](Case& c) { c.sigma = sigma, c.drive_sigma = drive, c.effort_sigma = effort; };
        raise(fitted_[i]);
        for (auto& rest : rest_) raise(rest[i]);
        left += std::log(std::max(1.0, now.records[i].position) * std::max(1.0, now.records[i].effort));
    }
    return left / static_cast<double>(documented_.size());
}

std::vector<Window> HeldOutData::judge(std::size_t fold, const Candidate& candidate,
                                       const std::vector<double>& si) const
{
    return squares(fold, residuals_at(documented_, candidate, {{si, levels[ladder_level]}})[0]);
}

std::array<std::vector<Window>, HeldOutData::folds> HeldOutData::judge(
    const Candidate& candidate, const std::array<std::vector<double>, folds>& si) const
{
    std::vector<Place> places;
    for (const auto& numbers : si) places.push_back({numbers, levels[ladder_level]});
    const auto residuals = residuals_at(documented_, candidate, places);
    std::array<std::vector<Window>, folds> judged;
    for (std::size_t fold = 0; fold < folds; ++fold) judged[fold] = squares(fold, residuals[fold]);
    return judged;
}

std::vector<Window> HeldOutData::squares(std::size_t fold, const std::vector<double>& residuals) const
{
    std::vector<std::size_t> begin;
    for (std::size_t i = 0, at = 0; i < documented_.size(); ++i) {
        begin.push_back(at);
        at += documented_[i].ticks.rows() * (documented_[i].effort_sigma > 0 ? 2 : 1);
    }
    const auto mean_square = [&](std::size_t from, std::size_t to) {
        double sum = 0;
        for (std::size_t i = from; i < to; ++i) sum += residuals[i] * residuals[i];
        return sum / static_cast<double>(to - from);
    };
    auto windows = windows_[fold];
    for (auto& w : windows) {
        const Case& c = documented_[w.record];
        const std::size_t at = begin[w.record], effort = at + c.ticks.rows();
        w.position = mean_square(at + w.from, at + w.to);
        if (c.effort_sigma > 0) w.effort = mean_square(effort + w.from, effort + w.to);
    }
    return windows;
}

double mean_log(const std::vector<Window>& windows)
{
    double sum = 0, n = 0;
    for (const auto& w : windows) {
        sum += std::log(std::max(policy::least_square_of_window, w.position)), n += 1;
        if (is_set(w.effort)) sum += std::log(std::max(policy::least_square_of_window, w.effort)), n += 1;
    }
    return n > 0 ? sum / n : 0;
}

double misfit(const std::vector<Window>& windows)
{
    double sum = 0, n = 0;
    for (const auto& w : windows) {
        sum += std::log(std::max(1.0, w.position)), n += 1;
        if (is_set(w.effort)) sum += std::log(std::max(1.0, w.effort)), n += 1;
    }
    return n > 0 ? sum / n : 0;
}

double beyond_noise(const std::vector<Window>& windows)
{
    double sum = 0;
    for (const auto& w : windows) sum += w.beyond_noise();
    return sum;
}

}  // namespace stickslip::gap
