#include "analysis/stability/reduction_study.h"

#include <cmath>
#include <functional>
#include <stdexcept>

#include "analysis/joint/parameters.h"

namespace stickslip {
namespace {

using Reduce = std::function<Reduction(const Joint&)>;

Reduce chained(Reduce first, Reduce second)
{
    return [first = std::move(first), second = std::move(second)](const Joint& joint) {
        return in_sequence(first(joint), second);
    };
}

constexpr const char* loop_gain = "control.k_p";

/// Fig. 6 → 7, `spring` being where the remaining transmission stands in the full joint.
void add_last_steps(std::vector<NamedReduction>& list, const Reduce& to_two, const std::string& spring,
                    ControlKind kind, const std::string& before = "")
{
    const bool position = kind == ControlKind::position;
    const auto after = [&](const Reduce& step) { return to_two ? chained(to_two, step) : step; };
    const std::string ideal = before + "Fig. 6 to 7, ideal motor", rigid = before + "Fig. 6 to 7, rigid transmission";
    if (position)
        list.push_back({after(two_mass_to_single_mass), spring, loop_gain, "k_{p} ≫ k_{tr}", ideal});
    else
        list.push_back({after(two_mass_to_single_mass), loop_gain, spring, "k_{tr} ≫ k_{c}", ideal});
    list.push_back(
        {after(rigid_transmission), loop_gain, spring, position ? "k_{tr} ≫ k_{p}" : "k_{tr} ≫ k_{c}", rigid});
}

/// From which value on every error stays within the limit.
double holds_from(const ReductionStudy& study, double limit)
{
    double from = missing;
    for (std::size_t i = study.values.size(); i-- > 0 && study.at[i].error <= limit;) from = study.values[i];
    return from;
}

/// Whether a boundary moves so far between two values that a line through both would show corners, or begins or ends.
bool far_apart(const ReductionError& a, const ReductionError& b)
{
    constexpr double most = 0.1;  // of the logarithm
    for (auto side : {&ReductionError::full, &ReductionError::reduced}) {
        if ((a.*side).size() != (b.*side).size()) return true;
        for (std::size_t i = 0; i < (a.*side).size(); ++i)
            if (std::abs(std::log((a.*side)[i] / (b.*side)[i])) > most) return true;
    }
    return false;
}

/// Adds a value between every two that are far apart.
template <class Compare>
void refine(ReductionStudy& study, Compare&& compare_at)
{
    std::vector<double> values;
    std::vector<ReductionError> at;
    for (std::size_t i = 0; i < study.values.size(); ++i) {
        if (i > 0 && far_apart(study.at[i - 1], study.at[i])) {
            values.push_back(std::sqrt(study.values[i - 1] * study.values[i]));
            at.push_back(compare_at(values.back()));
        }
        values.push_back(study.values[i]);
        at.push_back(study.at[i]);
    }
    study.values = std::move(values);
    study.at = std::move(at);
}

ReductionStudy study_of(Joint joint, const NamedReduction& c, const StudyOptions& options)
{
    ReductionStudy study;
    try {
        const auto reduced = c.reduce(joint);
        study.name = reduced.name;
        study.model = reduced.model;
        study.neglected = reduced.neglected;
    } catch (const std::invalid_argument& e) {
        study.name = c.steps;
        study.assumption = c.assumption;
        study.refused = e.what();
        return study;
    }
    study.boundary_path = c.boundary_path;
    study.assumption_path = c.assumption_path;
    study.assumption = c.assumption;
    const double centre = *find_parameter(joint, c.boundary_path);
    int scan = options.scan;
    const auto compare = [&] {
        return compare_reduction(joint, c.reduce, c.boundary_path, study.searched_low, study.searched_high, scan);
    };
    const auto search = [&](double decades) {
        study.searched_low = centre * std::pow(10, -decades), study.searched_high = centre * std::pow(10, decades);
        scan = static_cast<int>(options.scan * decades / options.boundary_decades);
        study.own = compare();
    };
    search(options.boundary_decades);
    if (std::isnan(study.own.error)) search(options.far_decades);
    if (c.assumption_path.empty()) return study;
    const auto assumed = number_at(joint, c.assumption_path);
    const double own = assumed;
    const auto compare_at = [&](double value) {
        assumed = value;
        return compare();
    };
    for (int i = 0; i < options.values; ++i) {
        study.values.push_back(own * std::pow(10, options.decades * (2.0 * i / (options.values - 1) - 1)));
        study.at.push_back(compare_at(study.values.back()));
    }
    for (int round = 0; round < options.refinements; ++round) refine(study, compare_at);
    study.good_from = holds_from(study, 0.01);
    study.fair_from = holds_from(study, 0.1);
    return study;
}

}  // namespace

std::vector<NamedReduction> reductions_of(const Joint& joint)
{
    const std::string motor = "joint.motor_transmission.stiffness", link = "joint.transmission_link.stiffness";
    const auto kind = joint.control.kind;
    const Reduce at_motor = [](const Joint& j) { return three_mass_to_two_mass(j, Placement::at_motor); };
    const Reduce at_joint = [](const Joint& j) { return three_mass_to_two_mass(j, Placement::at_joint); };
    std::vector<NamedReduction> list;
    if (joint.mechanism.model == Model::two_mass) {
        add_last_steps(list, {}, "joint.transmission.stiffness", kind);
    } else if (joint.mechanism.model == Model::three_mass) {
        const std::string steps = "Fig. 5 to 6, transmission at the ";
        list.push_back({at_motor, loop_gain, motor, "k_{m-tr} ≫ k_{tr-l}", steps + "motor"});
        list.push_back({at_joint, loop_gain, link, "k_{tr-l} ≫ k_{m-tr}", steps + "joint"});
        add_last_steps(list, at_motor, link, kind, steps + "motor, then ");
        add_last_steps(list, at_joint, motor, kind, steps + "joint, then ");
    } else if (joint.mechanism.model == Model::lever) {
        const std::string steps = "Fig. 4 to 6, transmission at the ";
        list.push_back({lever_to_three_mass, loop_gain, "", "small displacements", "Fig. 4 to 5"});
        list.push_back(
            {chained(lever_to_three_mass, at_motor), loop_gain, motor, "k_{m-tr} ≫ k_{tr-l}", steps + "motor"});
        list.push_back(
            {chained(lever_to_three_mass, at_joint), loop_gain, link, "k_{tr-l} ≫ k_{m-tr}", steps + "joint"});
        add_last_steps(list, chained(lever_to_three_mass, at_motor), link, kind, steps + "motor, then ");
        add_last_steps(list, chained(lever_to_three_mass, at_joint), motor, kind, steps + "joint, then ");
    }
    return list;
}

std::vector<ReductionStudy> reduction_studies(const Joint& joint, const StudyOptions& options)
{
    std::vector<ReductionStudy> studies;
    for (const auto& reduction : reductions_of(joint)) studies.push_back(study_of(joint, reduction, options));
    return studies;
}

}  // namespace stickslip
