#include "sweep/program/verbs/left_out.h"

#include "analysis/loop/loop_use.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/program/verbs/say.h"
#include "sweep/words/loop_text.h"

namespace stickslip {

void add_ideal_loop(Verb& verb, bool& ideal_loop)
{
    verb.add_flag("--ideal-loop", ideal_loop, "the paper's loop: no sampling, dead time, filter, lag or integral");
}

namespace {

std::optional<LeftOutLoop> say_left_out(const Joint& described)
{
    auto left_out = left_out_loop(described);
    if (left_out) say("note: {}\n", left_out_text(left_out->loop, left_out->growth));
    return left_out;
}

}  // namespace

std::optional<LeftOutLoop> leave_loop_out(Asked& asked)
{
    auto left_out = say_left_out(asked.design);
    asked.design = with_ideal_loop(asked.design);
    asked.spec.joint = with_ideal_loop(asked.spec.joint);
    return left_out;
}

std::optional<LeftOutLoop> leave_loop_out(Spec& spec)
{
    auto left_out = say_left_out(design_joint(spec));
    spec.joint = with_ideal_loop(spec.joint);
    refuse_left_out(spec.joint, spec.axes);
    return left_out;
}

void refuse_left_out(const Joint& ideal, const std::vector<Axis>& axes)
{
    for (const auto& axis : axes)
        if (!kept_by_ideal(ideal, axis.path))
            throw BadInput("--ideal-loop: leaves out " + axis.path +
                           ", expected axes that a joint without its loop has");
}

}  // namespace stickslip
