#include "sweep/program/verbs/left_out.h"

#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
#include "analysis/stability/verdict.h"
#include "sweep/program/verbs/say.h"
#include "sweep/words/loop_text.h"

namespace stickslip {

void add_ideal_loop(CLI::App& verb, bool& ideal_loop)
{
    verb.add_flag("--ideal-loop", ideal_loop, "the paper's loop: no sampling, dead time, filter, lag or integral");
}

void say_left_out(const Joint& described)
{
    if (loop_kind(described) == LoopKind::ideal) return;
    const Joint summed = described.control.structure == Structure::cascade ? with_gains(described) : described;
    say("note: {}\n", left_out_text(loop_use(summed), growth_rate(summed) < 0));
}

void leave_loop_out(Asked& asked)
{
    say_left_out(asked.design);
    asked.design = with_ideal_loop(asked.design);
    asked.spec.joint = with_ideal_loop(asked.spec.joint);
}

}  // namespace stickslip
