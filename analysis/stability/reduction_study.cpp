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
                    ControlKind kind)
{
    const bool position = kind == ControlKind::position;
    if (position)
        list.push_back({chained(to_two, two_mass_to_single_mass), spring, loop_gain, "k_{p} ≫ k_{tr}"});
    else
        list.push_back({chained(to_two, two_mass_to_single_mass), loop_gain, spring, "k_{tr} ≫ k_{c}"});
    list.push_back(
        {chained(to_two, rigid_transmission), loop_gain, spring, position ? "k_{tr} ≫ k_{p}" : "k_{tr} ≫ k_{c}"});
}

/// From which value on every error stays within the limit.
double holds_from(const ReductionStudy& study, double limit)
{
    double from = missing;
    for (std::size_t i = study.values.size(); i-- > 0 && study.at[i].error <= limit;) from = study.values[i];
    return from;
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
        study.name = c.assumption;
        study.refused = e.what();
        return study;
    }
    study.boundary_path = c.boundary_path;
    study.assumption_path = c.assumption_path;
    study.assumption = c.assumption;
    const double centre = *find_parameter(joint, c.boundary_path);
    const double low = centre * std::pow(10, -options.boundary_decades),
                 high = centre * std::pow(10, options.boundary_decades);
    const auto compare = [&] { return compare_reduction(joint, c.reduce, c.boundary_path, low, high, options.scan); };
    study.own = compare();
    if (c.assumption_path.empty()) return study;
    double& assumed = *find_parameter(joint, c.assumption_path);
    const double own = assumed;
    for (int i = 0; i < options.values; ++i) {
        assumed = own * std::pow(10, options.decades * (2.0 * i / (options.values - 1) - 1));
        study.values.push_back(assumed);
        study.at.push_back(compare());
    }
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
        const bool position = kind == ControlKind::position;
        const std::string spring = "joint.transmission.stiffness";
        if (position)
            list.push_back({two_mass_to_single_mass, spring, loop_gain, "k_{p} ≫ k_{tr}"});
        else
            list.push_back({two_mass_to_single_mass, loop_gain, spring, "k_{tr} ≫ k_{c}"});
        list.push_back({rigid_transmission, loop_gain, spring, position ? "k_{tr} ≫ k_{p}" : "k_{tr} ≫ k_{c}"});
    } else if (joint.mechanism.model == Model::three_mass) {
        list.push_back({at_motor, loop_gain, motor, "k_{m-tr} ≫ k_{tr-l}"});
        list.push_back({at_joint, loop_gain, link, "k_{tr-l} ≫ k_{m-tr}"});
        add_last_steps(list, at_motor, link, kind);
        add_last_steps(list, at_joint, motor, kind);
    } else if (joint.mechanism.model == Model::lever) {
        list.push_back({lever_to_three_mass, loop_gain, "", "small displacements"});
        list.push_back({chained(lever_to_three_mass, at_motor), loop_gain, motor, "k_{m-tr} ≫ k_{tr-l}"});
        list.push_back({chained(lever_to_three_mass, at_joint), loop_gain, link, "k_{tr-l} ≫ k_{m-tr}"});
        add_last_steps(list, chained(lever_to_three_mass, at_motor), link, kind);
        add_last_steps(list, chained(lever_to_three_mass, at_joint), motor, kind);
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
