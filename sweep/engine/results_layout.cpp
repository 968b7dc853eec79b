#include "sweep/engine/results_layout.h"

#include <netcdf.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace stickslip {
namespace {

/// The last parts of a dotted path, joined by underscores: ("friction.L.0", 2) gives "L_0".
std::string tail(const std::string& path, int parts)
{
    std::size_t from = path.size();
    while (parts-- > 0 && from != std::string::npos && from > 0) from = path.rfind('.', from - 1);
    std::string name = from == std::string::npos ? path : path.substr(from + 1);
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

bool is_a_name(const std::string& name)
{
    return !name.empty() && !std::isdigit(static_cast<unsigned char>(name.front()));
}

int parts_of(const std::string& path)
{
    return 1 + static_cast<int>(std::ranges::count(path, '.'));
}

int define_variable(const NetcdfFile& file, const std::string& name, nc_type type, const std::vector<int>& dimensions)
{
    int variable = -1;
    file.check(
        nc_def_var(file.id(), name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(), &variable),
        "define " + name);
    // Every point is written, so filling the space first would only write the whole file twice.
    file.check(nc_def_var_fill(file.id(), variable, NC_NOFILL, nullptr), "set " + name);
    if (!dimensions.empty())
        file.check(nc_def_var_chunking(file.id(), variable, NC_CONTIGUOUS, nullptr), "lay out " + name);
    return variable;
}

void describe_coordinate(const NetcdfFile& file, int variable, const Axis& axis, Units units)
{
    file.put_text(variable, "units", unit_of(axis.quantity, units));
    file.put_text(variable, "long_name", axis.name);
    file.put_text(variable, "symbol", axis.symbol);
    file.put_text(variable, "path", axis.path);
    file.put_text(variable, "scale", axis.log ? "log" : "linear");
}

int define_number(const NetcdfFile& file, const Column& column, const std::vector<int>& dimensions, Units units)
{
    const int variable = define_variable(file, std::string(column.name), NC_DOUBLE, dimensions);
    file.check(nc_put_att_double(file.id(), variable, "_FillValue", NC_DOUBLE, 1, &missing), "set the fill value");
    file.put_text(variable, "long_name", column.long_name);
    file.put_text(variable, "units", unit_of(column.quantity, units));
    return variable;
}

int define_code(const NetcdfFile& file, const Column& column, const std::vector<int>& dimensions)
{
    const int variable = define_variable(file, std::string(column.name), NC_BYTE, dimensions);
    std::vector<signed char> values(static_cast<std::size_t>(1 + std::ranges::count(column.meanings, ' ')));
    std::iota(values.begin(), values.end(), static_cast<signed char>(0));
    file.put_text(variable, "long_name", column.long_name);
    file.check(nc_put_att_schar(file.id(), variable, "flag_values", NC_BYTE, values.size(), values.data()),
               "write flag_values");
    file.put_text(variable, "flag_meanings", column.meanings);
    return variable;
}

void describe_file(const NetcdfFile& file, const Plan& plan)
{
    file.put_text(global_attribute, "Conventions", "CF-1.10");
    file.put_text(global_attribute, "title", plan.title);
    file.put_text(global_attribute, "source", "stickslip " + plan.version);
    file.put_text(global_attribute, "plan_id", to_text(plan.id));
    file.put_text(global_attribute, "command", plan.command);
    file.put_text(global_attribute, "build", plan.build);
    file.put_text(global_attribute, "motion", plan.units.motion == Motion::revolute ? "revolute" : "prismatic");
    file.put_text(global_attribute, "drive_signal", name_of(plan.units.command));
    file.put_text(global_attribute, "joint", plan.joint);
    file.put_text(global_attribute, "options", plan.options);
    file.put_text(global_attribute, "spec", plan.spec);
}

}  // namespace

std::vector<std::string> dimension_names(const std::vector<Axis>& axes)
{
    const auto clashes = [&](const std::string& name, std::size_t self, int parts) {
        for (const Column& column : columns())
            if (column.name == name) return true;
        for (std::size_t i = 0; i < axes.size(); ++i)
            if (i != self && tail(axes[i].path, std::min(parts, parts_of(axes[i].path))) == name) return true;
        return false;
    };
    std::vector<std::string> names;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        int parts = 1;
        std::string name = tail(axes[i].path, parts);
        while (parts < parts_of(axes[i].path) && (!is_a_name(name) || clashes(name, i, parts)))
            name = tail(axes[i].path, ++parts);
        const std::string whole = name;
        for (int n = 2; std::ranges::find(names, name) != names.end(); ++n) name = whole + "_" + std::to_string(n);
        names.push_back(name);
    }
    return names;
}

ResultsVariables define_results(const NetcdfFile& file, const Plan& plan, const RowFormat& format)
{
    int before = 0;
    file.check(nc_set_fill(file.id(), NC_NOFILL, &before), "switch filling off");
    describe_file(file, plan);

    const auto names = dimension_names(plan.axes);
    std::vector<int> dimensions(names.size()), coordinates;
    for (std::size_t i = 0; i < names.size(); ++i)
        file.check(nc_def_dim(file.id(), names[i].c_str(), plan.axes[i].values.size(), &dimensions[i]),
                   "define " + names[i]);
    for (std::size_t i = 0; i < names.size(); ++i) {
        coordinates.push_back(define_variable(file, names[i], NC_DOUBLE, {dimensions[i]}));
        describe_coordinate(file, coordinates.back(), plan.axes[i], plan.units);
    }
    ResultsVariables variables;
    for (const Column* column : format.numbers())
        variables.numbers.push_back(define_number(file, *column, dimensions, plan.units));
    for (const Column* column : format.codes()) variables.codes.push_back(define_code(file, *column, dimensions));
    file.check(nc_enddef(file.id()), "end the definitions");

    for (std::size_t i = 0; i < names.size(); ++i)
        file.check(nc_put_var_double(file.id(), coordinates[i], plan.axes[i].values.data()), "write " + names[i]);
    return variables;
}

}  // namespace stickslip
