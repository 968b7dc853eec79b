#include "sweep/words/suspicion_text.h"

#include "analysis/base/number_text.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace stickslip {
namespace {

using Code = Note::Code;

/// A signal in a sentence. Columns are called as they stand in the file.
std::string signal_text(const std::string& name)
{
    if (name == "drive") return "the drive signal";
    if (name == "position_rate") return "the rate of position";
    if (name == "reference_position_rate") return "the rate of reference_position";
    return name;
}

/// A factor as one reads it: never below one, to a tenth.
std::string times(double factor)
{
    const double above_one = std::max(std::abs(factor), 1 / std::abs(factor));
    return number_text(std::round(10 * above_one) / 10) + " times";
}

std::string times_or_less(double factor)
{
    return times(factor) + (std::abs(factor) < 1 ? " less than" : "");
}

std::string of_signals(const Note& n)
{
    const auto name = [&](std::size_t i) { return signal_text(n.names.at(i)); };
    constexpr auto name_unit = "; [record] can name the unit",
                   turn = "; scale = -1 under [record.columns] turns a signal round";
    switch (n.code) {
        case Code::unit_between_signals:
            return fmt::format("suspected {}: {} moves {} as far as {}{}", n.names.at(0), name(1),
                               times(n.values.at(0)), name(2), name_unit);
        case Code::opposite_signs:
            return fmt::format("suspected sign: {} runs against {}{}", name(0), name(1), turn);
        case Code::unit_of_rate:
            return fmt::format("suspected unit: {} is {} {}{}", name(0), times_or_less(n.values.at(0)), name(1),
                               name_unit);
        case Code::unit_of_effort:
            return fmt::format("suspected unit: effort_measured varies by {} the command requires{}",
                               n.values.at(0) < 1 ? times_or_less(n.values[0]) : times(n.values[0]) + " as much as",
                               name_unit);
        case Code::dead_signal:
            return fmt::format("{} stays at {} while position moves: remove the column if it was not connected",
                               name(0), number_text(n.values.at(0)));
        case Code::unsigned_numbers:
            return fmt::format(
                "{} lies between 0 and {} and between {} and {}: negative numbers read as unsigned ones "
                "(two's complement of {:.0f} bits) are suspected; take {} off the upper half",
                name(0), number_text(n.values.at(0)), number_text(n.values.at(1)), number_text(n.values.at(2)),
                n.values.at(3), number_text(n.values.at(4)));
        case Code::magnitude_only:
            return fmt::format(
                "{} is never negative although the command is: its magnitude was logged; remove the "
                "column, or give it the sign of the command",
                name(0));
        default:
            return "";
    }
}

std::string of_joint(const Note& n)
{
    const auto value = [&](std::size_t i) { return number_text(n.values.at(i)); };
    switch (n.code) {
        case Code::motor_off:
            return fmt::format("{:.0f} of {:.0f} rows have torque_enable = 0: the motor was off", n.values.at(0),
                               n.values.at(1));
        case Code::unit_by_gains:
            return fmt::format(
                "suspected {}: with the gains of the joint the logged motion requires {} the logged "
                "command; [record] can name the unit",
                n.names.at(0), times(n.values.at(0)));
        case Code::sign_by_gains:
            return "suspected sign: with the gains of the joint the logged motion requires the opposite of the logged "
                   "command; scale = -1 under [record.columns] turns a signal round";
        case Code::gains_of_another_joint:
            return fmt::format(
                "suspected record of another joint: with the gains of the joint the logged motion requires "
                "{} the logged command; per record, [record.files] can give other gains",
                times_or_less(n.values.at(0)));
        case Code::unit_by_travel:
            return fmt::format(
                "suspected {}: position travels {} {}; position = {{ unit = \"{}\" }} under "
                "[record.columns] says so, unit = \"{}\" that it is right",
                n.names.at(0), number_text(std::round(10 * n.values.at(0)) / 10), n.names.at(2), n.names.at(1),
                n.names[2]);
        case Code::unit_of_clock:
            return fmt::format("suspected {}: rows are {} s apart, control.period is {} s; [record] can name the unit",
                               n.names.empty() ? "another unit of time than seconds" : n.names[0], value(0), value(1));
        case Code::slow_clock:
            return fmt::format(
                "suspected milliseconds: rows are {} s apart; time = {{ unit = \"ms\" }} under "
                "[record.columns] says so, unit = \"s\" that it is right",
                value(0));
        case Code::duty_above_one:
            return fmt::format(
                "duty reaches {}, a duty cycle is at most 1; duty = {{ scale = … }} under "
                "[record.columns] converts per cent or counts",
                value(0));
        case Code::command_beyond_limit:
            return fmt::format(
                "the logged command reaches {}, control.effort_limit is {}: the limit, or the unit of the "
                "command, is not that of this record; [record.files] can give another limit",
                value(0), value(1));
        default:
            return "";
    }
}

}  // namespace

bool is_suspicion(Note::Code code)
{
    return code >= Code::motor_off && code <= Code::magnitude_only;
}

std::string suspicion_text(const Note& note)
{
    auto text = of_signals(note);
    if (text.empty()) text = of_joint(note);
    if (text.empty()) throw std::logic_error("no suspicion: " + std::string(name_of(note.code)));
    return text;
}

}  // namespace stickslip
