#include "sweep/files/toml/requirements_file.h"

#include "analysis/joint/key_collector.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/hand_keys.h"
#include "sweep/files/toml/joint_keys.h"
#include "sweep/files/toml/struct_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr Choice<DesignObjective> objectives[] = {{"motion", DesignObjective::motion},
                                                  {"effort", DesignObjective::effort}};

/// Requirements as they stand in a file.
struct RequirementsTable {
    Requirements r;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        constexpr Range margins{0, 100, false, false}, counts{2, 200, false, false, true};
        auto& r = self.r;
        visit.choice("objective", "noise to be minimised", r.objective, objectives);
        visit.number({"position_noise", Quantity::position, not_negative, Need::optional,
                      "standard deviation of a measured position"},
                     r.noise.position);
        visit.number({"velocity_noise", Quantity::velocity, not_negative, Need::optional,
                      "standard deviation of a velocity sensor; not set: velocity is the difference of positions"},
                     r.noise.velocity);
        visit.number({"sample_time", Quantity::time, positive, Need::optional, "between samples"}, r.noise.period);
        visit.number({"filter", Quantity::time, not_negative, Need::optional, "time constant of the velocity filter"},
                     r.noise.filter);
        visit.number(
            {"average", Quantity::number, whole_positive, Need::optional, "positions averaged before the difference"},
            r.noise.average);
        visit.number({"effort_limit", Quantity::effort, positive, Need::optional, "of the actuator"}, r.effort_limit);
        visit.number({"noise_multiple", Quantity::number, not_negative, Need::optional,
                      "multiple of the effort noise that must fit below the limit"},
                     r.noise_multiple);
        visit.number(
            {"margin", Quantity::number, margins, Need::optional,
             "least distance to a boundary, in logarithms of the uncertain parameters, relative to their shares"},
            r.margin);
        visit.number({"least_velocity", Quantity::velocity, positive, Need::optional,
                      "stable at every velocity from here up to V0"},
                     r.least_velocity);
        visit.number(
            {"stiffness_scale", Quantity::position_gain, positive, Need::optional, "the k_p that doubles the cost"},
            r.stiffness_scale);
        visit.number({"k_p_from", Quantity::position_gain, positive, Need::optional, "least k_p"}, r.k_p_low);
        visit.number({"k_p_to", Quantity::position_gain, positive, Need::optional, "largest k_p"}, r.k_p_high);
        visit.number({"k_v_from", Quantity::velocity_gain, not_negative, Need::optional, "least k_v"}, r.k_v_low);
        visit.number({"k_v_to", Quantity::velocity_gain, positive, Need::optional, "largest k_v"}, r.k_v_high);
        visit.number({"front_points", Quantity::number, counts, Need::optional, "points of the Pareto front"},
                     r.front_points);
    }
};

std::string trimmed(std::string text)
{
    while (!text.empty() && text.back() == ' ') text.pop_back();
    while (!text.empty() && text.front() == ' ') text.erase(0, 1);
    return text;
}

/// "0.2" or "20 %" as a share.
double share_from(std::string text, const std::string& what)
{
    text = trimmed(text);
    const bool percent = text.ends_with("%");
    if (percent) text.pop_back();
    char* rest = nullptr;
    const double value = std::strtod(text.c_str(), &rest) / (percent ? 100 : 1);
    if (rest == text.c_str() || !trimmed(rest).empty() || !(value > 0 && value < 1))
        throw BadInput(fmt::format("{}: got {}{}, expected a share between 0 and 1 or 0 % and 100 %", what, text,
                                   percent ? "%" : ""));
    return value;
}

Coordinate coordinate_from(const Joint& joint, const std::string& text)
{
    const auto minus = text.find(" - ");
    Coordinate c{trimmed(text.substr(0, minus)), minus == std::string::npos ? "" : trimmed(text.substr(minus + 3))};
    for (const auto& path : {c.path, c.less})
        if (!path.empty() && !find_parameter(joint, path))
            throw BadInput(fmt::format("{}: is not a parameter of this joint{}", path,
                                       files::did_you_mean(path, files::numeric_paths(joint))));
    if (std::isnan(value_of(joint, c)))
        throw BadInput(fmt::format("{}: is {} in this joint, so a share of it means nothing", text,
                                   c.less.empty() ? "0" : "not positive"));
    return c;
}

}  // namespace

Uncertainty uncertainty_from(const Joint& joint, const std::vector<std::string>& texts)
{
    Uncertainty u;
    for (const auto& text : texts) {
        const auto equals = text.find('=');
        if (equals == std::string::npos)
            throw BadInput("--uncertain " + text + ": expected PATH=SHARE such as friction.L=20%");
        auto c = coordinate_from(joint, text.substr(0, equals));
        for (const auto& other : u.coordinates)
            if (other.path == c.path && other.less == c.less)
                throw BadInput("--uncertain: got " + trimmed(text.substr(0, equals)) +
                               " twice, expected different parameters");
        u.coordinates.push_back(std::move(c));
        u.share.push_back(share_from(text.substr(equals + 1), "--uncertain " + text));
    }
    return u;
}

std::vector<Key> requirement_keys()
{
    return keys_of(RequirementsTable{}, "requirements");
}

Requirements read_requirements(const std::filesystem::path& file, const Joint& joint,
                               const std::vector<std::string>& changes)
{
    RequirementsTable table;
    auto& r = table.r;
    r = requirements_of(joint);
    const auto explain = [](const std::string& path, const std::vector<std::string>& siblings) {
        return "unknown key, expected " + files::listed(siblings) +
               files::did_you_mean(path.substr(path.rfind('.') + 1), siblings);
    };
    const toml::table root = files::parse_toml(files::read_text(file), file.string());
    files::Complaints complaints(file.string());
    if (const auto* given = files::table_at(root, "requirements", "", complaints)) {
        files::StructReader reader(
            complaints, [&] { return units_of(joint); }, files::Mode::change, explain);
        reader.read(*given, "requirements", table, files::names_of(files::spec_keys, "requirements"));
        if (const auto* uncertain = files::table_at(*given, "uncertain", "requirements", complaints))
            for (const auto& [path, node] : files::in_file_order(*uncertain)) {
                auto c = coordinate_from(joint, path);
                c.scale = share_from(node->is_string() ? node->as_string()->get()
                                                       : files::number_text(node->value<double>().value_or(0)),
                                     file.string() + ": requirements.uncertain." + path);
                r.uncertain.push_back(c);
            }
    }
    complaints.throw_if_any();
    for (const auto& change : changes) {
        files::Complaints about("--require " + change);
        const auto equals = change.find('=');
        if (equals == std::string::npos) throw BadInput("--require " + change + ": expected key=value");
        const std::string key = trimmed(change.substr(0, equals)), value = trimmed(change.substr(equals + 1));
        char* rest = nullptr;
        const double number = std::strtod(value.c_str(), &rest);
        toml::table one;
        if (!value.empty() && *rest == 0)
            one.insert(key, number);
        else
            one.insert(key, value);
        files::StructReader reader(
            about, [&] { return units_of(joint); }, files::Mode::change, explain);
        reader.read(one, "", table);
        about.throw_if_any();
    }
    return r;
}

}  // namespace stickslip
