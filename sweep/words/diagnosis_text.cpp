#include "sweep/words/diagnosis_text.h"

#include "sweep/words/diagnosis_tables.h"

namespace stickslip {
namespace {

/// "a force that depends on the position alone"
std::string force_of(const std::string& signal)
{
    if (signal == "hysteresis")
        return "a force that follows the position behind a play, and so differs on the way back,";
    return "a force that depends on the " + signal + " alone";
}

}  // namespace

std::string note_text(const Note& note)
{
    const auto nearest = [&] { return together(note.names) + " comes nearest, but "; };
    switch (note.code) {
        case Note::Code::unexplained:
            return "there is a gap, and no effect of the catalogue, nor two together, explain it: the best leaves " +
                   whole_percent(1 - note.taken) + " of it";
        case Note::Code::free_force:
            return force_of(note.signal) + " would explain " + whole_percent(note.taken) + " of it";
        case Note::Code::nothing_earns:
            return "no cause takes a part of the gap on data that its fit has not seen, with inertia, friction and "
                   "load "
                   "refitted beside it";
        case Note::Code::takes_too_little:
            return nearest() + "takes only " + whole_percent(note.taken) + " of a gap of which " +
                   whole_percent(note.explainable) + " are explainable";
        case Note::Code::nearer_force:
            return nearest() + force_of(note.signal) +
                   " explains the records clearly better, and has the shape of no effect of the catalogue";
        case Note::Code::force_in_the_rest:
            return nearest() + "a force that depends on the " + note.signal +
                   " alone, in the shape of no effect of the catalogue, explains what it leaves";
        default:
            return note.text;
    }
}

}  // namespace stickslip
