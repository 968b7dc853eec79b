#include "analysis/gap/free_force.h"

#include "analysis/gap/block.h"
#include "analysis/gap/excerpt.h"
#include "analysis/gap/search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr std::size_t shapes = FreeForce::coefficients;

constexpr EffectParameter coefficient(std::string_view name)
{
    return {name, Quantity::effort, Scale::effort, false, -10, 10, 0.1, "part of the force"};
}

/// A place or a size that is given, not fitted.
constexpr EffectParameter given(std::string_view name, Scale scale)
{
    return {name, Quantity::position, scale, false, -1e9, 1e9, 0, "given"};
}

Effect effect_of(std::string_view name, std::vector<EffectParameter> parameters,
                 void (*apply)(FreeForce&, const double*))
{
    EffectForm form;
    form.parameters = std::move(parameters);
    form.apply_free = apply;
    Effect e;
    e.name = name;
    e.stage = "outside";
    e.forms.push_back(std::move(form));
    return e;
}

const Effect& of_position()
{
    static const Effect effect = [] {
        std::vector<EffectParameter> p{given("from", Scale::one), given("width", Scale::one)};
        p.resize(2 + shapes, coefficient("part"));
        return effect_of("position", p, [](FreeForce& f, const double* x) {
            f.present = true;
            f.from = x[0], f.width = x[1];
            std::copy(x + 2, x + 2 + shapes, f.of_position.begin());
        });
    }();
    return effect;
}

const Effect& of_velocity()
{
    static const Effect effect = [] {
        std::vector<EffectParameter> p{given("speed", Scale::velocity)};
        p.resize(4, coefficient("part"));
        return effect_of("velocity", p, [](FreeForce& f, const double* x) {
            f.present = true;
            f.speed = x[0];
            f.linear = x[1], f.quadratic = x[2], f.cubic = x[3];
        });
    }();
    return effect;
}

/// The reach of the positions, in intervals of the spline.
std::pair<double, double> reach(const std::vector<Case>& cases)
{
    double low = infinity, high = -infinity;
    for (const auto& c : cases) {
        const auto [a, b] = std::minmax_element(c.ticks.position.begin(), c.ticks.position.end());
        low = std::min(low, *a), high = std::max(high, *b);
    }
    return {low, std::max(high - low, 1e-12) / FreeForce::intervals};
}

}  // namespace

std::vector<FreeFit> fit_free_forces(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                                     const ParallelFor& parallel)
{
    const double omega = screening_level(nominal);
    const auto brief = excerpts(cases, omega, brief_ticks, coarse);
    const auto [from, width] = reach(cases);
    std::vector<FreeFit> fits{{"position", {}}, {"velocity", {}}};
    parallel(fits.size(), [&](std::size_t i) {
        const Effect& e = i == 0 ? of_position() : of_velocity();
        const Candidate candidate{{&e}, {&e.forms[0]}, cases.size()};
        const std::size_t set = i == 0 ? 2 : 1;  // parameters in front that are given
        Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(candidate.parameter_count()));
        x[0] = i == 0 ? from : 1;
        if (i == 0) x[1] = width;
        Kept kept(candidate.parameter_count(), 0);
        std::fill_n(kept.begin(), set, 1);
        Attribution a = as_screened(cases, scales, nominal, candidate,
                                    descend_block(brief, candidate, scales, x, omega, iterations, kept));
        constexpr int few = 3;
        for (std::size_t l = 0; l < levels.size(); ++l) {
            const auto fit = descend_block(brief, candidate, scales, a.x[l], levels[l], few, kept);
            const auto all = evaluate(cases, candidate, in_si(candidate, fit.x, scales), levels[l]);
            if (all.objective < a.evaluation[l].objective) a.x[l] = fit.x, a.evaluation[l] = all;
        }
        a.refined = true;
        judge(a, nominal);
        fits[i].fit = std::move(a);
    });
    std::stable_sort(fits.begin(), fits.end(), [](const FreeFit& a, const FreeFit& b) {
        return mean_log_misfit(a.fit.evaluation) < mean_log_misfit(b.fit.evaluation);
    });
    return fits;
}

bool clearly_better(const FreeFit& free, const Attribution& cause)
{
    constexpr double part = 0.25;  // of what the cause leaves
    const double left = mean_log_misfit(cause.evaluation);
    return mean_log_misfit(free.fit.evaluation) < left - std::max(least_of_free_force, part * left);
}

}  // namespace stickslip::gap
