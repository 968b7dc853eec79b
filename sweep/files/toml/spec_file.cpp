#include "sweep/files/toml/spec_file.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/axes_reader.h"
#include "sweep/files/toml/boundary_table.h"
#include "sweep/files/toml/hand_keys.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/files/toml/joint_keys.h"
#include "sweep/files/toml/joint_table.h"
#include "sweep/files/toml/named_values.h"
#include "sweep/files/toml/robot_table.h"
#include "sweep/files/toml/struct_reader.h"

#include <algorithm>

namespace stickslip {
namespace files {
namespace {

const std::vector<std::string> spec_tables{"title",  "axes",  "design", "nonlinear",    "boundary",
                                           "report", "check", "record", "requirements", "robot"};

class SpecReader {
  public:
    SpecReader(const toml::table& root, std::filesystem::path folder, const PlanLimits& limits, Complaints& complaints)
        : root_(root), folder_(std::move(folder)), limits_(limits), complaints_(complaints)
    {
    }

    Spec read()
    {
        read_joint_part();
        read_text_at(root_, "title", "", spec_.title, complaints_);
        read_struct("nonlinear", spec_.nonlinear);
        if (joint_known_) read_paths();  // which can be judged only against a joint
        read_struct("check", spec_.check);
        return std::move(spec_);
    }

  private:
    void read_joint_part()
    {
        const std::size_t before = complaints_.count();
        const auto* file = root_.get("joint");
        if (file && file->is_string()) {
            reject_inline_tables(Place(file->source()));
            const std::filesystem::path path = folder_ / file->as_string()->get();
            spec_.joint_file = path.string();
            std::error_code none;
            if (!std::filesystem::exists(path, none)) {
                complaints_.add(Place(file->source()), "joint",
                                "names " + path.string() + ", which does not exist; the path starts at this file");
                return;
            }
            try {
                spec_.joint = read_joint(path);
            } catch (const BadInput& bad) {
                complaints_.add_foreign(bad.messages());
            }
        } else {
            spec_.joint = joint_from(root_, complaints_, spec_tables, folder_);
        }
        if (complaints_.count() == before) read_robot_table(root_, folder_, spec_.joint, complaints_);
        joint_known_ = complaints_.count() == before;
    }

    /// A joint file and tables beside it would leave open which one holds.
    void reject_inline_tables(const Place& place)
    {
        std::vector<std::string> allowed = spec_tables;
        allowed.emplace_back("joint");
        for (auto&& [key, node] : root_) {
            const std::string name(key.str());
            if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
            complaints_.add(Place(key.source()).or_else(place), name,
                            "does not belong beside joint = \"…\", expected " + listed(spec_tables) +
                                did_you_mean(name, spec_tables));
        }
    }

    void read_paths()
    {
        const auto* axes = root_.get("axes");
        if (!axes)
            complaints_.add(Place(root_.source()), "axes",
                            "is missing, expected one or more dotted paths of the joint, such as "
                            "\"control.k_p\" = { from = 1e4, to = 1e5, points = 31 }");
        else if (const auto* table = table_at(root_, "axes", "", complaints_)) {
            const auto before = complaints_.count();
            spec_.axes = read_axes(*table, spec_.joint, limits_, spec_.nonlinear.enabled, complaints_);
            axes_refused_ = complaints_.count() > before;
        }
        read_design();
        require_velocity();
        read_boundary();
        read_report();
    }

    /// Design values of axes mark a point; of other paths they hold for the whole sweep.
    void read_design()
    {
        std::vector<std::pair<const double*, double>> given;
        if (const auto* table = table_at(root_, "design", "", complaints_)) {
            for (const auto& named : dotted_values(*table, {})) {
                const auto leaf = find_leaf(spec_.joint, named.path, named.place, "design", complaints_);
                if (!leaf) continue;
                const auto value = read_value(*named.node, *leaf, units_of(spec_.joint), named.place,
                                              "design." + named.path, complaints_);
                if (!value) continue;
                given.emplace_back(leaf->value, *value);
                if (!is_axis(leaf->value)) number_at(spec_.joint, leaf->path) = *value;
            }
        }
        for (const auto& axis : spec_.axes) {
            const double* leaf = find_parameter(spec_.joint, axis.path);
            double value = *leaf;
            for (const auto& [where, what] : given)
                if (where == leaf) value = what;
            spec_.design.emplace_back(axis.path, value);
        }
    }

    bool is_axis(const double* leaf)
    {
        return std::any_of(spec_.axes.begin(), spec_.axes.end(),
                           [&](const Axis& axis) { return find_parameter(spec_.joint, axis.path) == leaf; });
    }

    /// Every map is a map of steady sliding.
    void require_velocity()
    {
        const auto& control = spec_.joint.control;
        if (is_set(control.V0) || is_set(control.force_rate)) return;
        if (is_axis(&spec_.joint.control.V0) || is_axis(&spec_.joint.control.force_rate)) return;
        complaints_.add(
            Place(root_.source()), "control.V0",
            "is missing, a sweep needs the commanded velocity: control.V0, or control.force_rate, in the joint, "
            "in [design] or as an axis");
    }

    void read_boundary()
    {
        if (!root_.contains("boundary")) return;
        spec_.boundary.emplace();
        read_struct("boundary", *spec_.boundary, boundary_lists);
        if (const auto* table = root_.get("boundary")->as_table())
            read_boundary_lists(*table, spec_.joint, *spec_.boundary, complaints_);
    }

    void read_report()
    {
        const auto* table = table_at(root_, "report", "", complaints_);
        if (!table) return;
        complain_unknown_keys(*table, names_of(spec_keys, "report"), "report", complaints_);
        read_text_at(*table, "title", "report", spec_.report.title, complaints_);
        spec_.report.charts = pairs(*table, "charts");
        spec_.report.surfaces = pairs(*table, "surfaces");
    }

    /// [["control.k_p", "control.k_v"], …], or a single pair.
    std::vector<std::array<std::string, 2>> pairs(const toml::table& table, const std::string& key)
    {
        const auto* node = table.get(key);
        if (!node) return {};
        const auto* list = node->as_array();
        std::vector<std::array<std::string, 2>> found;
        if (list && list->size() == 2 && list->get(0)->is_string()) {
            if (auto one = pair(*node, "report." + key)) found.push_back(std::move(*one));
            return found;
        }
        if (!list) {
            complaints_.add(Place(node->source()), "report." + key,
                            "is " + describe(*node) + ", expected a list of pairs of axes");
            return {};
        }
        for (const auto& element : *list)
            if (auto one = pair(element, "report." + key)) found.push_back(std::move(*one));
        return found;
    }

    std::optional<std::array<std::string, 2>> pair(const toml::node& node, const std::string& path)
    {
        std::vector<std::string> paths;
        for (const auto& axis : spec_.axes) paths.push_back(axis.path);
        const auto* list = node.as_array();
        std::array<std::string, 2> names;
        if (!list || list->size() != 2 || !list->get(0)->is_string() || !list->get(1)->is_string()) {
            complaints_.add(Place(node.source()), path,
                            "is " + describe(node) + ", expected a pair such as [\"control.k_p\", \"control.k_v\"]");
            return {};
        }
        bool sound = true;
        for (std::size_t i = 0; i < 2; ++i) {
            names[i] = list->get(i)->as_string()->get();
            if (std::find(paths.begin(), paths.end(), names[i]) != paths.end()) continue;
            sound = false;
            if (axes_refused_) continue;  // it may mean one of those
            complaints_.add(
                Place(list->get(i)->source()), path,
                "is \"" + names[i] + "\", expected the axes " + listed(paths) + did_you_mean(names[i], paths));
        }
        if (sound && names[0] == names[1]) {
            complaints_.add(Place(node.source()), path, "has \"" + names[0] + "\" twice, expected two different axes");
            sound = false;
        }
        return sound ? std::optional(names) : std::nullopt;
    }

    template <class Struct>
    void read_struct(const std::string& key, Struct& s, const std::vector<std::string>& also_allowed = {})
    {
        const auto explain = [](const std::string& path, const std::vector<std::string>& siblings) {
            return "unknown key, expected " + listed(siblings) +
                   did_you_mean(path.substr(path.rfind('.') + 1), siblings);
        };
        const auto* table = table_at(root_, key, "", complaints_);
        if (!table) return;
        StructReader reader(
            complaints_, [this] { return units_of(spec_.joint); }, Mode::whole, explain);
        reader.read(*table, key, s, also_allowed);
    }

    const toml::table& root_;
    std::filesystem::path folder_;
    const PlanLimits& limits_;
    Complaints& complaints_;
    Spec spec_;
    bool joint_known_ = false, axes_refused_ = false;
};

}  // namespace
}  // namespace files

Spec read_spec_text(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                    const PlanLimits& limits)
{
    const toml::table root = files::parse_toml(text, name);
    files::Complaints complaints(name);
    Spec spec = files::SpecReader(root, folder, limits, complaints).read();
    complaints.throw_if_any();
    return spec;
}

Spec read_spec(const std::filesystem::path& file, const PlanLimits& limits)
{
    return read_spec_text(files::read_text(file), file.string(), file.parent_path(), limits);
}

}  // namespace stickslip
