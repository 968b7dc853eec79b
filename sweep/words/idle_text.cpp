#include "sweep/words/idle_text.h"

#include "sweep/words/loop_text.h"

namespace stickslip {

std::string idle_words(const IdleAxis& axis)
{
    if (axis.at_rest)
        return (axis.matters ? "no answer at a set point has a place for "
                             : "no answer of this joint at a set point depends on ") +
               axis.path;
    if (!axis.why) return "no linear verdict of this joint depends on " + axis.path;
    if (!is_left_out(axis)) return "nothing in this loop depends on " + axis.path + " (" + why_text(*axis.why) + ")";
    return "the linear theory has no term for " + axis.path + " (" + why_text(*axis.why) + ")";
}

void tell_idle(const std::vector<IdleAxis>& idle, bool simulated, Report& report)
{
    using Tone = Headline::Tone;
    for (const auto& axis : idle) {
        const bool warns = may_be_wrong_along(axis, simulated);
        auto text = idle_words(axis);
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
        text += simulated && is_left_out(axis) ? "; only simulated outcomes follow it."
                : warns                        ? ". Along it the verdicts here may be wrong: simulate it."
                                               : ".";
        report.alerts.push_back({warns ? Tone::warning : Tone::neutral, text});
        if (warns && report.tone == Tone::good) report.tone = Tone::warning;
    }
}

}  // namespace stickslip
