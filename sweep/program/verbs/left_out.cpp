#include "sweep/program/verbs/left_out.h"

#include "analysis/loop/loop_use.h"
#include "analysis/stability/verdict.h"
#include "sweep/program/verbs/say.h"
#include "sweep/words/loop_text.h"

namespace stickslip {

void add_ideal_loop(Verb& verb, bool& ideal_loop)
{
    verb.add_flag("--ideal-loop", ideal_loop, "the paper's loop: no sampling, dead time, filter, lag or integral");
}

namespace {

void say_left_out(const Joint& described)
{
    const auto left_out = left_out_by_ideal(described);
    if (!left_out.used.empty()) say("note: {}\n", left_out_text(left_out, growth_rate(described)));
}

}  // namespace

void leave_loop_out(Asked& asked)
{
    say_left_out(asked.design);
    asked.design = with_ideal_loop(asked.design);
    asked.spec.joint = with_ideal_loop(asked.spec.joint);
}

void leave_loop_out(Spec& spec)
{
    say_left_out(design_joint(spec));
    spec.joint = with_ideal_loop(spec.joint);
}

}  // namespace stickslip
