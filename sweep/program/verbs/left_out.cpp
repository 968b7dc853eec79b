#include "sweep/program/verbs/left_out.h"

#include "analysis/loop/loop_use.h"
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

void leave_loop_out(Spec& spec)
{
    say_left_out(design_joint(spec));
    spec.joint = with_ideal_loop(spec.joint);
}

}  // namespace stickslip
