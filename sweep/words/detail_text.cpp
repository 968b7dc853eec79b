#include "sweep/words/detail_text.h"

namespace stickslip {

// In one piece: one sentence for each code.
std::string detail_text(Detail detail)
{
    switch (detail) {
        case Detail::none:
            return "";
        case Detail::late_with_memory:
            return "delayed friction is simulated without additional memory";
        case Detail::moving_normal_load:
            return "a normal load that depends on the motion ([normal]) is part of the linear theory only";
        case Detail::neighbours:
            return "neighbours are part of the linear theory only";
        case Detail::backlash:
            return "backlash in a transmission leaves no steady sliding to disturb";
        case Detail::place_or_time:
            return "a dither, or a force or friction that changes with position or time, can neither be followed until "
                   "it "
                   "repeats nor be held at places of its own; simulate shows the motion";
        case Detail::chatters:
            return "the push towards the set point jumps by more than the friction of steady sliding: the joint "
                   "chatters about its reference";
        case Detail::effort_limit:
            return "the effort limit is not above the effort of steady sliding: there is no steady sliding";
        case Detail::no_time_step:
            return "the fastest rate of the joint leaves no time step that the simulation can take";
        case Detail::force_loop:
            return "a force loop is simulated without sampling and dead time only";
        case Detail::normal_load_in_loop:
            return "[normal], a normal load that depends on the motion, is part of the linear theory only and is not "
                   "simulated";
        case Detail::neighbours_in_loop:
            return "[[neighbour]], joints coupled by the mass matrix, are part of the linear theory only and are not "
                   "simulated";
        case Detail::linear_law:
            return "the law is linear by definition";
        case Detail::bristles_with_memory:
            return "bristles combined with memory of the level have no equations of motion";
        case Detail::no_level:
            return "this law has no level that could depend on position, time or load";
        case Detail::limit_of_turns:
            return "the motion was simulated to the limit of cycles";
        case Detail::limit_of_work:
            return "the motion neither repeated nor settled within the usual work; --effort 10 simulates it ten times "
                   "as long";
        case Detail::larger_not_followed:
            return "a larger disturbance could not be simulated to its end";
        case Detail::stopped:
            return "the motion could not be simulated any further";
        case Detail::growth_unmeasured:
            return "the growth rate is too small relative to its frequency to be distinguished from rounding";
        case Detail::growth_unresolved:
            return "a small disturbance that is simulated does not grow at the rate of the spectrum: rounding hides it";
        case Detail::not_followed:
            return "no motion was simulated";
        case Detail::dead_time_too_long:
            return "the dead time is too many ticks long for the multipliers of the simulated loop";
        case Detail::leaves_within_tick:
            return "the loop leaves steady sliding within one tick";
        case Detail::branch_lost:
            return "the branch of limit cycles could not be followed to its end";
        case Detail::branch_not_smooth:
            return "such a fold is located by simulation: use boundary --kind fold";
        case Detail::fold_of_ideal_loop:
            return "the fold of a real loop is located by simulation: use boundary --kind fold";
        case Detail::few_rows:
            return "a reference needs at least two rows";
        case Detail::uneven_rows:
            return "the rows of the reference are not evenly spaced: a continuous loop is logged at them. Set "
                   "control.period, or space them evenly";
        case Detail::too_many_ticks:
            return "the reference has more than 20 million ticks";
        case Detail::law_at_rest:
            return "the law has no friction at rest and none backwards: take a reference that moves forward, or "
                   "rate-and-state-regularised";
        case Detail::no_state:
            return "a disturbed state is one of the friction on the link, and its law has none; other disturbances "
                   "(velocity, position, offset, impulse, start) need no state";
        case Detail::forces_in_loop:
            return "a force or a normal load from outside is simulated in the ideal loop only; --ideal-loop takes that "
                   "loop";
    }
    return "unknown";
}

std::string larger_tried_text(LargerTried tried)
{
    const std::string rest = "a start from near rest";
    switch (tried) {
        case LargerTried::none:
            return "";
        case LargerTried::from_near_rest:
            return rest;
        case LargerTried::pulls:
            return rest + "; pulls of the spring by 1.25, −1.25 and 3 V_0/|s|";
        case LargerTried::swings:
            return rest + "; a large swing of every lightly damped mode";
        case LargerTried::pull:
            return rest + "; a pull of the spring by 3 V_0/|s|";
        case LargerTried::pull_of_spring:
            return rest + "; a pull of the spring by 3 V_0 √(m/k_p)";
    }
    return "unknown";
}

}  // namespace stickslip
