// What a diagnosis remarks, and why it answers as it does: a code with its names and numbers. Behaviour depends on the
// code and never on a sentence; sentences are composed from it in sweep/words (note_text).
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

struct Note {
    /// Behind each code what it carries beside `record`; values are in SI units, shares are parts of one.
    enum class Code {
        // of those who read the files
        told,       ///< `text`, as it came
        motor_off,  ///< values: rows without torque, all rows
        // what no record of this joint can hold: two things that were given cannot both be in their units, and nothing
        // was concluded. Names are of signals; "position_rate" is what position changes by in a second
        unit_between_signals,    ///< names: the unit that is suspected, what moves farther, beside what; values: factor
        unit_by_gains,           ///< names: the unit that is suspected; values: what the gains make of the motion, in
                                 ///< parts of the logged command
        sign_by_gains,           ///< the gains ask for the opposite of the logged command
        gains_of_another_joint,  ///< values: the same parts, which no unit makes
        opposite_signs,          ///< names: what runs against what
        unit_of_rate,            ///< names: what is in another unit than what; values: factor
        unit_of_effort,          ///< values: the measured effort varies by so much of what the command asks for
        dead_signal,             ///< names: what stays while the position moves; values: where
        unit_by_travel,          ///< names: the unit that is suspected, its sign, that of the joint; values: travel
        unit_of_clock,           ///< names: the unit that is suspected, if any; values: s between rows, control.period
        slow_clock,              ///< values: s between rows
        duty_above_one,          ///< values: the most
        command_beyond_limit,    ///< values: the most, the limit
        unsigned_numbers,        ///< names: the signal; values: both ends of the gap, the most, bits, what to take off
        magnitude_only,          ///< names: the effort that has lost its sign
        // what a record holds
        too_few_rows,        ///< values: rows, how many are needed
        position_still,      ///< the position does not change beyond its noise
        nothing_drives,      ///< neither a command nor a reference was logged
        uneven_ticks,        ///< values: periods of the loop between two rows, no whole number
        no_command,          ///< the command is computed from the reference
        driven_by_effort,    ///< neither a command nor a reference: the measured effort drives the joint
        another_controller,  ///< the measured effort does; values: part of its squares that the documented structure
                             ///< leaves at any gains, that a PID leaves, and its k_p, k_v, k_i
        no_such_controller,  ///< values: that part; none is named
        no_effort,           ///< no effort was measured
        holes,               ///< values: holes in time, start and end of the first
        rows_missing,        ///< what happened in them is simulated
        irregular_rows,      ///< every row is used at its own time
        rebuilt_ticks,       ///< logged at every second tick
        slow_log,            ///< logged slower than the loop
        scattered_stamps,    ///< about the documented period
        starts_moving,       ///< cut from a longer record
        straight_commands,   ///< of a continuous loop: not held between rows
        // its noise
        noisier_than_documented,  ///< the floor is estimated
        no_documented_noise,      ///< the floor is estimated
        no_documented_effort_noise,
        noise_of_noisiest,  ///< the steps of the encoder hide the record's own
        // how data are held out
        held_out_in_turn,    ///< every record
        thirds_in_turn,      ///< of the only record
        rest_held_out,       ///< of long records; values: rows that were fitted, all rows, stretches that hold them
        cause_almost_alone,  ///< shown by this record: its thirds are held out
        // the audit of the controller
        another_joint,          ///< names and values: numbers that differ from the document; nothing was concluded
        command_unknown,        ///< values: misfit; no change of the controller's terms reproduces the command
        gains_not_judged,       ///< values: misfit
        terms_to,               ///< values: per cent of the command's rms that is left; smaller terms are not named
        gains_to,               ///< values: per cent that is left; only gains that are further off are named
        gains_to_steps,         ///< values: per cent beyond which a gain is named, for the steps of the command
        reference_late,         ///< values: control periods, s; the reference was logged that late, and is shifted
        reference_early,        ///< the same, early
        positions_scaled,       ///< values: logged over the controller's; positions and velocities are divided by it
        reference_rebuilt,      ///< from the command, gains from the encoder's noise
        controller_unseen,      ///< more than k_p and k_v, and no reference was logged
        undocumented_k_v,       ///< the command has a part that is proportional to the velocity
        filter_as_exponential,  ///< values: the filter's time constant that was found, the documented one; the
                                ///< documented one discretised as 1 - exp(-T/tau) is the same filter
        filter_of_two_poles,    ///< values: the delay of the velocity filter that ran, s
        sample_of_integral,     ///< names: key of a gain; values: what it is in the file's meaning, part of the present
                                ///< sample that the controller's integral does not count
        // the verdict
        within_noise,             ///< the nominal joint predicts every record to the noise
        nothing_would_show,       ///< no effect of usual size, under this excitation
        controller_and_rest,      ///< the controller differs; something outside the catalogue remains
        controller_and_numbers,   ///< the controller differs; with the numbers corrected nothing remains
        numbers_to_noise,         ///< names: corrected, the joint predicts every record to the noise
        numbers_and_rest,         ///< names: no effect takes a good part of what their correction leaves
        cause_to_noise,           ///< names: beside the corrections
        cause_predicts_best,      ///< names: not to the noise
        unexplained,              ///< values: what the best of the catalogue leaves
        free_force,               ///< signal: a force of it, of no catalogue; values: what it would take
        nothing_earns,            ///< no cause takes a part of the gap on unseen data beside the corrections
        earns_implausible,        ///< names: would reduce it with a number at its bound, or outside what is physical
        takes_too_little,         ///< names come nearest; values: what they take, what is explainable
        nearer_force,             ///< names come nearest, but a force of `signal` is clearly better
        force_beside_numbers,     ///< numbers are off, but a force of `signal` takes `values` of the gap besides
        force_in_the_rest,        ///< names come nearest, but a force of `signal` explains what they leave
        rejected_worse,           ///< names fit best, but make held-out data worse
        rejected_leaves_most,     ///< names: of the gap on held-out data
        rejected_implausible,     ///< names: more than noise is left, and a number is at its bound
        rejected_less_likely,     ///< names: than no cause of the catalogue; values: that probability
        rejected_in_many_floors,  ///< names; values: noise floors that remain; the noise is not documented
        doubted_above_noise,      ///< names, which may not act alone; values: noise floors that remain
        doubted_as_a_whole,  ///< names; values: what they explain of whole records, simulated, and noise floors that
                             ///< remain
        adds_up,             ///< values: noise floors that whole records keep where rows are within the noise
        far_as_a_whole,      ///< values: noise floors by which the nominal joint misses where rows are within the noise
        interrupted_early,   ///< names: codes of the stage and those left out; nothing was found yet
        interrupted_located,  ///< names: codes of the stage and those left out; where the gap lies was found
        // friction rigs
        rig,
        rig_turns_round,  ///< values: first and last row of what is judged
        rig_blocks_in_turn,
        rig_still,            ///< displacement or friction does not change
        rig_laws_alike,       ///< names: the cause, and the laws of it
        rig_level_suffices,   ///< within the noise
        rig_no_law_predicts,  ///< better than a constant level
        // tables of outcomes
        fifths_in_turn,
        same_settings,       ///< values: lines with both outcomes
        too_few_outcomes,    ///< values: rows, those with stick-slip, rows and rows of either that are needed
        rows_contradict,     ///< values: rows that contradict others, all rows
        nominal_explains,    ///< as well as any law
        best_law_misjudges,  ///< names: the law; values: rows that it misjudges, all rows
        laws_alike,          ///< names: two laws of one effect
        kinds_alike,         ///< values: kinds of friction that explain the rows
        beyond_linear        ///< values: rows where a start from rest goes another way than a small disturbance
    };
    static constexpr int number_of_codes = static_cast<int>(Code::beyond_linear) + 1;

    Code code = Code::told;
    std::string record{};  ///< that it is about; empty: all
    std::vector<std::string> names{};
    std::string signal{};  ///< "position" | "velocity" | "hysteresis" | …
    std::vector<double> values{};
    std::string text{};  ///< of those who read the files alone

    bool operator==(const Note&) const = default;
};

/// "too-few-rows": the code in files, stable where sentences are not.
std::string_view name_of(Note::Code code);

/// Record and joint do not fit together: nothing was concluded.
inline bool contradicts(const Note& note)
{
    const bool of_signals = note.code >= Note::Code::unit_between_signals && note.code <= Note::Code::magnitude_only;
    return of_signals || note.code == Note::Code::another_joint;
}

}  // namespace stickslip
