#include "tests/blind/generate/cases.h"

#include "tests/blind/generate/mujoco.h"
#include "tests/blind/generate/outside.h"
#include "tests/blind/generate/random.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace blind {
namespace {

constexpr int ensemble_size = 4, most_tries = 60, most_searches = 7;
constexpr double smallest_gap = 2, largest_gap = 40;  // floors
constexpr double smallest_share_of_pair = 1.7;        // floors that remain when one of two effects is left out

/// Raised when a draw came out unusable (no gap to see, unstable loop); the next try draws again.
struct Unusable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Columns draw_columns(const std::string& kind, const std::string& wanted, Draw& draw)
{
    static const std::vector<Columns> sets = {
        {"full"},
        {.name = "no-effort", .effort = false},
        {.name = "no-velocity", .reference_velocity = false, .velocity = false},
        {.name = "no-reference", .reference_position = false, .reference_velocity = false},
        {.name = "no-command", .command = false},
        {.name = "motion-only", .reference_velocity = false, .velocity = false, .command = false, .effort = false},
        {.name = "position-only",
         .reference_position = false,
         .reference_velocity = false,
         .velocity = false,
         .command = false,
         .effort = false},
    };
    const auto named = [&](const std::string& name) {
        for (const auto& set : sets)
            if (set.name == name) return set;
        throw std::invalid_argument("no set of columns is called " + name);
    };
    if (!wanted.empty()) return named(wanted);
    if (kind == "few")
        return named(draw.pick<std::string>({"motion-only", "motion-only", "position-only", "no-reference"}));
    const double x = draw.uniform(0, 1);
    return named(x < 0.55   ? "full"
                 : x < 0.75 ? "no-effort"
                 : x < 0.85 ? "no-velocity"
                 : x < 0.92 ? "no-reference"
                            : "no-command");
}

/// Two to four motions of different kinds, at least one slow and one quick.
std::vector<Excitation> draw_excitations(const Nominal& nominal, Draw& draw)
{
    std::vector<std::string> slow, quick, chosen;
    for (const auto& kind : excitation_kinds()) (is_slow(kind) ? slow : quick).push_back(kind);
    draw.shuffle(slow);
    draw.shuffle(quick);
    const int count = draw.pick({2, 3, 3, 3, 4});
    chosen = {slow[0], quick[0]};
    if (count > 2) chosen.push_back(quick[1]);
    if (count > 3) chosen.push_back(draw.pick({slow[1], quick[2]}));
    draw.shuffle(chosen);
    std::vector<Excitation> list;
    for (const auto& kind : chosen) list.push_back(draw_excitation(kind, nominal.travel, nominal.speed, draw));
    return list;
}

std::vector<Edit> in_order(std::vector<Edit> edits)
{
    // An effect that splits the body in two takes over what the others have made of it.
    std::stable_partition(edits.begin(), edits.end(),
                          [](const Edit& e) { return e.name != "compliance" && e.name != "backlash"; });
    return edits;
}

class Maker {
  public:
    Maker(SealedCase& c, std::uint64_t seed)
        : c_(c), draw_(seed), noise_seed_(seed_of(seed, 1)), phase_seed_(seed_of(seed, 2))
    {
    }

    void make(const Wish& wish, const std::vector<std::string>& effects)
    {
        prepare(wish, effects);
        if (c_.kind == "outside") {
            use_outside(wish);
        } else {
            for (const auto& name : effects) c_.edits.push_back(draw_effect(name, c_.nominal, peak_command_, draw_));
            c_.edits = in_order(c_.edits);
            size_effects();
        }
        finish(wish);
    }

  private:
    void prepare(const Wish& wish, const std::vector<std::string>& effects)
    {
        std::vector<std::string> families = joint_families();
        for (const auto& name : effects) {
            const auto able = families_for(name);
            std::erase_if(families,
                          [&](const auto& f) { return std::find(able.begin(), able.end(), f) == able.end(); });
        }
        if (!wish.family.empty()) std::erase_if(families, [&](const auto& f) { return f != wish.family; });
        if (families.empty()) throw Unusable("no family of joints shows these effects");
        c_.nominal = draw_nominal(families[draw_.below(static_cast<int>(families.size()))], draw_);
        auto& sensors = c_.nominal.machine.sensors;
        if (c_.kind == "noisy") {
            sensors.position_noise *= 6;
            sensors.effort_noise *= 6;
        }
        c_.columns = draw_columns(c_.kind, wish.columns, draw_);
        c_.columns.supply = c_.nominal.machine.drive.kind == Drive::Kind::dc_duty && draw_.chance(0.5);
        c_.noise_stated = draw_.chance(0.6);
        c_.stride = c_.nominal.machine.controller.period < 1.5e-3 && draw_.chance(0.15) ? 2 : 1;
        c_.excitations = draw_excitations(c_.nominal, draw_);
        signals_ = compared_signals(c_.nominal.machine, c_.columns);
        c_.machines.assign(c_.excitations.size(), c_.nominal.machine);
        nominal_ = simulate_often(c_.machines, c_.excitations, ensemble_size, seed_of(noise_seed_, 1), c_.stride);
        for (const auto& runs : nominal_)
            for (double u : runs[0].command) peak_command_ = std::max(peak_command_, std::abs(u));
    }

    std::vector<Machine> machines_with(const std::vector<double>& sizes, int left_out = -1)
    {
        std::vector<Machine> machines(c_.excitations.size(), c_.nominal.machine);
        c_.parameters.clear();
        Draw phases(phase_seed_);
        for (auto& machine : machines) {
            for (int i = 0; i < static_cast<int>(c_.edits.size()); ++i) {
                if (i == left_out) continue;
                auto list = c_.edits[i].apply(machine, sizes[i]);
                if (&machine == &machines[0]) c_.parameters.insert(c_.parameters.end(), list.begin(), list.end());
                if (c_.edits[i].phase_free) machine.mechanism.disturbance.phase = phases.phase();
            }
        }
        return machines;
    }

    std::vector<Record> record(const std::vector<Machine>& machines) const
    {
        std::vector<Record> records;
        for (std::size_t r = 0; r < machines.size(); ++r)
            records.push_back(run_loop(machines[r], c_.excitations[r], seed_of(noise_seed_, 1000 + r), c_.stride));
        return records;
    }
    double gap_of(const std::vector<Machine>& machines) const
    {
        return closed_loop_gap(record(machines), nominal_, {}, signals_).before;
    }

    /// The size between its bounds at which the gap is `wanted` floors. Gaps grow about linearly with sizes.
    double search(double smallest, double largest, double wanted, const std::function<std::vector<Machine>(double)>& at)
    {
        double size = std::sqrt(smallest * largest), gap = 0;
        for (int i = 0; i < most_searches; ++i) {
            try {
                gap = gap_of(at(size));
            } catch (const std::runtime_error&) {
                largest = size;
                size *= 0.5;
                if (size < smallest) throw Unusable("unstable at every size");
                continue;
            }
            if (std::abs(std::log(gap / wanted)) < 0.15) return size;
            const double factor = std::sqrt((wanted * wanted - 1) / std::max(gap * gap - 1, 1e-3));
            const double next = std::clamp(size * std::clamp(factor, 0.1, 10.0), smallest, largest);
            if (next == size) break;
            size = next;
        }
        gap = gap_of(at(size));
        if (gap < smallest_gap || gap > largest_gap) throw Unusable("no size of the effect gives the wanted gap");
        return size;
    }

    void size_effects()
    {
        std::vector<double> sizes(c_.edits.size());
        const auto all = c_.edits;
        for (std::size_t i = 0; i < all.size(); ++i) {
            c_.edits = {all[i]};
            const double wanted = all.size() > 1 ? draw_.log_uniform(3, 12) : c_.wanted;
            sizes[i] = search(all[i].smallest, all[i].largest, wanted, [&](double s) { return machines_with({s}); });
        }
        c_.edits = all;
        if (all.size() > 1)
            for (int i = 0; i < static_cast<int>(all.size()); ++i) {
                const auto rest =
                    simulate_often(machines_with(sizes, i), c_.excitations, 1, seed_of(noise_seed_, 5), c_.stride);
                const Gap gap = closed_loop_gap(record(machines_with(sizes)), nominal_, rest, signals_);
                c_.gap_without.push_back(gap.after);
                if (gap.after < smallest_share_of_pair) throw Unusable("one of two effects does not matter");
            }
        c_.machines = machines_with(sizes);
    }

    void use_outside(const Wish& wish);
    void finish(const Wish& wish)
    {
        std::vector<std::uint64_t> seeds;
        for (std::size_t r = 0; r < c_.machines.size(); ++r) seeds.push_back(seed_of(noise_seed_, 1000 + r));
        c_.records = wish.mujoco.empty() ? record(c_.machines)
                                         : run_mujoco(wish.mujoco, c_.machines, c_.excitations, seeds, c_.stride);
        const Ensemble truth =
            simulate_often(c_.machines, c_.excitations, ensemble_size, seed_of(noise_seed_, 3), c_.stride);
        c_.gap = closed_loop_gap(c_.records, nominal_, truth, signals_);
        for (const auto& e : c_.edits) {
            c_.effects.push_back(e.name);
            c_.equivalent.insert(c_.equivalent.end(), e.equivalent.begin(), e.equivalent.end());
        }
        if (c_.effects.empty() && c_.outside.empty()) return;
        if (c_.gap.before < smallest_gap) throw Unusable("the gap vanished");
        // Bounds on the size may have kept the gap from the strength that was aimed at.
        for (const auto& [name, range] : strengths)
            if (c_.gap.before > range.first) c_.strength = name;
    }

    SealedCase& c_;
    Draw draw_;
    std::uint64_t noise_seed_, phase_seed_;
    std::vector<Signal> signals_;
    Ensemble nominal_;
    double peak_command_ = 0;
};

void Maker::use_outside(const Wish& wish)
{
    auto kinds = outside_kinds();
    if (!wish.mujoco.empty()) std::erase_if(kinds, [](const auto& k) { return !mujoco_has(k.first); });
    const auto& [name, kind] = kinds[draw_.below(static_cast<int>(kinds.size()))];
    c_.outside = name;
    Outside o{.kind = kind, .seed = draw_.seed()};
    const double travel = c_.nominal.travel, force = c_.nominal.coulomb();
    double unit = force;
    using Kind = Outside::Kind;
    switch (kind) {
        case Kind::quadratic_drag:
            unit = force / (c_.nominal.speed * c_.nominal.speed);
            break;
        case Kind::softening_ends:
        case Kind::hardening_ends:
            o.where = travel * draw_.uniform(0.35, 0.6);
            o.width = travel * 0.2;
            break;
        case Kind::cubic_spring:
            o.where = travel * 0.7;
            break;
        case Kind::hysteretic_load:
            o.where = travel;
            o.width = travel * draw_.uniform(0.08, 0.2);
            break;
        case Kind::bumps:
            o.width = draw_.uniform(0.8, 2.5);
            break;
        case Kind::random_force:
            o.width = draw_.log_uniform(0.02, 0.15);
            break;
        case Kind::changing_inertia:
            o.where = draw_.uniform(3, 7);
            o.width = draw_.uniform(0.1, 0.5);
            unit = 1;
            break;
        case Kind::local_obstacle:
            o.where = travel * draw_.uniform(-0.4, 0.4);
            o.width = travel * draw_.uniform(0.04, 0.12);
            break;
        case Kind::none:
            break;
    }
    Draw seeds(draw_.seed());
    std::vector<std::uint64_t> seed_of_record;
    for (std::size_t r = 0; r < c_.excitations.size(); ++r) seed_of_record.push_back(seeds.seed());
    const auto at = [&](double size) {
        auto machines = std::vector<Machine>(c_.excitations.size(), c_.nominal.machine);
        for (std::size_t r = 0; r < machines.size(); ++r) {
            machines[r].mechanism.outside = o;
            machines[r].mechanism.outside.size = size * unit;
            machines[r].mechanism.outside.seed = seed_of_record[r];
        }
        return machines;
    };
    const double size = search(0.05, 20, c_.wanted, at);
    c_.machines = at(size);
    c_.parameters = {{"outside.size", 0, size * unit}, {"outside.where", 0, o.where}, {"outside.width", 0, o.width}};
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
    const int count = static_cast<int>(names.size());
    Draw(seed_of(seed, 1u << 20 | index / count)).shuffle(names);
    std::string first = wish.effect.empty() ? names[index % count] : wish.effect;
    if (kind != "pair") return {first};
    for (;;) {
        const std::string second = names[draw.below(count)];
        if (may_pair(first, second)) return {first, second};
    }
}

}  // namespace

std::vector<Signal> compared_signals(const Machine& machine, const Columns& columns)
{
    const std::string force = machine.revolute ? "N·m" : "N";
    std::vector<Signal> list = {{"position", machine.revolute ? "rad" : "m", &Record::position}};
    const bool motor = machine.drive.kind != Drive::Kind::effort;
    if (columns.command)
        list.push_back({motor || machine.drive.gain != 1 ? "drive" : "effort_command",
                        motor || machine.drive.gain != 1 ? "" : force, &Record::command});
    if (columns.effort && motor) list.push_back({"current", "A", &Record::current});
    if (columns.effort && !motor) list.push_back({"effort_measured", force, &Record::effort});
    return list;
}

SealedCase make_case(const Wish& wish, std::uint64_t seed, int index)
{
    const std::uint64_t own_seed = seed_of(seed, index);
    std::string last;
    for (int attempt = 0; attempt < most_tries; ++attempt) {
        Draw draw(own_seed);
        SealedCase c;
        c.seed = own_seed;
        c.kind = kind_of(wish, draw);
        const bool strong_only = c.kind == "noisy" || c.kind == "outside" || c.kind == "few";
        c.strength = !wish.strength.empty() ? wish.strength
                     : c.kind == "none"     ? "none"
                     : strong_only          ? "strong"
                                            : draw.pick<std::string>({"weak", "medium", "strong"});
        if (c.kind != "none") {
            for (const auto& [name, range] : strengths)
                if (name == c.strength) c.wanted = draw.log_uniform(range.first, range.second);
        }
        Draw partner(seed_of(own_seed, 7 + attempt / 8));
        const auto effects = effects_of(c.kind, wish, seed, index, partner);
        try {
            Maker(c, seed_of(own_seed, 1000 + attempt)).make(wish, effects);
        } catch (const std::runtime_error& e) {
            last = e.what();
            continue;
        }
        c.verdict = c.kind == "none" ? "no-gap" : c.kind == "outside" ? "unknown" : "gap";
        if (c.columns.name == "position-only") c.verdict = "insufficient-data";
        return c;
    }
    throw std::runtime_error("case " + std::to_string(index) + ": no draw was usable; the last said: " + last);
}

}  // namespace blind
