#include "analysis/gap/outcomes/explain.h"

#include "analysis/gap/outcomes/side.h"
#include "analysis/joint/parameters.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

namespace stickslip::gap {
namespace {

constexpr std::size_t fewest_rows = 8, fewest_of_either = 3;
constexpr double margin = 3;             // log-likelihood: odds of twenty to one
constexpr double most_misjudged = 0.12;  // of the rows, beyond those that contradict each other
constexpr double most_contradicting = 0.15;

double middle(std::vector<double> values)
{
    double sum = 0;
    for (double v : values) sum += std::log(v);
    return std::exp(sum / static_cast<double>(values.size()));
}

void refuse_unfit(const Joint& joint, const OutcomeTable& table)
{
    if (joint.mechanism.model != Model::single_mass)
        throw std::invalid_argument(
            table.name + ": a table of outcomes is read against a single-mass joint (Fig. 7); reduce this joint first");
    if (joint.control.contact_stiffness != 0 || joint.control.force_gain != 0)
        throw std::invalid_argument(
            table.name +
            ": a table of outcomes is read against one spring; add contact_stiffness to k_p and leave force_gain 0");
}

/// The joint with the settings of a row; a commanded force rate becomes the velocity that it means.
Joint joint_at(const Joint& nominal, const OutcomeTable& table, const std::vector<double>& settings)
{
    Joint joint = nominal;
    bool by_force = false;
    for (std::size_t k = 0; k < table.paths.size(); ++k) {
        double* setting = find_parameter(joint, table.paths[k]);
        if (!setting) throw std::invalid_argument(table.name + ": the joint has no number " + table.paths[k]);
        *setting = settings[k];
        by_force = by_force || table.paths[k] == "control.force_rate";
    }
    auto& c = joint.control;
    if (by_force || (is_set(c.force_rate) && !is_set(c.V0))) c.V0 = c.force_rate / c.k_p;
    c.force_rate = not_set;
    return joint;
}

Outcomes prepared(const Joint& nominal, const OutcomeTable& table)
{
    Outcomes o{table, {}, {}};
    std::vector<double> stiffness, velocity, inertia;
    for (const auto& row : table.rows) {
        Joint joint = joint_at(nominal, table, row.settings);
        const std::string place = table.name + ":" + std::to_string(row.line) + ":1: ";
        if (!(joint.control.V0 > 0))
            throw std::invalid_argument(place + "V0 is not set or not above 0, neither in the row nor in the joint");
        if (!(joint.control.k_p > 0)) throw std::invalid_argument(place + "k_p is not above 0");
        stiffness.push_back(joint.control.k_p), velocity.push_back(joint.control.V0);
        inertia.push_back(joint.mechanism.inertia);
        o.joints.push_back(std::move(joint));
    }
    o.scales.stiffness = middle(stiffness), o.scales.velocity = middle(velocity), o.scales.inertia = middle(inertia);
    const double level = std::abs(steady_force(nominal.friction, o.scales.velocity));
    // a level keeps the friction positive and cancels in the boundary
    o.scales.level = std::isfinite(level) && level > 0 ? level : 100 * o.scales.damping() * o.scales.velocity;
    return o;
}

bool same_settings(const OutcomeRow& a, const OutcomeRow& b)
{
    for (std::size_t k = 0; k < a.settings.size(); ++k)
        if (std::abs(a.settings[k] - b.settings[k]) > 1e-6 * std::max(std::abs(a.settings[k]), std::abs(b.settings[k])))
            return false;
    return true;
}

/// Rows that say the opposite of most rows with the same settings; half of them where they are equally many.
int contradictions(const OutcomeTable& table, std::vector<std::string>& notes)
{
    std::vector<bool> seen(table.rows.size());
    int against = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (seen[i]) continue;
        int yes = 0, no = 0;
        std::string lines;
        for (std::size_t j = i; j < table.rows.size(); ++j)
            if (same_settings(table.rows[i], table.rows[j])) {
                seen[j] = true;
                (table.rows[j].stick_slip ? yes : no) += 1;
                lines += (lines.empty() ? "" : ", ") + std::to_string(table.rows[j].line);
            }
        if (yes > 0 && no > 0) {
            against += std::min(yes, no);
            notes.push_back(table.name + ": lines " + lines + " have the same settings and both outcomes");
        }
    }
    return against;
}

/// 95 % interval of a ratio of sums over rows, the rows drawn anew with a fixed seed.
ConfidenceInterval bootstrap(std::size_t rows, const std::function<double(const std::vector<std::size_t>&)>& statistic)
{
    constexpr int draws = 400;
    std::mt19937 random(1991);
    std::vector<double> values;
    std::vector<std::size_t> drawn(rows);
    for (int d = 0; d < draws; ++d) {
        for (auto& i : drawn) i = random() % rows;
        const double v = statistic(drawn);
        if (std::isfinite(v)) values.push_back(v);
    }
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {values[values.size() / 40], values[values.size() - 1 - values.size() / 40]};
}

double row_cost(const Outcomes& o, const LawFit& f, std::size_t i)
{
    return -std::log(o.table.rows[i].stick_slip ? f.probability[i] : 1 - f.probability[i]);
}
bool row_wrong(const Outcomes& o, const LawFit& f, std::size_t i)
{
    return (f.probability[i] > 0.5) != o.table.rows[i].stick_slip;
}

Cause cause_of(const OutcomeAnswer& a, const LawFit& fit, const LawFit* other_kind)
{
    const auto& o = a.outcomes;
    Cause c;
    c.names = {std::string(fit.rival->effect)};
    c.form = fit.rival->law;
    c.probability = fit.posterior;
    c.tell_tale = fit.rival->tell_tale;
    c.misfit = -fit.total() / static_cast<double>(o.size());
    for (std::size_t k = 0; k < fit.rival->numbers.size(); ++k) {
        const auto& n = fit.rival->numbers[k];
        c.parameters.push_back({c.names[0] + "." + std::string(n.name), fit.values[k], fit.standard_error[k],
                                std::string(unit_of(n.quantity, a.diagnosis.motion))});
        constexpr double at_bound = 0.02;
        const double share = (fit.x[k] - n.low) / (n.high - n.low);
        if (share < at_bound || share > 1 - at_bound) c.plausible = false;
    }
    const auto gain = [&](const std::vector<std::size_t>& rows) {
        double mine = 0, nominal = 0;
        for (std::size_t i : rows) mine += row_cost(o, fit, i), nominal += row_cost(o, a.nominal, i);
        return 1 - mine / nominal;
    };
    std::vector<std::size_t> all(o.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    c.heldout_gain = gain(all);
    c.heldout_gain_interval = bootstrap(o.size(), gain);
    c.signature = other_kind && fit.total() > other_kind->total() + margin;
    return c;
}

void locate(OutcomeAnswer& a)
{
    const auto& o = a.outcomes;
    const auto n = static_cast<double>(o.size());
    Diagnosis& d = a.diagnosis;
    const double floor = std::max(wrong_rows, a.contradictions / n);
    double outcome_cost = -a.nominal.held_out, amplitude_cost = -a.nominal.amplitude_held_out;
    const double both = outcome_cost + amplitude_cost;
    d.signals.push_back({"outcome", outcome_cost / both, {}, a.nominal.misjudged / n, floor, "share of rows"});
    const auto squares = [&](const LawFit& f) {
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < o.size(); ++i)
            if (f.amplitude[i] > 0) {
                const double e = std::log(f.amplitude[i] / o.table.rows[i].amplitude);
                sum += e * e, count += 1;
            }
        return count > 0 ? std::sqrt(sum / count) : not_set;
    };
    const double amplitude_before = squares(a.nominal);
    if (amplitude_cost > 0)
        d.signals.push_back({"amplitude", amplitude_cost / both, {}, amplitude_before, 0.15, "of its logarithm"});
    for (std::size_t k = 0; k < o.table.paths.size(); ++k) {
        std::set<double> values;
        for (const auto& row : o.table.rows) values.insert(row.settings[k]);
        if (values.size() < 3) continue;
        const std::vector<double> sorted(values.begin(), values.end());
        const double low = sorted[sorted.size() / 3], high = sorted[2 * sorted.size() / 3];
        const std::string key = o.table.paths[k].substr(o.table.paths[k].rfind('.') + 1);
        const auto part_of = [&](double v) { return v < low ? 0 : v < high ? 1 : 2; };
        const char* names[] = {"low ", "middle ", "high "};
        for (int part = 0; part < 3; ++part) {
            const auto share = [&](const std::vector<std::size_t>& rows) {
                double here = 0, all = 0;
                for (std::size_t i : rows) {
                    const double c = row_cost(o, a.nominal, i);
                    all += c;
                    if (part_of(o.table.rows[i].settings[k]) == part) here += c;
                }
                return here / all;
            };
            std::vector<std::size_t> all(o.size());
            double wrong = 0, count = 0;
            for (std::size_t i = 0; i < all.size(); ++i) {
                all[i] = i;
                if (part_of(o.table.rows[i].settings[k]) != part) continue;
                wrong += row_wrong(o, a.nominal, i), count += 1;
            }
            d.regimes.push_back({names[part] + key, share(all), bootstrap(o.size(), share),
                                 count > 0 ? wrong / count : 0, floor, "share of its rows"});
        }
    }
    const LawFit& winner = d.verdict == Verdict::gap ? a.laws.front() : a.nominal;
    const auto explained = [&](double before, double after, double least) {
        const double whole = before * before - least * least;
        return whole > 0 ? (before * before - after * after) / whole : 0.0;
    };
    const double before = a.nominal.misjudged / n, after = winner.misjudged / n;
    d.gap.push_back({"outcome", "share of rows", before, after, floor, explained(before, after, floor)});
    if (std::isfinite(amplitude_before)) {
        const double left = squares(winner);
        d.gap.push_back({"amplitude", "RMS of its logarithm", amplitude_before, left, 0.15,
                         explained(amplitude_before, left, 0.15)});
    }
    d.overall = {before / floor, after / floor, 1, explained(before, after, floor), {}};
    d.overall.interval = bootstrap(o.size(), [&](const std::vector<std::size_t>& rows) {
        double b = 0, w = 0;
        for (std::size_t i : rows) b += row_wrong(o, a.nominal, i), w += row_wrong(o, winner, i);
        return explained(b / n, w / n, floor);
    });
    d.remainder = before > 0 ? std::min(1.0, after / before) : 0;
}

/// The place within three times the range of the rows where two explanations differ most.
NextOutcome next_of(const OutcomeAnswer& a, const LawFit& one, const LawFit& two)
{
    const auto& o = a.outcomes;
    constexpr int steps = 9;
    constexpr double beyond = 3;
    const std::size_t n = o.table.paths.size();
    std::vector<double> low(n, infinity), high(n, -infinity);
    for (const auto& row : o.table.rows)
        for (std::size_t k = 0; k < n; ++k) {
            low[k] = std::min(low[k], row.settings[k]);
            high[k] = std::max(high[k], row.settings[k]);
        }
    NextOutcome next;
    double best = 0.3;  // less is no experiment
    std::size_t places = 1;
    for (std::size_t k = 0; k < n; ++k) places *= low[k] < high[k] ? steps : 1;
    for (std::size_t place = 0; place < places; ++place) {
        std::vector<double> settings;
        std::size_t rest = place;
        for (std::size_t k = 0; k < n; ++k) {
            double value = low[k];
            if (low[k] < high[k]) {
                const double u = static_cast<double>(rest % steps) / (steps - 1);
                rest /= steps;
                value = low[k] > 0 ? low[k] / beyond * std::pow(high[k] / low[k] * beyond * beyond, u)
                                   : low[k] + (high[k] - low[k]) * u;
            }
            settings.push_back(value);
        }
        const Joint joint = joint_at(a.after, o.table, settings);
        const double p = probability_at(distance_to_stick_slip(with_law(joint, one.law)), one.softness);
        const double q = probability_at(distance_to_stick_slip(with_law(joint, two.law)), two.softness);
        if (std::abs(p - q) > best) {
            best = std::abs(p - q);
            next = {settings, p, q};
        }
    }
    return next;
}

void decide(OutcomeAnswer& a)
{
    Diagnosis& d = a.diagnosis;
    const auto& o = a.outcomes;
    const auto n = static_cast<double>(o.size());
    const auto explains = [&](const LawFit& f) { return f.misjudged <= a.contradictions + most_misjudged * n; };
    const LawFit& winner = a.laws.front();
    std::set<std::string_view> effects{winner.rival->effect};
    for (const auto& f : a.laws) {
        if (&f == &winner || f.total() < winner.total() - margin || !explains(f)) continue;
        effects.insert(f.rival->effect);
        d.ambiguous_with.push_back({std::string(f.rival->effect)});
        if (f.rival->effect == winner.rival->effect)
            d.reasons.push_back("the law is ambiguous: these rows cannot tell " + std::string(winner.rival->law) +
                                " from " + std::string(f.rival->law));
    }
    constexpr std::size_t too_many = 3;
    if (a.contradictions > most_contradicting * n) {
        d.verdict = Verdict::insufficient_data;
        d.reasons.push_back(
            std::to_string(a.contradictions) + " of " + std::to_string(o.size()) +
            " rows contradict others with the same settings: what decides the outcome is not in the table");
    } else if (explains(a.nominal) && a.nominal.total() > winner.total() - margin) {
        d.verdict = Verdict::no_gap;
        d.reasons = {"the nominal joint explains the rows as well as any law fitted to them"};
    } else if (!explains(winner)) {
        d.verdict = Verdict::unknown;
        d.reasons = {"the best law, " + std::string(winner.rival->law) + ", misjudges " +
                     std::to_string(winner.misjudged) + " of " + std::to_string(o.size()) +
                     " rows that its fit had not seen"};
    } else if (effects.size() >= too_many) {
        d.verdict = Verdict::insufficient_data;
        d.reasons.push_back(std::to_string(effects.size()) +
                            " kinds of friction explain these rows: they lie on one side of what tells the laws apart");
    } else {
        d.verdict = Verdict::gap;
    }
    if (d.verdict == Verdict::no_gap || d.verdict == Verdict::unknown) d.ambiguous_with.clear();
}

}  // namespace

OutcomeAnswer explain(const Joint& nominal, const OutcomeTable& table, const ParallelFor& parallel,
                      const std::function<void(const std::string&, double)>& progress, std::span<const RivalLaw> rivals)
{
    refuse_unfit(nominal, table);
    OutcomeAnswer a{{}, nominal, prepared(nominal, table), {}, {}, {}, 0};
    Diagnosis& d = a.diagnosis;
    d.motion = nominal.mechanism.motion;
    d.records.push_back({table.name, "held-out"});
    d.usual_speed = a.outcomes.scales.velocity;
    d.notes.push_back("every fifth of the rows is held out in turn and predicted from a fit to the others");
    a.contradictions = contradictions(table, d.notes);
    std::size_t stuck = 0;
    for (const auto& row : table.rows) stuck += row.stick_slip;
    const std::size_t rarer = std::min(stuck, table.rows.size() - stuck);
    if (table.rows.size() < fewest_rows || rarer < fewest_of_either) {
        d.reasons.push_back(table.name + ": " + std::to_string(table.rows.size()) + " rows, " + std::to_string(stuck) +
                            " of them with stick-slip; a boundary needs at least " + std::to_string(fewest_rows) +
                            " rows, " + std::to_string(fewest_of_either) + " on either side");
        return a;
    }
    a.laws.resize(rivals.size());
    if (progress) progress("fitting friction laws", 0.1);
    const auto fit_at = [&](std::size_t i) -> LawFit& { return i == rivals.size() ? a.nominal : a.laws[i]; };
    parallel(rivals.size() + 1, [&](std::size_t i) {
        fit_at(i) = i == rivals.size() ? judge_nominal_law(a.outcomes, nominal) : fit_law(a.outcomes, rivals[i]);
    });
    if (progress) progress("following motions from rest", 0.7);
    double likeliest = -infinity;
    for (const auto& f : a.laws) likeliest = std::max(likeliest, f.held_out);
    parallel(rivals.size() + 1, [&](std::size_t i) {
        constexpr double hopeless = 20;
        LawFit& fit = fit_at(i);
        if (&fit == &a.nominal || fit.held_out > likeliest - hopeless) confirm_by_motion(a.outcomes, fit);
    });
    double amplitudes = 0;
    for (const auto& f : a.laws) amplitudes = std::min(amplitudes, f.amplitude_held_out);
    for (auto& f : a.laws)
        if (!f.followed) f.amplitude_held_out = amplitudes;
    if (progress) progress("ranking", 0.95);
    double best = -infinity, sum = 0;
    for (const auto& f : a.laws) best = std::max(best, f.total());
    // "none of these" guesses the share of stick-slip
    const double share = static_cast<double>(stuck) / static_cast<double>(table.rows.size());
    const double guess =
        static_cast<double>(table.rows.size()) * (share * std::log(share) + (1 - share) * std::log(1 - share));
    sum = std::exp(std::min(0.0, guess - best));
    for (const auto& f : a.laws) sum += std::exp(f.total() - best);
    for (auto& f : a.laws) f.posterior = std::exp(f.total() - best) / sum;
    std::stable_sort(a.laws.begin(), a.laws.end(), [](const auto& x, const auto& y) { return x.total() > y.total(); });
    decide(a);
    const auto best_of = [&](bool memory) {
        const auto found =
            std::find_if(a.laws.begin(), a.laws.end(), [&](const auto& f) { return f.rival->memory == memory; });
        return found == a.laws.end() ? nullptr : &*found;
    };
    for (const auto& f : a.laws) d.effects.push_back(cause_of(a, f, best_of(!f.rival->memory)));
    locate(a);
    const LawFit& winner = a.laws.front();
    if (d.verdict == Verdict::gap) {
        a.after = with_law(nominal, winner.law);
        if (winner.beyond_linear > 0)
            d.notes.push_back(std::to_string(winner.beyond_linear) +
                              " rows lie where small disturbances die out and a start from rest does not, or the "
                              "reverse; the motion from rest counts");
    }
    const auto rival = std::find_if(a.laws.begin() + 1, a.laws.end(),
                                    [&](const auto& f) { return f.rival->effect != winner.rival->effect; });
    if (rival != a.laws.end() && d.verdict != Verdict::no_gap) {
        a.next = next_of(a, winner, *rival);
        if (!a.next.settings.empty())
            d.next_experiment.separates.push_back(
                {std::string(winner.rival->effect), std::string(rival->rival->effect)});
    }
    if (progress) progress("done", 1);
    return a;
}

}  // namespace stickslip::gap
