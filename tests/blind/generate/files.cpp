#include "tests/blind/generate/files.h"

#include "tests/blind/generate/geared.h"

#include <zlib.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>

namespace blind {
namespace {

std::string text(double x)
{
    char buffer[40];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
    std::string s(buffer, end);
    // TOML tells 1 (whole) from 1.0 (real).
    return s.find_first_of(".en") == std::string::npos ? s + ".0" : s;
}

std::string record_name(std::size_t r)
{
    return "record-" + std::to_string(r + 1) + ".csv.gz";
}

class Toml {
  public:
    void table(const std::string& name) { out_ += (out_.empty() ? "[" : "\n[") + name + "]\n"; }
    void line(const std::string& key, const std::string& value) { out_ += key + " = " + value + "\n"; }
    void word(const std::string& key, const std::string& value) { line(key, '"' + value + '"'); }
    void number(const std::string& key, double value) { line(key, text(value)); }
    void number_if(bool wanted, const std::string& key, double value)
    {
        if (wanted) number(key, value);
    }
    const std::string& str() const { return out_; }

  private:
    std::string out_;
};

void write_friction(Toml& t, const std::string& table, const DryFriction& f)
{
    t.table(table);
    if (f.static_rise > 0) {
        t.word("law", "stribeck");
        t.number("c0", f.coulomb);
        t.number("c1", f.viscous);
        t.number("c2", f.static_rise);
        t.number("c3", f.stribeck_velocity);
        t.number("c4", f.stribeck_exponent);
    } else {
        t.word("law", "coulomb-viscous");
        t.number("coulomb", f.coulomb);
        t.number("viscous", f.viscous);
    }
}

void write_actuator(Toml& t, const Drive& d)
{
    if (d.kind == Drive::Kind::effort && d.gain == 1) return;
    t.table("actuator");
    if (d.kind == Drive::Kind::effort) {
        t.number("effort_gain", d.gain);
        return;
    }
    t.word("kind", "dc-motor");
    t.number("k_t", d.torque_constant);
    t.number("k_e", d.back_emf);
    t.number("resistance", d.resistance);
    t.number("supply_voltage", d.supply);
    t.number_if(d.gain != 1, "effort_gain", d.gain);
    t.word("signal", d.kind == Drive::Kind::dc_duty ? "duty" : "voltage");
}

void write_mechanism(Toml& t, const Machine& machine)
{
    const auto& m = machine.mechanism;
    t.table("joint");
    t.word("motion", machine.revolute ? "revolute" : "prismatic");
    t.word("model", m.bodies == 2 ? "two-mass" : "single-mass");
    if (m.bodies == 2) {
        t.number("motor_inertia", m.inertia[0]);
        t.number("link_inertia", m.inertia[1]);
        t.line("transmission", "{ stiffness = " + text(m.stiffness) + ", damping = " + text(m.damping) +
                                   ", ratio = " + text(machine.reduction) + " }");
    } else {
        t.number("inertia", m.inertia[0]);
    }
    t.table("load");
    t.number("constant", m.constant_load);
    t.number("gravity_amplitude", m.gravity);
}

void write_control(Toml& t, const Controller& c)
{
    t.table("control");
    t.word("kind", "position");
    t.word("feedback", "motor");
    if (c.cascade) {
        t.word("structure", "cascade");
        t.number("position_gain", c.position_gain);
        t.number("velocity_gain", c.velocity_gain);
        t.number("velocity_integral_gain", c.velocity_integral);
    } else {
        t.number("k_p", c.k_p);
        t.number("k_v", c.k_v);
        t.number_if(c.k_i != 0, "k_i", c.k_i);
    }
    t.number("period", c.period);
    t.line("reference_velocity", c.reference_velocity ? "true" : "false");
    t.number_if(std::isfinite(c.limit), "effort_limit", c.limit);
    t.line("velocity_estimate", "{ form = \"backward-difference\", tau = " + text(c.filter) +
                                    ", average = " + std::to_string(c.average) + " }");
}

void write_frictions(Toml& t, const Mechanism& m)
{
    if (m.bodies == 2) {
        write_friction(t, "friction.motor", m.friction[0]);
        write_friction(t, "friction.link", m.friction[1]);
    } else {
        write_friction(t, "friction", m.friction[0]);
    }
}

void write_sensor(Toml& t, const Sensors& s, bool noise_stated)
{
    if (!noise_stated && !(s.quantum > 0)) return;
    t.table("sensor");
    t.number_if(s.quantum > 0, "encoder_quantum", s.quantum);
    t.number_if(noise_stated, "position_noise", s.position_noise);
    t.number_if(noise_stated, "effort_noise", s.effort_noise);
}

/// What differs from record to record, and the unit of their time.
void write_records(Toml& t, const Setting& setting, const Controller& c)
{
    for (std::size_t r = 0; r < setting.machines.size(); ++r) {
        const auto own = at_motor(setting.machines[r]).controller;
        if (own.k_p == c.k_p && own.k_v == c.k_v) continue;
        t.table("record.files.\"" + record_name(r) + '"');
        t.number("control.k_p", own.k_p);
        t.number("control.k_v", own.k_v);
    }
    if (setting.dirt && setting.dirt->milliseconds) {
        t.table("record.columns");
        t.line("time", "{ unit = \"ms\" }");
    }
}

}  // namespace

std::string joint_toml(const Setting& setting)
{
    Nominal n = setting.nominal;
    n.machine = at_motor(n.machine);
    Toml t;
    write_mechanism(t, n.machine);
    write_control(t, n.machine.controller);
    write_frictions(t, n.machine.mechanism);
    write_actuator(t, n.machine.drive);
    write_sensor(t, n.machine.sensors, setting.noise_stated);
    write_records(t, setting, n.machine.controller);
    return t.str();
}

std::string record_csv(const Record& r, const Machine& machine, const Columns& columns)
{
    const auto& d = machine.drive;
    const bool motor = d.kind != Drive::Kind::effort;
    std::vector<std::pair<std::string, const std::vector<double>*>> list = {{"time", &r.time}};
    if (columns.reference_position) list.push_back({"reference_position", &r.reference_position});
    if (columns.reference_velocity) list.push_back({"reference_velocity", &r.reference_velocity});
    list.push_back({"position", &r.position});
    if (columns.velocity) list.push_back({"velocity", &r.velocity});
    const std::string drive = d.kind == Drive::Kind::dc_duty ? "duty"
                              : motor || d.gain != 1         ? "drive_voltage"
                                                             : "effort_command";
    if (columns.command) list.push_back({drive, &r.command});
    if (columns.effort)
        list.push_back(motor ? std::pair{"current", &r.current} : std::pair{"effort_measured", &r.effort});
    if (columns.supply && motor) list.push_back({"supply_voltage", &r.supply});
    std::string out;
    for (std::size_t i = 0; i < list.size(); ++i) out += (i ? "," : "") + list[i].first;
    out += '\n';
    char buffer[40];
    for (std::size_t k = 0; k < r.size(); ++k) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (i) out += ',';
            out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, (*list[i].second)[k],
                                             std::chars_format::general, 10)
                                   .ptr);
        }
        out += '\n';
    }
    return out;
}

void write_case(const SealedCase& c, const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "joint.toml") << joint_toml(c.setting);
    for (std::size_t r = 0; r < c.records.size(); ++r) {
        const auto& machine = c.setting.nominal.machine;
        Record log = at_motor(c.records[r], machine);
        if (c.setting.dirt) log = weathered(std::move(log), *c.setting.dirt, r, machine.controller.period);
        const std::string csv = record_csv(log, machine, c.setting.columns);
        const auto path = folder / (record_name(r));
        gzFile file = gzopen(path.c_str(), "wb6");
        const bool written =
            file && gzwrite(file, csv.data(), static_cast<unsigned>(csv.size())) == static_cast<int>(csv.size());
        if (!file || gzclose(file) != Z_OK || !written) throw std::runtime_error("cannot write " + path.string());
    }
}

std::string truth_json(const std::map<std::string, SealedCase>& cases, const std::string& engine,
                       const std::string& earlier)
{
    auto all = earlier.empty() ? nlohmann::ordered_json::object() : nlohmann::ordered_json::parse(earlier);
    for (const auto& [name, c] : cases) {
        nlohmann::ordered_json j;
        j["verdict"] = c.verdict;
        j["effects"] = c.effects;
        j["equivalent"] = c.equivalent;
        if (!c.outside.empty()) {
            j["outside"] = c.outside;
            j["explained_by_catalogue"] = c.explained_by_catalogue;
        }
        j["kind"] = c.kind;
        j["strength"] = c.strength;
        j["engine"] = engine;
        j["joint"] = c.setting.nominal.family;
        j["columns"] = c.setting.columns.name;
        j["noise_stated"] = c.setting.noise_stated;
        j["seed"] = std::to_string(c.seed);
        auto& variants = j["variants"] = nlohmann::ordered_json::array();
        for (const auto& e : c.edits) variants.push_back(e.variant);
        auto& parameters = j["parameters"] = nlohmann::ordered_json::object();
        const auto& machine = c.setting.nominal.machine;
        const auto told = [&](auto& list, const Parameter& p) {
            const double factor = motor_factor(p.path, machine);
            list[p.path] = {{"nominal", factor * p.nominal}, {"value", factor * p.value}};
        };
        for (const auto& p : c.parameters) told(parameters, p);
        j["dirty"] = c.setting.dirt.has_value();
        if (machine.reduction != 1) j["ratio"] = machine.reduction;
        if (c.setting.dirt) {
            j["forms"] = c.forms;
            auto& off = j["corrections"] = nlohmann::ordered_json::object();
            for (const auto& p : corrections(c.setting.nominal, *c.setting.dirt)) told(off, p);
            j["gap_of_dirt"] = c.gap_of_dirt;
        }
        auto& records = j["records"] = nlohmann::ordered_json::array();
        for (std::size_t r = 0; r < c.records.size(); ++r)
            records.push_back({{"file", record_name(r)},
                               {"excitation", c.setting.excitations[r].kind},
                               {"before", c.gap.before_by_record[r]}});
        if (!c.gap_without.empty()) j["gap_without"] = c.gap_without;
        auto& gap = j["true_gap"];
        gap = {{"before", c.gap.before}, {"after", c.gap.after}, {"floor", 1.0}};
        for (const auto& s : c.gap.signals) {
            const double to_motor = motor_factor("signal." + s.name, machine);
            gap["signals"][s.name] = {{"unit", s.unit},
                                      {"before", to_motor * s.before},
                                      {"after", to_motor * s.after},
                                      {"floor", to_motor * s.floor}};
        }
        all[name] = j;
    }
    return all.dump(1) + "\n";
}

}  // namespace blind
