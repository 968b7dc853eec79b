#include "analysis/diagnosis/audit/audit_terms.h"

#include "analysis/diagnosis/audit/audit_numbers.h"
#include "analysis/diagnosis/audit/command_terms.h"
#include "analysis/diagnosis/audit/term_findings.h"
#include "analysis/diagnosis/audit/term_sets.h"
#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/policy/audit.h"
#include "analysis/joint/gains.h"

#include <algorithm>
#include <optional>

namespace stickslip::gap {
namespace {

constexpr std::size_t most_changes = 3;  // numerical: of a search

/// The fewest changes that leave no more than the most.
Changed fewest_changes(const std::vector<Case>& cases, double limit)
{
    const double documented = cases[0].joint.control.dead_zone;
    const auto all = command_terms(cases, documented, limit);
    std::vector<Changed> found;
    for (std::size_t size = 0; size <= most_changes; ++size) {
        found.push_back(best_set(all, documented, size));
        if (found.back().fit.misfit < policy::digits) return found.back();
    }
    found.push_back(best_zone(cases, limit, largest_error(cases)));
    double least = infinity;
    for (const auto& f : found) least = std::min(least, f.fit.misfit);
    const Changed* best = nullptr;
    for (const auto& f : found)
        if (f.fit.misfit <= std::max(policy::enough * least, policy::digits) &&
            (!best || f.count(documented) < best->count(documented)))
            best = &f;
    return *best;
}

/// Whether plain gains, a filter beside them, are all that changed.
bool of_plain_gains(const Changed& changed)
{
    for (int term : changed.terms)
        if (term != k_p_term && term != k_v_term) return false;
    return changed.dead_zone == 0;
}

/// How much of the present sample the controller's integral does not count, where that is what a gain is off by: the
/// file's counts all of it (backward Euler), forward Euler none, the trapezoidal rule half.
std::optional<double> uncounted_sample(int term, double change, const Control& c)
{
    const bool cascade = c.structure == Structure::cascade;
    if (!is_set(c.period) || term != (cascade ? k_v_term : k_p_term)) return {};
    const double integral = !cascade                           ? c.k_i
                            : is_set(c.velocity_integral_gain) ? c.velocity_integral_gain
                            : is_set(c.velocity_reset_time)    ? c.velocity_gain / c.velocity_reset_time
                                                               : 0;
    const double sample = c.period * integral / (cascade ? c.velocity_gain : c.k_p);
    for (const double part : {1.0, 0.5})
        if (sample != 0 && std::abs(change / sample + part) < policy::same_sample) return part;
    return {};
}

/// Of changes that do not reproduce the command to digits, those that stand out of what is left: an acceleration is the
/// reference's before a tick or after it, and jumps, and small changes of the gains follow that as far as they can.
Changed standing_out(const CommandTerms& all, Changed changed)
{
    const auto least = policy::rough_multiple * changed.fit.misfit;
    std::erase_if(changed.terms, [&](int term) { return size_of(all, changed.fit, term) < least; });
    changed.fit = fit_terms(all, changed.terms);
    return changed;
}

/// A limit that was found beside the documented gain is one of that gain's share: of another gain it is by as much
/// another limit, which may be the documented one after all.
void scale_found_limit(std::vector<Case>& cases, double documented, double by, Audit& result)
{
    const auto found = std::ranges::find(result.findings, "gain-k_i.integral_limit", &AuditFinding::parameter);
    if (found == result.findings.end()) return;
    found->value *= by;
    const bool same = std::abs(found->value - documented) < policy::flagged_gain * documented;
    for (auto& c : cases) c.joint.control.integral_limit = same ? documented : found->value;
    if (same) result.findings.erase(found);
}

}  // namespace

bool audit_terms(std::vector<Case>& cases, double limit, Audit& result)
{
    const Control documented = cases[0].joint.control;
    const bool plain = is_plain(documented);
    const auto as_documented = command_terms(cases, documented.dead_zone, limit);
    if (as_documented.rows.empty()) return false;
    const double before = fit_terms(as_documented, {}).misfit;
    const double with_gains = plain ? fit_terms(as_documented, {k_p_term, k_v_term}).misfit : before;
    if (plain && std::min(before, with_gains) < policy::digits) return false;
    const bool filtered = shows_filter(cases) && !result.filter_seen;
    if (!plain && filtered && before > policy::digits) find_filter(cases, limit, result);
    if (as_documented.integrates && left_by_one(cases, limit) > policy::digits)
        find_integral_limit(cases, limit, result);
    if (documented.feed_forward.coulomb == 0 && left_by_one(cases, limit) > policy::digits)
        find_coulomb_speed(cases, limit);
    Changed changed = fewest_changes(cases, limit);
    const auto all = command_terms(cases, changed.dead_zone, limit);
    const bool exact = changed.fit.misfit < policy::understood;
    if (!exact) changed = standing_out(all, std::move(changed));
    const bool roughly = changed.fit.misfit < policy::rough_command && !changed.terms.empty();
    const bool believed = (exact || roughly) && changed.fit.misfit < policy::much_better * with_gains;
    const bool of_coulomb = std::ranges::count(changed.terms, coulomb_term) > 0;
    if (!of_coulomb || (plain && !believed))
        for (auto& c : cases) c.joint.control.feed_forward.coulomb_speed = documented.feed_forward.coulomb_speed;
    if (plain && (of_plain_gains(changed) || !believed)) return false;
    result.residual_after = changed.fit.misfit;
    result.command_explained = changed.fit.misfit < policy::understood;
    if (!result.command_explained && changed.fit.misfit > policy::much_better * before) {
        result.notes.push_back({.code = Note::Code::command_unknown, .values = {before}});
        return true;
    }
    const double gain = 1 - std::pow(changed.fit.misfit / before, 2);
    for (const int term : changed.terms) {
        const auto i = static_cast<std::size_t>(term);
        const bool factor = all.factor[i];
        if (size_of(all, changed.fit, term) < policy::flagged_gain) continue;
        const auto uncounted =
            factor ? uncounted_sample(term, changed.fit.value[i], cases[0].joint.control) : std::nullopt;
        for (auto& c : cases) correct(c.joint.control, term, changed.fit.value[i], factor);
        if (term == k_i_term && factor)
            scale_found_limit(cases, documented.integral_limit, 1 + changed.fit.value[i], result);
        if (uncounted) {
            const Control& now = cases[0].joint.control;
            const bool cascade = now.structure == Structure::cascade;
            result.notes.push_back({.code = Note::Code::sample_of_integral,
                                    .names = {cascade ? "control.velocity_gain" : "control.k_p"},
                                    .values = {cascade ? now.velocity_gain : now.k_p, *uncounted}});
            continue;
        }
        result.findings.push_back(finding_of(term, changed.fit, factor, cases[0].joint.control, gain));
    }
    if (changed.dead_zone != documented.dead_zone) {
        for (auto& c : cases) c.joint.control.dead_zone = changed.dead_zone;
        result.findings.push_back({"dead-zone", "dead-zone.width", changed.dead_zone, 0, Quantity::position, gain});
    }
    if (!result.command_explained)
        result.notes.push_back({.code = Note::Code::terms_to, .values = {100 * result.residual_after}});
    return true;
}

}  // namespace stickslip::gap
