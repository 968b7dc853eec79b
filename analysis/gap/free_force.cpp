#include "analysis/gap/free_force.h"

#include "analysis/gap/block.h"
#include "analysis/gap/excerpt.h"
#include "analysis/gap/search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr std::size_t parts = FreeForce::coefficients;

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
        p.resize(2 + parts, coefficient("part"));
        return effect_of("position", p, [](FreeForce& f, const double* x) {
            f.present = true;
            f.from = x[0], f.width = x[1];
            std::copy(x + 2, x + 2 + parts, f.of_position.begin());
        });
    }();
    return effect;
}

const Effect& of_follower()
{
    static const Effect effect = [] {
        constexpr EffectParameter play{"play", Quantity::position, Scale::position, true, 1e-3, 2,
                                       0.1,    "half the play"};
        std::vector<EffectParameter> p{given("from", Scale::one), given("width", Scale::one), play};
        p.resize(3 + parts, coefficient("part"));
        return effect_of("hysteresis", p, [](FreeForce& f, const double* x) {
            f.present = true;
            f.from = x[0], f.width = x[1], f.play = x[2];
            std::copy(x + 3, x + 3 + parts, f.of_position.begin());
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

/// A shape and where its fit starts.
struct Shape {
    const Effect* effect;
    std::size_t given;  ///< so many parameters in front are
    Eigen::VectorXd start;
    bool remembers() const { return effect == &of_follower(); }
};

std::vector<Shape> shapes_of(const std::vector<Case>& cases, const Scales& scales)
{
    const auto [from, width] = reach(cases);
    const auto starting = [](const Effect& e, std::initializer_list<double> front) {
        Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(e.forms[0].parameters.size()));
        std::copy(front.begin(), front.end(), x.begin());
        return x;
    };
    std::vector<Shape> shapes{{&of_position(), 2, starting(of_position(), {from, width})},
                              {&of_velocity(), 1, starting(of_velocity(), {1})}};
    const double half = 0.5 * FreeForce::intervals * width / scales.position;
    for (double play : {0.05, 0.15, 0.4})
        shapes.push_back({&of_follower(), 2, starting(of_follower(), {from, width, std::log(play * half)})});
    return shapes;
}

}  // namespace

std::string in_words(const FreeFit& free)
{
    if (free.of == "hysteresis")
        return "a force that follows the position behind a play, and so differs on the way back,";
    return "a force that depends on the " + std::string(free.of) + " alone";
}

std::vector<FreeFit> fit_free_forces(const std::vector<Case>& cases, const Scales& scales, const Nominal& nominal,
                                     const ParallelFor& parallel)
{
    const double omega = screening_level(nominal);
    // what follows the position remembers, and excerpts cut that off
    const auto brief = excerpts(cases, omega, brief_ticks, coarse), whole = uncut(cases, coarse);
    const auto shapes = shapes_of(cases, scales);
    std::vector<FreeFit> fits(shapes.size());
    parallel(shapes.size(), [&](std::size_t i) {
        const Shape& shape = shapes[i];
        const auto& part = shape.remembers() ? whole : brief;
        const Candidate candidate{{shape.effect}, {&shape.effect->forms[0]}, cases.size()};
        Kept kept(candidate.parameter_count(), 0);
        std::fill_n(kept.begin(), shape.given, 1);
        auto first = kept;
        if (shape.remembers()) first[shape.given] = 1;  // a play without a force shows nothing
        auto fit = descend_block(part, candidate, scales, shape.start, omega, iterations, first);
        if (shape.remembers()) fit = descend_block(part, candidate, scales, fit.x, omega, iterations, kept);
        Attribution a = as_screened(cases, scales, nominal, candidate, fit);
        constexpr int few = 3;
        for (std::size_t l = 0; l < levels.size(); ++l) {
            const auto at_level = descend_block(part, candidate, scales, a.x[l], levels[l], few, kept);
            const auto all = evaluate(cases, candidate, in_si(candidate, at_level.x, scales), levels[l]);
            if (all.objective < a.evaluation[l].objective) a.x[l] = at_level.x, a.evaluation[l] = all;
        }
        a.refined = true;
        judge(a, nominal);
        fits[i] = {shape.effect->name, std::move(a)};
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
