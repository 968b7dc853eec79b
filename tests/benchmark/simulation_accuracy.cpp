// How right the lanes are: thousands of random joints against CVODE at rtol 1e-11, on two threads.
//   benchmark_simulation_accuracy [joints] [seed]
// Half of the joints are asked for the outcome of one small disturbance, half for all three regions. Ends with 1 if an
// outcome differs, more than 0.1 % are undecided, or an error exceeds its bound.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "analysis/simulation/points.h"
#include "analysis/stability/verdict.h"
#include "sweep/engine/cursor.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/program/verbs/embedded.h"
#include "tests/analysis/simulation/lanes/lanes_comparison.h"

namespace {

using namespace stickslip;

constexpr double growth_bound = 1e-5, period_bound = 1e-5, amplitude_bound = 1e-3, undecided_bound = 1e-3;
constexpr std::size_t block = 50;  // joints that share a call, so that lanes are full

void describe(const char* what, std::size_t number, const Joint& joint, const Compared& c)
{
    const auto name = [](Outcome o) { return std::string(code_name("outcome", static_cast<std::uint8_t>(o))); };
    std::printf("  %s: joint %zu, m %.17g, k_p %.17g, k_v %.17g, V0 %.17g, lanes %s/%d, CVODE %s/%d\n", what, number,
                joint.mechanism.inertia, joint.control.k_p, joint.control.k_v, joint.control.V0,
                name(c.row.outcome).c_str(), static_cast<int>(c.row.region), name(c.truth.outcome).c_str(),
                static_cast<int>(c.truth.region));
    const auto linear = linear_point(joint);
    std::printf(
        "    errors: growth %.3g, period %.3g, amplitude %.3g; growth rate %.10g, CVODE %.10g, spectrum %.10g 1/s\n",
        c.growth, c.period, c.amplitude, c.row.growth_rate, c.true_growth, linear.spectral_abscissa);
}

bool print(const char* title, const std::vector<Joint>& joints, std::vector<Compared> compared)
{
    int mismatches = 0, undecided = 0, by_lanes = 0, cycles = 0, bistable = 0;
    for (std::size_t i = 0; i < compared.size(); ++i) {
        const auto& c = compared[i];
        mismatches += !c.same_outcome();
        undecided += c.undecided();
        by_lanes += c.row.path == DecisionPath::lanes;
        cycles += std::isfinite(c.row.period);
        bistable += c.row.region == Region::bistable;
        if (!c.same_outcome()) describe("mismatch", i, joints[i], c);
    }
    const auto worst = [&](double Compared::*error) {
        return std::max_element(compared.begin(), compared.end(),
                                [=](const Compared& a, const Compared& b) { return a.*error < b.*error; });
    };
    const auto show = [&](const char* what, double Compared::*error, double bound) {
        std::vector<double> all;
        for (const auto& c : compared)
            if (c.*error > 0) all.push_back(c.*error);
        std::sort(all.begin(), all.end());
        const auto at = worst(error);
        if (all.empty()) return true;
        std::printf("  %-10s largest error %.3g, median %.3g (bound %.0g)\n", what, all.back(), all[all.size() / 2],
                    bound);
        const bool good = all.back() < bound;
        if (!good)
            describe(what, static_cast<std::size_t>(at - compared.begin()),
                     joints[static_cast<std::size_t>(at - compared.begin())], *at);
        return good;
    };
    std::printf("%s: %zu joints, %d cycles, %d bistable; %d decided by lanes, %d undecided, %d mismatches\n", title,
                compared.size(), cycles, bistable, by_lanes, undecided, mismatches);
    const bool growth =
        show("growth", &Compared::growth, growth_bound) & show("spectrum", &Compared::row_spectrum, growth_bound);
    show("CVODE", &Compared::truth_spectrum, growth_bound);
    const auto path = worst(&Compared::path_spectrum);
    std::printf("  the CVODE path of the product, in SI: largest error of growth against the spectrum %.3g\n",
                path->path_spectrum);
    std::printf("  rows that lanes left to CVODE: largest error of growth against the spectrum %.3g\n",
                worst(&Compared::left_over_spectrum)->left_over_spectrum);
    const bool period = show("period", &Compared::period, period_bound);
    const bool amplitude = show("amplitude", &Compared::amplitude, amplitude_bound);
    return growth && period && amplitude && mismatches == 0 &&
           undecided <= undecided_bound * static_cast<double>(compared.size());
}

std::vector<Compared> on_two_threads(const std::vector<Joint>& joints, bool region)
{
    std::vector<Compared> compared(joints.size());
    const auto work = [&](std::size_t first) {
        for (std::size_t i = first * block; i < joints.size(); i += 2 * block) {
            const std::size_t count = std::min(block, joints.size() - i);
            const auto part = compare_with_cvode(std::span(joints).subspan(i, count), region);
            std::copy(part.begin(), part.end(), compared.begin() + static_cast<std::ptrdiff_t>(i));
        }
    };
    std::thread other(work, 1);
    work(0);
    other.join();
    return compared;
}

/// The map of the embedded example, every point followed: measured growth against the spectrum.
bool default_map()
{
    constexpr std::size_t chunk = 4096;
    constexpr double neutral = 1e-6;  // per |s|: closer to the boundary the spectrum decides
    const Spec spec = read_spec_text(embedded_spec(), "(embedded example)");
    PointCursor cursor(design_joint(spec), spec.axes);
    NonlinearOptions options;
    options.region = false;
    double worst = 0;
    std::size_t measured = 0, cycles = 0, wrong = 0, undecided = 0;
    std::vector<Joint> joints;
    std::vector<PointResult> rows;
    for (std::uint64_t next = 0; next < spec.points();) {
        joints.clear(), rows.clear();
        for (; next < spec.points() && joints.size() < chunk; ++next, cursor.advance()) {
            joints.push_back(cursor.joint());
            rows.push_back(linear_point(joints.back()));
        }
        nonlinear_points(joints, options, rows);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto& r = rows[i];
            undecided += r.outcome == Outcome::undecided || r.outcome == Outcome::solver_failure;
            cycles += std::isfinite(r.period);
            wrong += (r.outcome == Outcome::stable_sliding) != (r.spectral_abscissa < 0);
            const auto scale = std::sqrt(joints[i].control.k_p / joints[i].mechanism.inertia);
            if (std::abs(r.spectral_abscissa) < neutral * scale) continue;
            ++measured;
            worst = std::max(worst, relative_error(r.growth_rate, r.spectral_abscissa));
        }
    }
    std::printf(
        "embedded example: %llu points, %zu cycles, %zu undecided, %zu against the spectrum's sign; growth of %zu "
        "against the spectrum: largest error %.3g\n",
        static_cast<unsigned long long>(spec.points()), cycles, undecided, wrong, measured, worst);
    return worst < growth_bound && wrong == 0 && undecided == 0;
}

}  // namespace

int main(int argc, char** argv)
{
    const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2200;
    const unsigned seed = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 31;
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    std::printf("seed %u\n", seed);
    bool good = default_map();
    for (const bool region : {false, true}) {
        const auto slip = random_joints(count / 2, seed + region);
        good &= print(region ? "slip law, three regions" : "slip law, one small disturbance", slip,
                      on_two_threads(slip, region));
        const auto ageing = random_ageing_joints(count / 2, seed + region);
        good &= print(region ? "ageing law, three regions" : "ageing law, one small disturbance", ageing,
                      on_two_threads(ageing, region));
        const auto stribeck = random_stribeck_joints(count / 2, seed + region);
        good &= print(region ? "Stribeck, three regions" : "Stribeck, one small disturbance", stribeck,
                      on_two_threads(stribeck, region));
    }
    return good ? 0 : 1;
}
