#include "tests/blind/generate/cases.h"

#include "tests/blind/generate/mimic.h"
#include "tests/blind/generate/mujoco.h"
#include "tests/blind/generate/outside.h"

#include <algorithm>

namespace blind {
namespace {

constexpr int most_tries = 60, tries_with_a_partner = 8, tries_of_a_cause = 15;
constexpr double smallest_share_of_pair = 1.7;  // floors that remain when one of two effects is left out
constexpr double fair_mimicry = 0.9;  // an outside cause that the catalogue explains better is no fair question

std::vector<std::string> families_of(const Wish& wish, const std::vector<std::string>& effects)
{
    std::vector<std::string> families = effects.empty() ? joint_families() : families_for(effects[0]);
    for (const auto& name : effects) {
        const auto able = families_for(name);
        std::erase_if(families, [&](const auto& f) { return std::find(able.begin(), able.end(), f) == able.end(); });
    }
    if (!wish.family.empty()) std::erase_if(families, [&](const auto& f) { return f != wish.family; });
    return families;
}

/// Applies the edits to the machine of every record. What differs from record to record is decided by `seed`.
std::vector<Machine> apply(const std::vector<Edit>& edits, const std::vector<double>& sizes, const Setting& setting,
                           std::uint64_t seed, SealedCase* whole = nullptr)
{
    std::vector<Machine> machines = setting.machines;
    Draw draw(seed);
    for (auto& machine : machines)
        for (std::size_t i = 0; i < edits.size(); ++i) {
            const auto list = edits[i].apply(machine, sizes[i]);
            if (whole && &machine == &machines[0])
                whole->parameters.insert(whole->parameters.end(), list.begin(), list.end());
            if (!edits[i].differs_by_record) continue;
            machine.mechanism.disturbance.phase = draw.phase();
            machine.mechanism.outside.seed = draw.seed();
        }
    return machines;
}

/// The same with all that is not in the document.
std::vector<Machine> apply_and_soil(const std::vector<Edit>& edits, const std::vector<double>& sizes,
                                    const Setting& setting, std::uint64_t seed, SealedCase* whole = nullptr)
{
    auto machines = apply(edits, sizes, setting, seed, whole);
    for (std::size_t r = 0; setting.dirt && r < machines.size(); ++r) {
        const auto forms = soil(machines[r], setting.nominal, *setting.dirt, r);
        if (whole && r == 0) whole->forms = forms;
    }
    return machines;
}

/// Chooses the sizes of the edits and puts them into the machines.
void size_effects(SealedCase& c, Draw& draw)
{
    const std::uint64_t seed = draw.seed();
    std::vector<double> sizes;
    if (c.setting.dirt) c.gap_of_dirt = c.setting.gap_of(apply_and_soil({}, {}, c.setting, seed));
    // a cause that is smaller than what the document is off by would be no fair question
    const double beside = c.gap_of_dirt * draw.log_uniform(1.5, 4);
    for (const auto& edit : c.edits) {
        const double wanted = std::max(beside, c.edits.size() > 1 ? draw.log_uniform(3, 12) : c.wanted);
        sizes.push_back(size_for_gap(
            c.setting, edit.smallest, edit.largest, wanted,
            [&](double size) { return apply({edit}, {size}, c.setting, seed); },
            std::max(largest_gap, 6 * c.gap_of_dirt)));
    }
    c.undisturbed = apply(c.edits, sizes, c.setting, seed);
    c.machines = apply_and_soil(c.edits, sizes, c.setting, seed, &c);
    if (c.edits.size() < 2) return;
    const auto records = c.setting.record(c.machines);
    for (std::size_t out = 0; out < c.edits.size(); ++out) {
        const std::size_t in = 1 - out;
        const double rest = c.setting.gap(records, apply_and_soil({c.edits[in]}, {sizes[in]}, c.setting, seed)).after;
        c.gap_without.push_back(rest);
        if (rest < std::max(smallest_share_of_pair, 0.7 * c.gap_of_dirt))
            throw Unusable("one of two effects does not matter");
    }
}

/// `turn` chooses among the causes outside the catalogue.
void make(SealedCase& c, const Wish& wish, const std::vector<std::string>& effects, int turn, std::uint64_t seed)
{
    Draw draw(seed);
    const bool gain_effect =
        std::any_of(effects.begin(), effects.end(), [](const auto& e) { return e.starts_with("gain-"); });
    c.setting = draw_setting({c.kind, wish.columns, families_of(wish, effects), !gain_effect, wish.dirty,
                              wish.mujoco.empty(), wish.controller},
                             draw, seed_of(seed, 1));
    const auto& s = c.setting;
    for (const auto& name : effects) c.edits.push_back(draw_effect(name, s.nominal, s.peak_command, draw));
    // An effect that splits the body in two takes over what the other has made of it.
    std::stable_partition(c.edits.begin(), c.edits.end(),
                          [](const Edit& e) { return e.name != "compliance" && e.name != "backlash"; });
    if (c.kind == "outside") {
        std::vector<std::string> names;
        for (const auto& [name, kind] : outside_kinds())
            if (wish.mujoco.empty() || mujoco_has(name)) names.push_back(name);
        c.outside = names[static_cast<std::size_t>(turn) % names.size()];
        c.edits.push_back(draw_outside(c.outside, s.nominal, draw));
    }
    size_effects(c, draw);
    if (!c.outside.empty()) {
        c.explained_by_catalogue = explained_by_catalogue(s, c.undisturbed);
        if (c.explained_by_catalogue > fair_mimicry) throw Unusable("the catalogue explains the cause");
    }
    std::vector<std::uint64_t> seeds;
    for (std::size_t r = 0; r < c.machines.size(); ++r) seeds.push_back(s.record_seed(r));
    c.records = wish.mujoco.empty() ? s.record(c.machines)
                                    : run_mujoco(wish.mujoco, c.machines, s.excitations, seeds, s.stride);
    c.gap = s.gap(c.records, c.machines);
    // friction that is uneven by direction makes the very motion of a constant load
    if (c.setting.dirt && c.edits.empty())
        c.equivalent = {"inertia", "coulomb-level", "viscous", "gravity", "constant-load", "asymmetric-friction"};
    if (c.edits.empty()) return;
    if (c.gap.before < smallest_gap) throw Unusable("the gap vanished");
    for (const auto& e : c.edits) {
        if (c.outside.empty()) c.effects.push_back(e.name);
        c.equivalent.insert(c.equivalent.end(), e.equivalent.begin(), e.equivalent.end());
    }
    // Bounds on the size may have kept the gap from the strength that was aimed at.
    for (const auto& [name, range] : strengths)
        if (c.gap.before > range.first) c.strength = name;
}

std::string kind_of(const Wish& wish, Draw& draw)
{
    if (wish.kind != "mixed") return wish.kind;
    const double x = draw.uniform(0, 1);
    return x < 0.45   ? "single"
           : x < 0.65 ? "pair"
           : x < 0.77 ? "none"
           : x < 0.9  ? "outside"
           : x < 0.95 ? "noisy"
                      : "few";
}

std::vector<std::string> effects_of(const std::string& kind, const Wish& wish, std::uint64_t seed, int index,
                                    Draw& draw)
{
    if (kind == "none" || kind == "outside") return {};
    std::vector<std::string> names = effect_names();
    if (!wish.mujoco.empty()) std::erase_if(names, [](const auto& n) { return !mujoco_has(n); });
    std::erase_if(names, [&](const auto& n) { return !controller_has(wish.controller, n); });
    const int count = static_cast<int>(names.size());
    Draw(seed_of(seed, 1u << 20 | index / count)).shuffle(names);
    const std::string first = wish.effect.empty() ? names[index % count] : wish.effect;
    if (kind != "pair") return {first};
    for (;;) {
        const std::string second = names[draw.below(count)];
        if (may_pair(first, second) && !families_of(wish, {first, second}).empty()) return {first, second};
    }
}

}  // namespace

SealedCase make_case(const Wish& wish, std::uint64_t seed, int index)
{
    const std::uint64_t own_seed = seed_of(seed, index);
    std::string last;
    for (int attempt = 0; attempt < most_tries; ++attempt) {
        Draw draw(own_seed), partner(seed_of(own_seed, 7 + attempt / tries_with_a_partner));
        SealedCase c;
        c.seed = own_seed;
        c.kind = kind_of(wish, draw);
        const bool strong_only = c.kind == "noisy" || c.kind == "outside" || c.kind == "few";
        c.strength = c.kind == "none"         ? "none"
                     : !wish.strength.empty() ? wish.strength
                     : strong_only            ? "strong"
                                              : draw.pick<std::string>({"weak", "medium", "strong"});
        for (const auto& [name, range] : strengths)
            if (name == c.strength) c.wanted = draw.log_uniform(range.first, range.second);
        try {
            make(c, wish, effects_of(c.kind, wish, seed, index, partner), index + attempt / tries_of_a_cause,
                 seed_of(own_seed, 1000 + attempt));
        } catch (const std::runtime_error& e) {
            last = e.what();
            continue;
        }
        c.verdict = c.kind == "none" ? "no-gap" : c.kind == "outside" ? "unknown" : "gap";
        if (c.setting.columns.name == "position-only") c.verdict = "insufficient-data";
        return c;
    }
    throw std::runtime_error("no draw was usable; the last said: " + last);
}

}  // namespace blind
