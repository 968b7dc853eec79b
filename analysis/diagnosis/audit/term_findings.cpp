#include "analysis/diagnosis/audit/term_findings.h"

#include "analysis/joint/gains.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

void correct(Control& c, int term, double value, bool factor)
{
    auto& f = c.feed_forward;
    const double by = 1 + value;
    switch (term) {
        case k_p_term:
            stated_position_gain(c) *= by;
            break;
        case k_v_term:
            stated_velocity_gain(c) = factor ? stated_velocity_gain(c) * by : value;
            break;
        case k_i_term:
            if (!factor)
                (c.structure == Structure::cascade ? c.velocity_integral_gain : c.k_i) = value;
            else if (c.structure == Structure::pid)
                c.k_i *= by;
            else if (is_set(c.velocity_reset_time))
                c.velocity_reset_time /= by;
            else
                c.velocity_integral_gain *= by;
            break;
        case coulomb_term:
            f.coulomb += value;
            break;
        case acceleration_term:
            f.acceleration += value;
            break;
        case velocity_term:
            f.velocity += value;
            break;
        default:
            break;
    }
}

AuditFinding finding_of(int term, const TermFit& fit, bool factor, const Control& corrected, double gain)
{
    const auto i = static_cast<std::size_t>(term);
    const double value = fit.value[i], error = fit.error[i];
    const auto gain_of = [&](const char* effect, Quantity quantity) {
        const std::string name = effect;
        return factor ? AuditFinding{name, name + ".factor", 1 + value, error, Quantity::number, gain}
                      : AuditFinding{name, name + ".value", value, error, quantity, gain};
    };
    const auto& f = corrected.feed_forward;
    switch (term) {
        case k_p_term:
            return gain_of("gain-k_p", Quantity::position_gain);
        case k_v_term:
            return gain_of("gain-k_v", Quantity::velocity_gain);
        case k_i_term:
            return gain_of("gain-k_i", corrected.structure == Structure::cascade ? Quantity::position_gain
                                                                                 : Quantity::integral_gain);
        case coulomb_term:
            return {"feed-forward", "feed-forward.coulomb", f.coulomb, error, Quantity::command, gain};
        case acceleration_term:
            return {"feed-forward", "feed-forward.acceleration", f.acceleration,
                    error,          Quantity::acceleration_gain, gain};
        default:
            return {"feed-forward", "feed-forward.velocity", f.velocity, error, Quantity::number, gain};
    }
}

namespace {

/// The rms of an added term over that of the command.
double part_of_command(const CommandTerms& all, int term, double value)
{
    double square = 0;
    for (const auto& row : all.rows) square += std::pow(value * row.change[static_cast<std::size_t>(term)], 2);
    return std::sqrt(square / all.square);
}

}  // namespace

double size_of(const CommandTerms& all, const TermFit& fit, int term)
{
    const auto i = static_cast<std::size_t>(term);
    return all.factor[i] ? std::abs(fit.value[i]) : part_of_command(all, term, fit.value[i]);
}

bool shows_filter(const std::vector<Case>& cases)
{
    const Control& c = cases[0].joint.control;
    return gains_of(c).k_v != 0 && c.velocity_estimate.form != EstimateForm::exact &&
           std::ranges::none_of(cases, [](const Case& k) { return k.ticks.velocity_believed(); });
}

double largest_error(const std::vector<Case>& cases)
{
    double largest = 0;
    for (const auto& c : cases)
        for (std::size_t k = 0; k < c.ticks.size(); ++k)
            largest = std::max(largest, std::abs(c.ticks.reference[k] - c.ticks.position[k]));
    return largest;
}

}  // namespace stickslip::gap
