#include "sweep/words/refusal_text.h"

#include "sweep/words/not_fitted_text.h"

#include <fmt/format.h>

namespace stickslip {
namespace {

/// A row, counted from 1.
int row_of(const CannotAnswer& r)
{
    return static_cast<int>(r.values.front());
}

std::string columns(const CannotAnswer& r)
{
    using Why = CannotAnswer::Why;
    switch (r.why) {
        case Why::no_time:
            return "there is no time column, or it is empty";
        case Why::no_position:
            return "there is no position column";
        case Why::column_length:
            return fmt::format("column {} has {:.0f} values, time has {:.0f}", r.name, r.values[0], r.values[1]);
        case Why::not_finite:
            return fmt::format("column {} is not a finite number in row {}", r.name, row_of(r));
        case Why::inertia_not_positive:
            return fmt::format("inertia is not positive in row {}", row_of(r));
        case Why::time_repeats:
            return fmt::format("time repeats in row {} ({:f} s)", row_of(r), r.values[1]);
        case Why::time_runs_back:
            return fmt::format("time runs backwards in row {} ({:f} s)", row_of(r), r.values[1]);
        default:
            return "";
    }
}

std::string of_table(const CannotAnswer& r)
{
    using Why = CannotAnswer::Why;
    switch (r.why) {
        case Why::table_of_many_bodies:
            return "a table of outcomes is read against a single-mass joint (Fig. 7); reduce this joint first";
        case Why::table_of_two_springs:
            return "a table of outcomes is read against one spring; add contact_stiffness to k_p and leave force_gain "
                   "0";
        case Why::no_number:
            return "the joint has no parameter " + r.name;
        case Why::no_velocity:
            return "V0 is not set or not above 0, neither in the row nor in the joint";
        case Why::no_stiffness:
            return "k_p is not above 0";
        default:
            return "";
    }
}

std::string of_joint(const CannotAnswer& r)
{
    using Why = CannotAnswer::Why;
    switch (r.why) {
        case Why::no_record:
            return "no record was given";
        case Why::force_loop:
            return "control.kind: is \"force\"; records are simulated under position control";
        case Why::contact_spring:
            return "control.contact_stiffness: records are simulated without a spring between link and surroundings";
        case Why::many_bodies:
            return "records are simulated with one or two masses: reduce the joint first";
        case Why::no_parameter:
            return "the joint has no parameter \"" + r.name + "\" to override";
        case Why::no_period:
            return "control.period is missing: a plan needs a sampled loop";
        case Why::no_position_gain:
            return "control.k_p is missing";
        case Why::few_rows:
            return "a motion of at least two rows is needed";
        case Why::no_noise:
            return "sensor.position_noise or sensor.encoder_quantum is needed: without noise every effect of any size "
                   "shows";
        case Why::short_motion:
            return fmt::format("a motion of at least {:.0f} periods is needed", r.values.front());
        default:
            return "";
    }
}

}  // namespace

std::string cannot_answer_text(const CannotAnswer& r)
{
    std::string text;
    for (const auto& words : {of_joint, columns, of_table})
        if (text.empty()) text = words(r);
    return (r.about.empty() ? "" : r.about + ": ") + text;
}

std::string refusal_text(const std::invalid_argument& refused)
{
    if (const auto* law = dynamic_cast<const NotFitted*>(&refused)) return not_fitted_text(*law);
    const auto* coded = dynamic_cast<const CannotAnswer*>(&refused);
    return coded ? cannot_answer_text(*coded) : refused.what();
}

}  // namespace stickslip
