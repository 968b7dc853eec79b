#include "tests/blind/generate/mujoco.h"

#include "tests/blind/generate/outside.h"

#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace blind {
namespace {

using Json = nlohmann::json;

constexpr double longest_step = 5e-5;  // s; MuJoCo's integration is of first order

Json json(const Sine& s)
{
    return {{"amplitude", s.amplitude}, {"rate", s.rate}, {"phase", s.phase}};
}

Json json(const DryFriction& f)
{
    return {{"coulomb", f.coulomb},
            {"viscous", f.viscous},
            {"static_rise", f.static_rise},
            {"stribeck_velocity", f.stribeck_velocity},
            {"stribeck_exponent", f.stribeck_exponent},
            {"uneven_coulomb", f.uneven_coulomb},
            {"uneven_viscous", f.uneven_viscous},
            {"load_share", f.load_share},
            {"ripple", json(f.ripple)},
            {"drift", f.drift},
            {"drift_time", f.drift_time}};
}

Json json(const Mechanism& m)
{
    std::string outside = "none";
    for (const auto& [name, kind] : outside_kinds())
        if (kind == m.outside.kind) outside = name;
    return {{"bodies", m.bodies},
            {"inertia", m.inertia},
            {"stiffness", m.stiffness},
            {"damping", m.damping},
            {"backlash", m.backlash},
            {"friction", {json(m.friction[0]), json(m.friction[1])}},
            {"constant_load", m.constant_load},
            {"gravity", m.gravity},
            {"gravity_phase", m.gravity_phase},
            {"cogging", json(m.cogging)},
            {"disturbance", json(m.disturbance)},
            {"outside",
             {{"kind", outside}, {"size", m.outside.size}, {"where", m.outside.where}, {"width", m.outside.width}}}};
}

Json json(const Machine& m)
{
    const char* kinds[] = {"effort", "dc-voltage", "dc-duty"};
    const auto& d = m.drive;
    const auto& c = m.controller;
    const auto& s = m.sensors;
    return {{"revolute", m.revolute},
            {"mechanism", json(m.mechanism)},
            {"drive",
             {{"kind", kinds[static_cast<int>(d.kind)]},
              {"dead_time", d.dead_time},
              {"lag", d.lag},
              {"gain", d.gain},
              {"limit", d.limit},
              {"torque_constant", d.torque_constant},
              {"back_emf", d.back_emf},
              {"resistance", d.resistance},
              {"supply", d.supply},
              {"supply_resistance", d.supply_resistance},
              {"sag_effort", d.sag_effort}}},
            {"controller",
             {{"period", c.period},
              {"k_p", c.k_p},
              {"k_v", c.k_v},
              {"filter", c.filter},
              {"limit", c.limit},
              {"average", c.average},
              {"reference_velocity", c.reference_velocity},
              {"cascade", c.cascade},
              {"k_i", c.k_i},
              {"position_gain", c.position_gain},
              {"velocity_gain", c.velocity_gain},
              {"velocity_integral", c.velocity_integral},
              {"dead_zone", c.dead_zone},
              {"coulomb", c.coulomb},
              {"coulomb_speed", c.coulomb_speed}}},
            {"sensors",
             {{"quantum", s.quantum},
              {"position_noise", s.position_noise},
              {"effort_noise", s.effort_noise},
              {"offset", s.offset},
              {"scale", s.scale}}}};
}

/// A folder of its own that goes when the job is done.
struct Scratch {
    std::filesystem::path path;
    Scratch() : path(std::filesystem::temp_directory_path() / ("blind-mujoco-" + std::to_string(getpid())))
    {
        std::filesystem::create_directories(path);
    }
    ~Scratch()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

}  // namespace

bool mujoco_has(const std::string& cause)
{
    static const std::vector<std::string> missing = {"presliding", "frictional-memory", "bumps", "random-force",
                                                     "changing-inertia"};
    return std::find(missing.begin(), missing.end(), cause) == missing.end();
}

std::vector<Record> run_mujoco(const std::filesystem::path& folder, const std::vector<Machine>& machines,
                               const std::vector<Excitation>& excitations, const std::vector<std::uint64_t>& seeds,
                               int stride)
{
    const Scratch scratch;
    Json job = {{"longest_step", longest_step}, {"records", Json::array()}};
    std::vector<double> references;
    std::vector<int> samples;
    for (std::size_t r = 0; r < machines.size(); ++r) {
        const double period = machines[r].controller.period;
        const int count = static_cast<int>(std::floor(excitations[r].duration / period)) + 1;
        for (int k = 0; k < count; ++k) references.push_back(excitations[r].at(k * period).position);
        for (int k = 0; k < count; ++k) references.push_back(excitations[r].at(k * period).velocity);
        samples.push_back(count);
        // JavaScript keeps 53 bits of a whole number.
        job["records"].push_back({{"machine", json(machines[r])}, {"samples", count}, {"seed", seeds[r] >> 12}});
    }
    std::ofstream(scratch.path / "job.json") << job;
    std::ofstream(scratch.path / "job.references", std::ios::binary)
        .write(reinterpret_cast<const char*>(references.data()),
               static_cast<std::streamsize>(references.size() * sizeof(double)));
    const std::string command =
        "node \"" + (folder / "simulate.mjs").string() + "\" \"" + (scratch.path / "job.json").string() + "\"";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("MuJoCo did not finish: " + command);

    std::ifstream in(scratch.path / "job.columns", std::ios::binary);
    std::vector<Record> records;
    for (std::size_t r = 0; r < machines.size(); ++r) {
        Record record;
        const auto& c = machines[r].controller;
        for (int k = 0; k < samples[r]; k += stride) {
            const Reference ref = excitations[r].at(k * c.period);
            record.time.push_back(k * c.period);
            record.reference_position.push_back(ref.position);
            record.reference_velocity.push_back(ref.velocity);
        }
        for (auto column : {&Record::position, &Record::velocity, &Record::command, &Record::effort, &Record::current,
                            &Record::supply, &Record::link_position}) {
            std::vector<double> all(static_cast<std::size_t>(samples[r]));
            in.read(reinterpret_cast<char*>(all.data()), static_cast<std::streamsize>(all.size() * sizeof(double)));
            for (std::size_t k = 0; k < all.size(); k += static_cast<std::size_t>(stride))
                (record.*column).push_back(all[k]);
        }
        records.push_back(std::move(record));
    }
    if (!in) throw std::runtime_error("MuJoCo wrote fewer columns than it should");
    return records;
}

}  // namespace blind
