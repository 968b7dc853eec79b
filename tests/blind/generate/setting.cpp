#include "tests/blind/generate/setting.h"

#include <algorithm>
#include <cmath>

namespace blind {
namespace {

constexpr int ensemble_size = 4, most_searches = 7;

Columns draw_columns(const std::string& kind, const std::string& wanted, Draw& draw)
{
    const auto named = [&](const std::string& name) {
        for (const auto& set : column_sets())
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

std::vector<Signal> compared_signals(const Machine& machine, const Columns& columns)
{
    const std::string force = machine.revolute ? "N·m" : "N";
    std::vector<Signal> list = {{"position", machine.revolute ? "rad" : "m", &Record::position}};
    const auto& d = machine.drive;
    const bool motor = d.kind != Drive::Kind::effort;
    if (columns.command) {
        if (d.kind == Drive::Kind::dc_duty)
            list.push_back({"duty", "1", &Record::command});
        else if (motor || d.gain != 1)
            list.push_back({"drive_voltage", "V", &Record::command});
        else
            list.push_back({"effort_command", force, &Record::command});
    }
    if (columns.effort && motor) list.push_back({"current", "A", &Record::current});
    if (columns.effort && !motor) list.push_back({"effort_measured", force, &Record::effort});
    return list;
}

}  // namespace

const std::vector<Columns>& column_sets()
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
    return sets;
}

std::vector<Record> Setting::record(const std::vector<Machine>& with) const
{
    std::vector<Record> records;
    for (std::size_t r = 0; r < with.size(); ++r)
        records.push_back(run_loop(with[r], excitations[r], record_seed(r), stride));
    return records;
}

double Setting::gap_of(const std::vector<Machine>& with) const
{
    return closed_loop_gap(record(with), ensemble, {}, signals).before;
}

Gap Setting::gap(const std::vector<Record>& records, const std::vector<Machine>& truth) const
{
    return closed_loop_gap(records, ensemble,
                           simulate_often(truth, excitations, ensemble_size, seed_of(noise_seed, 3), stride), signals);
}

Setting draw_setting(const SettingWish& wish, Draw& draw, std::uint64_t noise_seed)
{
    if (wish.families.empty()) throw std::invalid_argument("no family of joints shows these effects");
    Setting s;
    s.noise_seed = noise_seed;
    s.nominal = draw_nominal(wish.families[draw.below(static_cast<int>(wish.families.size()))], draw, wish.controller);
    auto& machine = s.nominal.machine;
    if (wish.kind == "noisy") {
        machine.sensors.position_noise *= 6;
        machine.sensors.effort_noise *= 6;
    }
    s.columns = draw_columns(wish.kind, wish.columns, draw);
    s.columns.supply = machine.drive.kind == Drive::Kind::dc_duty && draw.chance(0.5);
    s.noise_stated = draw.chance(wish.dirty ? 0.3 : 0.6);
    s.stride = machine.controller.period < 1.5e-3 && draw.chance(0.15) ? 2 : 1;
    s.excitations = draw_excitations(s.nominal, draw);
    s.machines.assign(s.excitations.size(), machine);
    if (wish.dirty) {
        Draw own(seed_of(noise_seed, 5));  // a clean case of this seed stays what it is
        s.dirt = draw_dirt(s.nominal, s.machines.size(), wish.forms, own);
    }
    if (wish.may_change_gains && draw.chance(0.2) && wish.controller == "pd") {
        auto& other = s.machines.back().controller;
        const double softer = draw.uniform(0.6, 0.85);
        other.k_p *= softer * softer;
        other.k_v *= softer;
    }
    s.signals = compared_signals(machine, s.columns);
    s.ensemble = simulate_often(s.machines, s.excitations, ensemble_size, seed_of(noise_seed, 1), s.stride);
    for (const auto& runs : s.ensemble)
        for (double u : runs[0].command) s.peak_command = std::max(s.peak_command, std::abs(u));
    return s;
}

double size_for_gap(const Setting& setting, double smallest, double largest, double wanted,
                    const std::function<std::vector<Machine>(double)>& at, double most)
{
    double size = std::sqrt(smallest * largest);
    for (int i = 0; i < most_searches; ++i) {
        double gap = 0;
        try {
            gap = setting.gap_of(at(size));
        } catch (const std::runtime_error&) {
            largest = size;
            size *= 0.5;
            if (size < smallest) throw Unusable("unstable at every size");
            continue;
        }
        if (std::abs(std::log(gap / wanted)) < 0.15) return size;
        // Gaps grow about linearly with sizes, on top of the floor.
        const double factor = std::sqrt((wanted * wanted - 1) / std::max(gap * gap - 1, 1e-3));
        const double next = std::clamp(size * std::clamp(factor, 0.1, 10.0), smallest, largest);
        if (next == size) break;
        size = next;
    }
    const double gap = setting.gap_of(at(size));
    if (gap < smallest_gap || gap > most) throw Unusable("no size of the effect gives the wanted gap");
    return size;
}

}  // namespace blind
