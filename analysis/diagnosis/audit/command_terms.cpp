#include "analysis/diagnosis/audit/command_terms.h"

#include "analysis/diagnosis/audit/after_hole.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"

namespace stickslip::gap {
namespace {

bool cascaded(const Control& c)
{
    return c.structure == Structure::cascade;
}

/// Changes per unit at one tick, from what the controller sees and remembers.
struct Tick {
    double error, rate, velocity, rate_error, integral, error_integral, acceleration;
};

std::array<double, linear_terms> changes(const Control& c, const Tick& t, bool integrates)
{
    std::array<double, linear_terms> d{};
    const auto& f = c.feed_forward;
    if (cascaded(c)) {
        const double K_i = velocity_integral_gain(c), wanted = c.position_gain * t.error + t.rate_error;
        const bool by_time = is_set(c.velocity_reset_time);
        d[k_p_term] = c.position_gain * (c.velocity_gain * t.error + K_i * t.error_integral);
        d[k_v_term] = c.velocity_gain * wanted + (by_time ? K_i * t.integral : 0);
        d[k_i_term] = integrates ? K_i * t.integral : t.integral;
    } else {
        d[k_p_term] = c.k_p * t.error;
        d[k_v_term] = (c.k_v != 0 ? c.k_v : 1) * t.rate_error;
        d[k_i_term] = integrates ? c.k_i * t.integral : t.integral;
    }
    FeedForward unit = f;
    unit.coulomb = 1;
    d[coulomb_term] = unit.push(t.rate, t.velocity, t.error);
    d[acceleration_term] = t.acceleration;
    d[velocity_term] = c.reference_velocity ? gains_of(c).k_v * t.rate : 0;
    return d;
}

/// At a kink of the reference its rate is anybody's guess unless it was logged.
bool kinked(const Ticks& t, std::size_t k, double fastest)
{
    constexpr double bent = 0.02;  // numerical: of the largest rate
    if (k == 0 || k + 1 >= t.size()) return true;
    const double before = (t.reference[k] - t.reference[k - 1]) / t.step[k - 1],
                 after = (t.reference[k + 1] - t.reference[k]) / t.step[k];
    return std::abs(after - before) > bent * fastest;
}

/// Numbers the stretches between holes. A hole soon after the last begins none: in few rows nothing shows but what the
/// integral begins with.
class Stretches {
  public:
    explicit Stretches(std::size_t first) : now_(first) {}
    void lose_a_row() { lost_ = true; }
    std::size_t of_next_row()
    {
        constexpr int few = 500;  // numerical: rows
        if (lost_ && rows_ >= few) ++now_, rows_ = 0;
        lost_ = false, ++rows_;
        return now_;
    }

  private:
    std::size_t now_;
    int rows_ = 0;
    bool lost_ = false;
};

void add_record(CommandTerms& terms, const Case& c, std::size_t record, double dead_zone, double limit)
{
    const Ticks& t = c.ticks;
    Joint joint = c.joint;
    joint.control.dead_zone = dead_zone;
    const Control& control = joint.control;
    Controller controller(joint);
    const bool believed = t.velocity_believed();
    double fastest = 0, own_integral = 0, error_integral = 0;
    for (double rate : t.reference_rate) fastest = std::max(fastest, std::abs(rate));
    auto restart = t.restarts.begin();
    AfterHole hole(t, control);
    Stretches stretches(terms.rows.empty() ? 0 : terms.rows.back().stretch + 1);
    for (std::size_t k = 0; k < t.size(); ++k) {
        const bool blind = hole.holds(k);
        if (t.lost && t.of_a_row(k) && !t.logged[k]) stretches.lose_a_row();
        if (restart != t.restarts.end() && restart->tick == k)
            controller.restart(restart->integral), own_integral = error_integral = 0, ++restart;
        const double step = k == 0 ? t.step[0] : t.step[k - 1];
        controller.read(t.position[k], step, is_set(t.velocity[k]) ? t.velocity[k] : 0);
        if (believed && is_set(t.velocity[k])) controller.believe(t.velocity[k]);
        const double rate = t.reference_rate[k], before = k == 0 ? rate : t.reference_rate[k - 1];
        controller.command(t.reference[k], rate, t.added(k), t.time[k]);
        const double error = t.reference[k] - t.position[k];
        Tick now;
        now.error = error - std::clamp(error, -dead_zone, dead_zone);
        now.rate = rate, now.velocity = controller.velocity();
        now.rate_error =
            (control.reference_velocity ? control.feed_forward.velocity * rate : 0) - controller.velocity();
        now.acceleration = (rate - before) / step;
        error_integral += step * now.error;
        own_integral += step * (cascaded(control) ? control.position_gain * now.error + now.rate_error : now.error);
        now.integral = controller.integrates() ? controller.integral() : own_integral;
        now.error_integral = error_integral;
        if (blind || !is_set(t.command[k]) || std::abs(t.command[k]) > policy::below_limit * limit || !t.enabled[k] ||
            !c.judged(k))
            continue;
        // of a kink one tick ago the acceleration is no better known than the rate there
        if (kinked(t, k, fastest) || kinked(t, k - 1, fastest)) continue;
        terms.rows.push_back({t.command[k] - controller.wanted(), t.command[k],
                              changes(control, now, controller.integrates()), record, stretches.of_next_row()});
        terms.square += t.command[k] * t.command[k];
    }
    terms.integrates |= controller.integrates();
}

}  // namespace

CommandTerms command_terms(const std::vector<Case>& cases, double dead_zone, double limit)
{
    CommandTerms terms;
    for (std::size_t i = 0; i < cases.size(); ++i) add_record(terms, cases[i], i, dead_zone, limit);
    const Control& c = cases[0].joint.control;
    terms.possible.fill(true);
    terms.factor[k_p_term] = true;
    terms.factor[k_v_term] = cascaded(c) || c.k_v != 0;
    terms.factor[k_i_term] = terms.integrates;
    terms.possible[velocity_term] = c.reference_velocity && gains_of(c).k_v != 0;
    return terms;
}

CommandTerms averaged(const CommandTerms& terms, std::size_t rows)
{
    CommandTerms means = terms;
    means.rows.clear();
    means.square /= static_cast<double>(rows);  // what moves slowly is all in the means
    const double part = 1 / static_cast<double>(rows);
    for (std::size_t from = 0; from + rows <= terms.rows.size();) {
        if (terms.rows[from + rows - 1].stretch != terms.rows[from].stretch) {
            ++from;
            continue;
        }
        CommandTerms::Row mean{.record = terms.rows[from].record, .stretch = terms.rows[from].stretch};
        for (std::size_t k = from; k < from + rows; ++k) {
            mean.left += part * terms.rows[k].left, mean.command += part * terms.rows[k].command;
            for (std::size_t i = 0; i < mean.change.size(); ++i) mean.change[i] += part * terms.rows[k].change[i];
        }
        means.rows.push_back(mean);
        from += rows;
    }
    return means;
}

CommandTerms of_record(const CommandTerms& terms, std::size_t record)
{
    CommandTerms own = terms;
    std::erase_if(own.rows, [&](const auto& row) { return row.record != record; });
    for (auto& row : own.rows) row.record = 0;
    if (!terms.rows.empty())
        own.square *= static_cast<double>(own.rows.size()) / static_cast<double>(terms.rows.size());
    return own;
}

}  // namespace stickslip::gap
