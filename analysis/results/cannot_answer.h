// A joint, a record or a table that a question cannot be answered with.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip {

/// Thrown before a diagnosis or a plan begins. Its code and its numbers say what is wrong; sentences are composed from
/// them in sweep/words (refusal_text).
class CannotAnswer : public std::invalid_argument {
  public:
    /// Behind each code what it carries beside `about`.
    enum class Why {
        // records of a joint
        no_record,
        force_loop,      ///< records are simulated under position control
        contact_spring,  ///< and without a spring between link and surroundings
        many_bodies,     ///< and with one mass or two
        no_parameter,    ///< name: the path that a record overrides
        // a record's columns
        no_time,
        no_position,
        column_length,         ///< name: the column; values: its length, that of time
        not_finite,            ///< name: the column; values: the row, from 1
        inertia_not_positive,  ///< values: the row
        time_repeats,          ///< values: the row, its time
        time_runs_back,        ///< values: the row, its time
        // a table of outcomes
        table_of_many_bodies,  ///< it is read against one mass
        table_of_two_springs,  ///< and against one spring
        no_number,             ///< name: the path that the table sets
        no_velocity,           ///< neither in the row nor in the joint
        no_stiffness,          ///< of the row
        // a plan
        no_period,
        no_position_gain,
        few_rows,     ///< of a motion: it needs two
        no_noise,     ///< without noise every effect shows
        short_motion  ///< values: periods of the loop that are needed
    };

    CannotAnswer(Why reason, std::string of_which, std::string of_name = {}, std::vector<double> numbers = {})
        : std::invalid_argument(of_which + (of_which.empty() ? "" : ": ") + std::string(name_of(reason)) +
                                (of_name.empty() ? "" : " " + of_name)),
          why(reason),
          about(std::move(of_which)),
          name(std::move(of_name)),
          values(std::move(numbers))
    {
    }

    Why why;                     ///< the code of the reason
    std::string about;           ///< the record, the table or its row; empty: the joint
    std::string name;            ///< of the column or the path that the reason is about; empty where it has none
    std::vector<double> values;  ///< numbers of the reason, as listed at its code

    /// "force-loop": what what() holds for a program, after `about`.
    static std::string_view name_of(Why why);
};

}  // namespace stickslip
