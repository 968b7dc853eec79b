// In one file: the free shapes and the one fit that they share.
#include "analysis/diagnosis/search/free_force.h"

#include "analysis/diagnosis/fit/excerpt.h"
#include "analysis/diagnosis/fit/problem.h"
#include "analysis/diagnosis/policy/search.h"
#include "analysis/diagnosis/search/search.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

constexpr std::size_t parts = FreeForce::coefficients;

constexpr EffectParameter coefficient(std::string_view name)
{
    return {name, Quantity::effort, Scale::load_effort, false, -10, 10, 0.1, "part of the force"};
}

/// A place or a size that is given, not fitted.
constexpr EffectParameter given(std::string_view name, Scale scale)
{
    return {name, Quantity::position, scale, false, -1e12, 1e12, 0, "given"};
}

Effect effect_of(std::string_view name, std::vector<EffectParameter> parameters,
                 void (*apply)(FreeForce&, const double*))
{
    EffectForm form;
    form.parameters = std::move(parameters);
    form.apply_free = apply;
    Effect e;
    e.name = name;
    e.stage = Stage::outside;
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
        std::vector<EffectParameter> p{
            given("from", Scale::one),
            given("width", Scale::one),
            {"play", Quantity::position, Scale::one, true, 1e-9, 1e3, 0.1, "half the play, m | rad"},
        };
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
        std::vector<EffectParameter> p{given("speed", Scale::load_velocity)};
        p.resize(4, coefficient("part"));
        return effect_of("velocity", p, [](FreeForce& f, const double* x) {
            f.present = true;
            f.speed = x[0];
            f.linear = x[1], f.quadratic = x[2], f.cubic = x[3];
        });
    }();
    return effect;
}

/// In every record another one: what is picked up when is no property of the joint.
const Effect& of_time()
{
    static const Effect effect = [] {
        std::vector<EffectParameter> p{given("from", Scale::one), given("width", Scale::one)};
        p.resize(2 + parts, {"part", Quantity::number, Scale::one, false, -0.95, 10, 0.1, "part of the inertia"});
        Effect e = effect_of("inertia", p, [](FreeForce& f, const double* x) {
            f.present = f.moves_inertia = true;
            f.time_from = x[0], f.time_width = x[1];
            std::copy(x + 2, x + 2 + parts, f.of_inertia.begin());
        });
        e.forms[0].own = e.forms[0].parameters.size();
        return e;
    }();
    return effect;
}

/// The reach of the link, on which the force acts, in intervals of the spline.
std::pair<double, double> reach(const std::vector<Case>& cases)
{
    double low = infinity, high = -infinity;
    for (const auto& c : cases) {
        const Plant plant = flatten(c.joint);
        const double per_link = plant.two_mass && !plant.feedback_link ? plant.ratio : 1;
        for (const double reading : c.ticks.position) {
            const double q = (reading - plant.sensor.position_offset) / plant.sensor.position_scale / per_link;
            low = std::min(low, q), high = std::max(high, q);
        }
    }
    return {low, std::max(high - low, 1e-12) / FreeForce::intervals};
}

struct Shape {
    const Effect* effect;
    std::size_t given;  ///< how many parameters in front are given, not fitted
    /// Of every start what stands before the parts of the force, which are 0; of a shape that every record has for
    /// itself, one for each record behind the other.
    std::vector<std::vector<double>> front;

    bool remembers() const { return effect == &of_follower(); }
};

/// A shape behind the nuisance parameters, if there are any.
struct Beside {
    Candidate candidate;
    std::size_t numbers = 0;  ///< of the corrections

    Beside(const Shape& shape, std::size_t records, const Corrections* corrections)
        : candidate{{shape.effect}, {&shape.effect->forms[0]}, records}
    {
        if (!corrections) return;
        const Corrected corrected = corrections->beside(candidate);
        candidate = corrected.candidate, numbers = corrected.numbers;
    }
    /// Where the numbers of the shape begin; of one that every record has for itself, where each record's do.
    std::vector<std::size_t> blocks() const
    {
        const EffectForm& form = *candidate.forms.back();
        std::vector<std::size_t> begin;
        for (std::size_t r = 0; r < (form.own > 0 ? candidate.records : 1); ++r)
            begin.push_back(numbers + r * form.own);
        return begin;
    }
    /// So many parameters of the shape keep their values.
    Kept kept(std::size_t first) const
    {
        Kept k(candidate.parameter_count(), 0);
        for (const std::size_t begin : blocks()) std::fill_n(k.begin() + static_cast<std::ptrdiff_t>(begin), first, 1);
        return k;
    }
    /// A shape that does nothing yet.
    Eigen::VectorXd start(const std::vector<double>& front) const
    {
        Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(candidate.parameter_count()));
        const auto begin = blocks();
        const auto each = static_cast<std::ptrdiff_t>(front.size() / begin.size());
        for (std::size_t b = 0; b < begin.size(); ++b)
            std::copy_n(front.begin() + static_cast<std::ptrdiff_t>(b) * each, each,
                        x.begin() + static_cast<std::ptrdiff_t>(begin[b]));
        return x;
    }
};

std::vector<Shape> shapes_of(const std::vector<Case>& cases)
{
    const auto [from, width] = reach(cases);
    const double travel = FreeForce::intervals * width;
    Shape follower{&of_follower(), 2, {}};
    for (double play : {0.025, 0.075, 0.2}) follower.front.push_back({from, width, std::log(play * travel)});
    Shape over_time{&of_time(), 2, {{}}};
    for (const auto& c : cases) {
        over_time.front[0].push_back(c.ticks.time.front());
        over_time.front[0].push_back(c.ticks.duration() / FreeForce::intervals);
    }
    return {{&of_position(), 2, {{from, width}}}, {&of_velocity(), 1, {{1}}}, follower, over_time};
}

/// All that the error of a known load adds to the prediction floors, as `mean_log_misfit` has it.
double gain_by_load_error(const std::vector<Case>& cases)
{
    double sum = 0, n = 0;
    for (const auto& c : cases) {
        Case exact = c;
        exact.load_sigma = {};
        for (const double omega : levels)
            sum += 2 * std::log(reading_floor(c, omega) / reading_floor(exact, omega)), n += 1;
        n += 1;  // of the effort, which has no part of it
    }
    return sum / n;
}

}  // namespace

std::vector<FreeFit> fit_free_forces(const Fit& context, const Corrections* corrections)
{
    const auto& cases = context.cases;
    const Scales& scales = context.scales;
    const double omega = screening_level(context.nominal);
    // what follows the position remembers, and excerpts cut that off
    const auto brief = excerpts(cases, omega, brief_ticks, coarse), whole = uncut(cases, coarse);
    const auto part = [&](const Shape& shape) -> const std::vector<Case>& { return shape.remembers() ? whole : brief; };
    const auto shapes = shapes_of(cases);
    struct Start {
        std::size_t shape;
        std::vector<double> front;
        LevelFit fit;
    };
    std::vector<Start> starts;
    for (std::size_t s = 0; s < shapes.size(); ++s)
        for (const auto& front : shapes[s].front) starts.push_back({s, front, {}});
    context.parallel(starts.size(), [&](std::size_t i) {
        const Shape& shape = shapes[starts[i].shape];
        const Beside beside(shape, cases.size(), corrections);
        const Candidate& candidate = beside.candidate;
        const auto& front = starts[i].front;
        LevelFit& fit = starts[i].fit;
        const std::size_t in_front = front.size() / beside.blocks().size();
        // first the force alone: hysteresis without a force shows nothing
        const FitProblem problem{part(shape), candidate, scales, omega};
        fit = descend(problem, beside.start(front), iterations, beside.kept(in_front));
        if (in_front > shape.given) fit = descend(problem, fit.x, iterations, beside.kept(shape.given));
    });
    const double by_load_error = gain_by_load_error(cases);
    std::vector<FreeFit> fits(shapes.size());
    context.parallel(shapes.size(), [&](std::size_t i) {
        const Shape& shape = shapes[i];
        const Beside beside(shape, cases.size(), corrections);
        const Candidate& candidate = beside.candidate;
        const Start* best = nullptr;
        for (const auto& s : starts)
            if (s.shape == i && (!best || s.fit.evaluation.objective < best->fit.evaluation.objective)) best = &s;
        Attribution a = as_screened(context, candidate, best->fit);
        constexpr int few = 3;
        for (std::size_t l = 0; l < levels.size(); ++l) {
            const auto fit =
                descend({part(shape), candidate, scales, levels[l]}, a.x[l], few, beside.kept(shape.given));
            const auto all = evaluate(cases, candidate, in_si(candidate, fit.x, scales), levels[l]);
            if (all.objective < a.evaluation[l].objective) a.x[l] = fit.x, a.evaluation[l] = all;
        }
        a.refined = true;
        judge(a, context.nominal);
        fits[i] = {shape.effect->name, std::move(a), by_load_error};
    });
    // a follower with next to no width is the position
    const auto misfit = [](const FreeFit& f) {
        return mean_log_misfit(f.fit.evaluation) + (f.of == of_follower().name ? policy::least_of_free_force : 0.0);
    };
    std::stable_sort(fits.begin(), fits.end(), [&](const auto& a, const auto& b) { return misfit(a) < misfit(b); });
    return fits;
}

bool clearly_better(const FreeFit& free, const Attribution& cause)
{
    return clearly_better(free, mean_log_misfit(cause.evaluation));
}

bool clearly_better(const FreeFit& free, double left)
{
    return mean_log_misfit(free.fit.evaluation) <
           left - std::max(std::max(policy::least_of_free_force, policy::better_than_cause * left), free.by_load_error);
}

}  // namespace stickslip::gap
