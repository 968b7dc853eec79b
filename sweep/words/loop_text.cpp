#include "sweep/words/loop_text.h"

#include "analysis/results/text.h"

#include <algorithm>

namespace stickslip {
namespace {

void add(std::string& list, const std::string& item)
{
    list += (list.empty() ? "" : ", ") + item;
}

}  // namespace

std::string loop_name(LoopKind kind)
{
    return kind == LoopKind::ideal ? "ideal" : kind == LoopKind::continuous ? "continuous" : "sampled";
}

std::string why_text(WhyNot why)
{
    switch (why) {
        case WhyNot::small_signal:
            return "small motions about steady sliding neither reach nor move it";
        case WhyNot::rounding:
            return "it is not linear: steady sliding jitters by about its size";
        case WhyNot::place:
            return "it depends on position: steady sliding has no one linear system";
        case WhyNot::time:
            return "it depends on time only and moves no root";
        case WhyNot::backlash:
            return "the linear theory takes the backlash as closed";
        case WhyNot::needs_period:
            return "it needs control.period";
        case WhyNot::no_feedback:
            return "the loop feeds nothing back through it";
        case WhyNot::reference_only:
            return "it acts on the reference only and moves no root";
        case WhyNot::load_direction:
            return "its friction changes where the effort at the load changes sign, which no linear system has";
        case WhyNot::fed_back:
            return "it follows the position error, and the linear theory has no term for it: the simulation has";
        case WhyNot::overruled:
            return "control.force_rate gives the velocity";
        case WhyNot::other_kind:
            return "position control has no such term";
        case WhyNot::told_velocity:
            return "a sampled loop with form = \"exact\" is told its velocity and estimates none";
        case WhyNot::unsupported:
            return "this loop is not computed with such friction";
    }
    return "unknown";
}

std::string loop_text(const LoopUse& loop)
{
    std::string used, matters, rest;
    for (const auto& key : loop.used) add(used, key);
    for (const auto& term : loop.not_used) add(term.matters ? matters : rest, term.key);
    std::string text;
    if (loop.kind != LoopKind::ideal) text += " The loop is " + loop_name(loop.kind) + ", with " + used + ".";
    if (!matters.empty()) text += " Not used, though it may change the verdict: " + matters + ".";
    if (!rest.empty()) text += " Not part of the linear verdict: " + rest + ".";
    const auto side = side_text(loop.gear, false);
    return side.empty() ? text : text + " " + side;
}

std::string left_out_text(const LoopUse& described, double growth)
{
    std::string used;
    for (const auto& key : described.used) add(used, key);
    const std::string loop = loop_name(described.kind) + " loop as it is, ";
    return "--ideal-loop leaves out " + used + " of the joint file. In the " + loop +
           (growth != growth ? "steady sliding at this velocity has no verdict."
            : growth < 0     ? "sliding at this velocity is stable."
                             : "sliding at this velocity is unstable.");
}

void tell_left_out(const LeftOut& left_out, bool stable, Report& report)
{
    using Tone = Headline::Tone;
    const bool same = (left_out.growth < 0) == stable;
    report.alerts.push_back({same ? Tone::neutral : Tone::warning, left_out_text(left_out.loop, left_out.growth)});
    if (!same && report.tone == Tone::good) report.tone = Tone::warning;
}

std::string of_ideal_loop(const std::string& verdict)
{
    return "In the paper's ideal loop. " + verdict;
}

std::string side_text(const GearSide& side, bool of_record)
{
    if (!side.between()) return {};
    const auto gear = "the gear of " + plain_number(side.ratio, 4) + ":1";
    const auto times = plain_number(side.gain, 4) + " times", turns = plain_number(side.ratio, 4) + " times";
    const auto constants = [&](const std::string& text) { return side.dc_motor ? text : std::string(); };
    if (of_record) {
        const auto where = std::string(side.reads_link ? "Readings of a record are the link's, its gains and efforts"
                                                       : "Readings, gains and efforts of a record") +
                           " are at the motor side of " + gear +
                           "; verdicts and maps of the same file count them at the joint's, ";
        return side.gain == 1
                   ? where + "where k_{p} is the same" + constants(" and k_{t} and k_{e} are " + turns + " as large") +
                         "."
                   : where + "where k_{p} is " + times + " as large" + constants(" and so are k_{t} and k_{e}") + ".";
    }
    const auto where =
        "Displacement, gains and efforts are at the joint side of " + gear + "; a record of the same file " +
        (side.reads_link ? "reads the link and pushes the motor" : "counts them at the motor's") + ", where k_{p} is ";
    return where + (side.gain == 1 ? "the same" : times + " smaller") +
           constants(". k_{t} and k_{e} are the joint's as well: " + turns + " those of the motor's data sheet") + ".";
}

std::string unstable_loop_text(const UnstableLoop& loop, Units units)
{
    std::string text = loop.diverges ? "The loop diverges: its position runs " +
                                           with_unit(loop.farthest, Quantity::position, units) + " off the reference"
                                     : std::string("The loop is unstable");
    if (loop.growth > 0)
        text += (loop.diverges ? ". It is unstable: s" : ": s") + std::string("mall disturbances of sliding at ") +
                with_unit(loop.velocity, Quantity::velocity, units) + " grow at " +
                with_unit(loop.growth, Quantity::rate, units);
    return text + ".";
}

std::string rewritten_law_text(std::string_view law)
{
    return "Friction law \"" + std::string(law) +
           "\" is written in the terms in which records are simulated (Coulomb, viscous and Stribeck friction, "
           "bristles, "
           "memory): the same equations under other names, also in the corrected joint file.";
}

std::string left_out_text(const std::vector<std::string>& keys)
{
    std::string list;
    for (const auto& key : keys) list += (list.empty() ? "" : ", ") + key;
    return "Records are simulated without " + list + ": what " + (keys.size() == 1 ? "it does" : "they do") +
           " to the machine is part of the gap.";
}

bool leaves_out_what_matters(const LoopUse& loop)
{
    return std::any_of(loop.not_used.begin(), loop.not_used.end(), [](const UnusedTerm& t) { return t.matters; });
}

Headline::Tone without_what_matters(Headline::Tone tone, const LoopUse& loop)
{
    return tone == Headline::Tone::good && leaves_out_what_matters(loop) ? Headline::Tone::warning : tone;
}

}  // namespace stickslip
