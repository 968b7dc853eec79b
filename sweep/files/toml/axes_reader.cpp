#include "sweep/files/toml/axes_reader.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/toml/hand_keys.h"
#include "sweep/files/toml/named_values.h"
#include "sweep/files/toml/refused_memory.h"
#include "sweep/study/samples.h"
#include "sweep/words/symbols.h"

#include <algorithm>
#include <cmath>

namespace stickslip::files {
namespace {

constexpr std::uint64_t max_axis_points = 1'000'000;  // of one axis; the product is limited by PlanLimits
const std::vector<std::string> axis_keys = names_of(spec_keys, "axes");

/// The list of an axis that was written out: log if it is spaced more evenly in the logarithm.
bool looks_logarithmic(const std::vector<double>& values)
{
    if (values.size() < 3 || values.front() <= 0) return false;
    const auto unevenness = [&](auto scale) {
        double least = infinity, most = 0;
        for (std::size_t i = 1; i < values.size(); ++i) {
            const double step = scale(values[i]) - scale(values[i - 1]);
            least = std::min(least, step);
            most = std::max(most, step);
        }
        return most / least;
    };
    return unevenness([](double v) { return std::log(v); }) < unevenness([](double v) { return v; });
}

class AxisReader {
  public:
    AxisReader(const NamedValue& given, const Parameter& leaf, Units units, Complaints& complaints)
        : given_(given), leaf_(leaf), units_(units), complaints_(complaints), path_("axes." + given.path)
    {
    }

    /// The values of the axis; empty after a complaint.
    std::optional<Axis> read()
    {
        Axis axis{given_.path, symbol_of(given_.path, units_), name_of(given_.path), leaf_.quantity, false, {}};
        const std::size_t before = complaints_.count();
        const auto* table = given_.node->as_table();
        if (table) complain_unknown_keys(*table, axis_keys, path_, complaints_);
        misspelt_ = complaints_.count() > before;
        if (!table) {
            axis.values = list(*given_.node, path_);
            axis.log = looks_logarithmic(axis.values);
        } else if (const auto* values = table->get("values")) {
            for (const char* key : {"from", "to", "points"})
                if (table->contains(key)) complain(*table, key, "has no meaning beside values");
            axis.values = list(*values, path_ + ".values");
            axis.log = table->contains("scale") ? scale(*table) : looks_logarithmic(axis.values);
            if (axis.log && !axis.values.empty() && axis.values.front() <= 0) complain_log(axis.values.front());
        } else {
            range(*table, axis);
        }
        if (complaints_.count() > before) return {};
        return axis;
    }

    /// How many values the axis asks for, refused or not.
    double requested() const { return requested_; }

  private:
    void complain(const toml::table& table, const char* key, const std::string& text)
    {
        const auto* node = table.get(key);
        complaints_.add(node ? Place(node->source()).or_else(given_.place) : given_.place, path_ + "." + key, text);
    }
    void complain_log(double value)
    {
        complaints_.add(given_.place, path_, "a log scale needs values > 0, got " + number_text(value));
    }

    bool scale(const toml::table& table)
    {
        const auto* node = table.get("scale");
        if (!node) return false;
        const std::string name = node->is_string() ? node->as_string()->get() : "";
        if (name != "log" && name != "linear")
            complain(table, "scale",
                     "is " + describe(*node) + ", expected log, linear" + did_you_mean(name, {"log", "linear"}));
        return name == "log";
    }

    std::vector<double> list(const toml::node& node, const std::string& path)
    {
        const auto* array = node.as_array();
        std::vector<double> values;
        if (!array) {
            if (const auto value = read_value(node, leaf_, units_, given_.place, path, complaints_))
                values.push_back(*value);
            return values;
        }
        if (array->empty())
            complaints_.add(Place(node.source()).or_else(given_.place), path,
                            "is an empty list, expected 1 or more values");
        requested_ = static_cast<double>(std::max<std::size_t>(1, array->size()));
        bool sound = true;
        for (const auto& element : *array) {
            const auto value = read_value(element, leaf_, units_, given_.place, path, complaints_);
            sound = sound && value;
            if (!sound) continue;
            if (!values.empty() && *value <= values.back()) {
                complaints_.add(Place(element.source()).or_else(given_.place), path,
                                "has " + number_text(*value) + " after " + number_text(values.back()) +
                                    ", expected ascending values");
                sound = false;
            } else {
                values.push_back(*value);
            }
        }
        return sound ? values : std::vector<double>{};
    }

    void range(const toml::table& table, Axis& axis)
    {
        axis.log = scale(table);
        std::optional<double> ends[2];
        for (const int i : {0, 1}) {
            const char* key = i == 0 ? "from" : "to";
            if (const auto* node = table.get(key))
                ends[i] = read_value(*node, leaf_, units_, given_.place, path_ + "." + key, complaints_);
            else if (!misspelt_)
                complain(table, key, "is missing, an axis is a list of values or { from, to, points, scale }");
        }
        const std::uint64_t points = points_of(table);
        if (!ends[0] || !ends[1] || points == 0) return;
        const auto [from, to] = std::pair{*ends[0], *ends[1]};
        if (axis.log && std::min(from, to) <= 0) return complain_log(std::min(from, to));
        if (points == 1 ? from != to : from >= to) {
            complain(
                table, "to",
                "is " + number_text(to) + ", expected " +
                    (points == 1 ? "the value of from where points = 1" : "a value above from = " + number_text(from)));
            return;
        }
        axis.values = spaced(from, to, points, axis.log);
        if (std::adjacent_find(axis.values.begin(), axis.values.end(), std::greater_equal<>()) != axis.values.end())
            complain(table, "points",
                     "is " + std::to_string(points) + ", more than there are numbers between from and to");
    }

    std::uint64_t points_of(const toml::table& table)
    {
        const auto* node = table.get("points");
        if (!node) {
            if (!misspelt_) complain(table, "points", "is missing, expected a whole number ≥ 1");
            return 0;
        }
        const auto given = node->is_number() ? node->value<double>() : std::nullopt;
        if (given && *given > 1) requested_ = *given;
        if (given && *given >= 1 && *given <= static_cast<double>(max_axis_points) && std::floor(*given) == *given)
            return static_cast<std::uint64_t>(*given);
        complain(
            table, "points",
            "is " + describe(*node) + ", expected a whole number within [1, " + std::to_string(max_axis_points) + "]");
        return 0;
    }

    const NamedValue& given_;
    const Parameter& leaf_;
    Units units_;
    Complaints& complaints_;
    std::string path_;
    double requested_ = 1;
    bool misspelt_ = false;  ///< what a key with a typo stands for is not missing as well
};

}  // namespace

std::vector<Axis> read_axes(const toml::table& table, Joint& joint, const PlanLimits& limits, bool nonlinear,
                            Complaints& complaints)
{
    std::vector<Axis> axes;
    std::vector<const double*> taken;
    double points = 1;  // never overflows; exact below 2^53, and beyond the limit it only has to be large
    bool sound = true;
    for (const auto& given : dotted_values(table, axis_keys)) {
        const auto leaf = find_leaf(joint, given.path, given.place, "axes", complaints);
        if (!leaf) {
            sound = false;
            continue;
        }
        if (std::find(taken.begin(), taken.end(), leaf->value) != taken.end())
            complaints.add(given.place, "axes." + given.path, "is the same parameter as an axis above");
        taken.push_back(leaf->value);
        AxisReader reader(given, *leaf, units_of(joint), complaints);
        auto axis = reader.read();
        points *= reader.requested();
        if (axis) {
            Joint latest = joint;
            const bool period = find_parameter(latest, axis->path) == &latest.control.period;
            number_at(latest, axis->path) = period ? axis->values.front() : axis->values.back();
            const auto late = refused_memory(latest.control, latest.sensor.delay);
            if (!late.path.empty()) complaints.add(given.place, "axes." + given.path, late.path + " " + late.message);
        }
        sound = sound && axis;
        if (axis) axes.push_back(std::move(*axis));
    }
    if (axes.empty() && sound) complaints.add(Place(table.source()), "axes", "are empty, expected one axis or more");
    if (points > static_cast<double>(limits.points))
        complaints.add(Place(table.source()), "axes",
                       "make " + number_text(points) + " points (about " + describe(plan_cost(points, nonlinear)) +
                           "), expected at most " + number_text(static_cast<double>(limits.points)));
    return axes;
}

}  // namespace stickslip::files
