// In one file: the sentence of every code of a diagnosis, as one table, and what its places are filled with.
#include "sweep/words/diagnosis_text.h"

#include "analysis/diagnosis/policy/outcomes_and_rigs.h"
#include "analysis/diagnosis/policy/page_and_plan.h"
#include "analysis/diagnosis/policy/verdict.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/effect_words.h"
#include "sweep/words/stage_text.h"
#include "sweep/words/suspicion_text.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <stdexcept>

namespace stickslip {
namespace {

using Code = Note::Code;

/// {0}, {1} … are the note's values, {share0}, {share1} the first two as per cent, {name0} … its names, {names} all of
/// them as one cause, {lines} all values in a row, {numbers} every name with its value, {s} the plural of {0}.
struct Sentence {
    Code code;
    const char* words;
};

// the numbers that stand as words below
static_assert(gap::policy::shown == 5 && gap::policy::implausible_size == 10 && gap::policy::rows_of_rig_block == 20);

constexpr Sentence sentences[] = {
    {Code::told, "{text}"},
    {Code::too_few_rows, "{0:.0f} rows; at least {1:.0f} are needed"},
    {Code::position_still, "the position does not change beyond its noise"},
    {Code::nothing_drives, "neither a command nor a reference was logged: the input of the joint is unknown"},
    {Code::uneven_ticks,
     "rows are {0:.3g} periods of the loop apart, no whole number of them: every row is used as a tick"},
    {Code::no_command,
     "no command was logged; it is computed from the reference, the measured motion and the documented controller, so "
     "that the controller itself cannot be audited"},
    {Code::driven_by_effort,
     "neither a command nor a reference was logged: the measured effort drives the simulated joint, and the controller "
     "takes no part"},
    {Code::another_controller,
     "the documented controller does not make the measured effort: with any gains it leaves {share0} of its squares, a "
     "PID with k_p = {2:.4g}, k_v = {3:.4g}, k_i = {4:.4g} leaves {share1}. The measured effort drives the simulated "
     "joint"},
    {Code::no_such_controller,
     "another controller than the documented one made the measured effort ({share0} of its squares remain at any "
     "gains), and none is named; causes in the mechanism were sought with the measured effort as the drive"},
    {Code::no_effort,
     "no effort was measured: inertia, gain and torque constant can be distinguished by friction and load only"},
    {Code::holes,
     "{0:.0f} hole{s} in time, the first from {1:.6g} s to {2:.6g} s: the rows after a hole are a separate record"},
    {Code::rows_missing, "rows are missing; they are simulated, not judged"},
    {Code::irregular_rows, "irregular sampling; every row is used at its own time"},
    {Code::rebuilt_ticks, "logged at every second tick; the ticks between were rebuilt from the velocity"},
    {Code::slow_log, "logged slower than the loop; readings between rows are interpolated"},
    {Code::scattered_stamps, "the time stamps scatter about the documented period; evenly spaced ticks are used"},
    {Code::starts_moving, "starts in motion; at_rest_at_start under [record] overrides this"},
    {Code::straight_commands, "commands go straight from row to row here, not held: the loop is continuous"},
    {Code::noisier_than_documented,
     "the readings are noisier than documented; the noise floor is estimated from third differences"},
    {Code::no_documented_noise, "no documented noise; the noise floor is estimated from third differences"},
    {Code::no_documented_effort_noise, "no documented effort noise; estimated from third differences"},
    {Code::noise_of_noisiest,
     "little noise shows behind the steps of the encoder; the noise floor is that of the noisiest record"},
    {Code::held_out_in_turn, "every record is held out in turn and predicted from a fit to the others"},
    {Code::thirds_in_turn, "one record: its three thirds are held out in turn"},
    {Code::rest_held_out, "{0:.0f} of {1:.0f} rows are fitted, in {2:.0f} stretches; the gap is that of all others"},
    {Code::cause_almost_alone, "shows the cause almost alone; its thirds are held out in turn"},
    {Code::another_joint,
     "suspected record of another joint: encoder and controller differ from the joint file in {count} ways "
     "({numbers}); if it is this joint, correct the file first"},
    {Code::command_unknown,
     "the documented controller does not reproduce the logged command (misfit {0:.3g} of its rms), nor does any change "
     "of its terms: none is named"},
    {Code::gains_not_judged,
     "the documented controller does not reproduce the logged command (misfit {0:.3g} of its rms): gains were not "
     "audited"},
    {Code::terms_to,
     "the controller reproduces the logged command to {0:.3g} % of its rms: terms that are smaller are not named"},
    {Code::gains_to,
     "the controller reproduces the logged command to {0:.3g} % of its rms: only gains that are further off are named"},
    {Code::gains_to_steps,
     "the controller reproduces the logged command to the steps in which it is given: only gains that are off by more "
     "than {0:.3g} % are named"},
    {Code::controller_unseen,
     "no reference was logged: nothing is said of a controller that is more than k_p and k_v; the joint is judged "
     "under "
     "its logged command"},
    {Code::reference_late,
     "the logged command is that of the reference {0:.0f} control periods ({1:.4g} s) later: it was shifted. "
     "The log's reference is late, or the controller has feed-forward of that size"},
    {Code::reference_early,
     "the logged command is that of the reference {0:.0f} control periods ({1:.4g} s) earlier: it was shifted. "
     "The log's reference is early, or the controller uses one that is as old"},
    {Code::positions_scaled,
     "the logged command is that of positions and velocities divided by {0:.5g}: log and controller convert them "
     "differently (a gear ratio?), and the controller's are used"},
    {Code::reference_rebuilt,
     "no reference was logged: the controller's gains were read from how the encoder's noise comes through it, and the "
     "reference was rebuilt from the command"},
    {Code::undocumented_k_v, "the joint file has no k_v; the command has a part proportional to the velocity"},
    {Code::filter_as_exponential,
     "the velocity filter that was found is the documented one of {1:.4g} s in a controller that computes it with "
     "1 - exp(-T/tau) instead of T/(tau + T): nothing is wrong with the machine; with control.velocity_estimate.tau = "
     "{0:.4g} the "
     "joint file means this filter"},
    {Code::filter_of_two_poles,
     "the commands are made of the logged velocities, and these come out of a filter of another shape; a filter of one "
     "pole with its delay of {0:.3g} s, which the joint file can say, is near it"},
    {Code::sample_of_integral,
     "the controller's integral counts {share1} of the present sample less than the joint file means (forward Euler "
     "counts none of it, the trapezoidal rule half): nothing is wrong with the machine; with {names} = {0:.6g} the "
     "joint file means this controller"},
    {Code::within_noise, "the nominal joint predicts every record to within noise"},
    {Code::nothing_would_show, "under this excitation no effect of usual size exceeds five times the noise"},
    {Code::controller_and_rest,
     "the controller differs from the joint file, and a remainder exists that the catalogue does not explain"},
    {Code::controller_and_numbers,
     "the controller differs from the joint file; with parameters corrected as well, the joint predicts held-out rows "
     "to within noise"},
    {Code::numbers_to_noise,
     "parameters of the joint file are off: {names}; with corrected values the joint predicts held-out rows to within "
     "noise"},
    {Code::numbers_and_rest,
     "parameters of the joint file are off: {names}; no effect explains a large part of what their correction leaves"},
    {Code::cause_to_noise,
     "with corrected parameters of the joint file, {names} predicts held-out rows to within noise"},
    {Code::cause_predicts_best,
     "no cause explains the gap to within noise; with inertia, friction and load corrected within their uncertainty in "
     "every comparison, {names} predicts held-out data best"},
    {Code::unexplained,
     "there is a gap, and no effect or pair of the catalogue explains it: the best leaves {share0} of it"},
    {Code::free_force, "{force} would explain {share0} of it"},
    {Code::nothing_earns, "no cause reduces the gap on held-out data, with inertia, friction and load refitted"},
    {Code::earns_implausible,
     "{names} comes nearest, but only with a parameter at its bound or outside its physical range: it is not named as "
     "the cause"},
    {Code::takes_too_little,
     "{names} comes nearest, but explains only {share0} of what corrected parameters leave, of which {share1} is "
     "explainable"},
    {Code::nearer_force,
     "{names} comes nearest, but {force} explains the records clearly better, and has the shape of no effect of the "
     "catalogue"},
    {Code::force_beside_numbers,
     "parameters of the joint file are off, but {force} takes {share0} of the gap in addition to their correction, and "
     "has "
     "the shape of no effect of the catalogue"},
    {Code::force_in_the_rest,
     "{names} comes nearest, but a force that depends on the {signal} alone, in the shape of no effect of the "
     "catalogue, explains what it leaves"},
    {Code::rejected_worse,
     "{names} predicts unseen rows best, but makes the simulation of whole records worse: it is not the named cause"},
    {Code::rejected_less_likely,
     "{names} comes nearest, but it is likelier ({share0}) that no cause of the catalogue is the answer: none is "
     "named"},
    {Code::rejected_leaves_most,
     "{names} fits best, but leaves most of the gap on held-out data: it is not named as the cause"},
    {Code::rejected_implausible,
     "{names} fits best, but leaves more than noise and needs a parameter at its bound or ten times the usual size: it "
     "is not named as the cause"},
    {Code::rejected_in_many_floors,
     "{names} fits best, but leaves {0:.1f} times the noise floor on held-out data, and the joint file states no "
     "sensor noise: it is not named as the cause"},
    {Code::doubted_above_noise,
     "{names} leaves {0:.1f} times the documented noise on held-out data: another effect probably acts as well, or in "
     "its "
     "place"},
    {Code::doubted_as_a_whole,
     "{names} predicts held-out rows, but simulations of whole records explain only {share0} of the gap and leave "
     "{1:.1f} times the noise floor: another cause is as likely"},
    {Code::adds_up,
     "simulated as a whole along their references, the records stay {0:.2g} times the noise floor away: what is too "
     "small to see from row to row adds up"},
    {Code::far_as_a_whole,
     "predicted from row to row the nominal joint stays within the noise, but simulated as a whole along its reference "
     "it is {0:.1f} times the noise floor away: reference or controller are not what file and log say, or the rows are "
     "too few or too far apart to determine the cause"},
    {Code::interrupted_early, "interrupted while {stages}: no result yet"},
    {Code::interrupted_located,
     "interrupted while {stages}: the location of the gap was found, its cause was not; fits that were finished are "
     "listed"},
    {Code::rig,
     "a friction rig: a load point's displacement and the friction; the stiffness between load point and slider and "
     "the level of the friction are fitted for every law"},
    {Code::rig_turns_round,
     "the load point reverses; the longest stretch in one direction, rows {0:.0f} to {1:.0f}, is judged"},
    {Code::rig_blocks_in_turn, "one record: blocks of 20 rows are held out, a third of them in turn"},
    {Code::rig_still, "displacement or friction does not change"},
    {Code::rig_laws_alike, "the law of {effect0} is ambiguous: these data cannot distinguish {laws}"},
    {Code::rig_level_suffices, "a constant level predicts the held-out rows to the noise"},
    {Code::rig_no_law_predicts,
     "no law that the program knows predicts the held-out rows better than a constant level"},
    {Code::fifths_in_turn, "every fifth of the rows is held out in turn and predicted from a fit to the others"},
    {Code::same_settings, "lines {lines} have the same settings and both outcomes"},
    {Code::too_few_outcomes,
     "{0:.0f} rows, {1:.0f} of them with stick-slip; a boundary needs at least {2:.0f} rows, {3:.0f} on either side"},
    {Code::rows_contradict,
     "{0:.0f} of {1:.0f} rows contradict others with the same settings: the table lacks a setting that decides the "
     "outcome"},
    {Code::nominal_explains, "the nominal joint explains the rows as well as any law fitted to them"},
    {Code::best_law_misjudges, "the best law, {name0}, misjudges {0:.0f} of {1:.0f} rows that its fit had not seen"},
    {Code::laws_alike, "the law is ambiguous: these rows cannot distinguish {name0} from {name1}"},
    {Code::kinds_alike,
     "{0:.0f} kinds of friction explain these rows: they lie on one side of what distinguishes the laws"},
    {Code::beyond_linear,
     "{0:.0f} rows lie where small disturbances die out and a start from rest does not, or the reverse; the motion "
     "from rest counts"},
};

/// "a force that depends on the position alone"
std::string force_of(const std::string& signal)
{
    if (signal == "hysteresis")
        return "a force that depends on where the position turned (hysteresis), and so differs on the way back,";
    if (signal == "inertia") return "an inertia that changes in the course of a record";
    return "a force that depends on the " + signal + " alone";
}

/// "the slip law, the time law and the ageing law", of a note whose first name is the cause.
std::string laws_of(const Note& note)
{
    std::string text;
    for (std::size_t i = 1; i < note.names.size(); ++i)
        text += (i == 1 ? "" : i + 1 == note.names.size() ? " and " : ", ") + ("the " + note.names[i]) + " law";
    return text;
}

std::string numbers_of(const Note& note)
{
    std::vector<std::string> each;
    for (std::size_t i = 0; i < std::min(note.names.size(), note.values.size()); ++i)
        each.push_back(fmt::format("{} = {:.4g}", note.names[i], note.values[i]));
    return fmt::format("{}", fmt::join(each, ", "));
}

/// What a sentence may say of a note. A note that lacks what its sentence says is an error, as in any other format.
fmt::dynamic_format_arg_store<fmt::format_context> parts_of(const Note& note)
{
    fmt::dynamic_format_arg_store<fmt::format_context> parts;
    for (const double value : note.values) parts.push_back(value);
    for (std::size_t i = 0; i < note.values.size(); ++i)
        parts.push_back(fmt::arg(fmt::format("share{}", i).c_str(), whole_percent(note.values[i])));
    for (std::size_t i = 0; i < note.names.size(); ++i)
        parts.push_back(fmt::arg(fmt::format("name{}", i).c_str(), note.names[i]));
    if (!note.names.empty()) parts.push_back(fmt::arg("effect0", effect_words(note.names[0])));
    parts.push_back(fmt::arg("names", together(note.names)));
    parts.push_back(fmt::arg("laws", laws_of(note)));
    parts.push_back(fmt::arg("count", note.names.size()));
    parts.push_back(fmt::arg("numbers", numbers_of(note)));
    parts.push_back(fmt::arg("lines", fmt::format("{:.0f}", fmt::join(note.values, ", "))));
    parts.push_back(fmt::arg("s", note.values.empty() || note.values[0] != 1 ? "s" : ""));
    parts.push_back(fmt::arg("signal", note.signal));
    parts.push_back(fmt::arg("force", force_of(note.signal)));
    parts.push_back(fmt::arg("stages", stages_text(note.names)));
    parts.push_back(fmt::arg("text", note.text));
    return parts;
}

}  // namespace

std::string remark_text(const Note& note)
{
    if (is_suspicion(note.code)) return suspicion_text(note);
    const auto* found = std::ranges::find(sentences, note.code, &Sentence::code);
    if (found == std::end(sentences))
        throw std::logic_error("no words for the note " + std::string(name_of(note.code)));
    return fmt::vformat(found->words, parts_of(note));
}

std::string note_text(const Note& note)
{
    return note.record.empty() ? remark_text(note) : note.record + ": " + remark_text(note);
}

std::string note_sentence(const Note& note)
{
    std::string text = note_text(note);
    const auto first = text.substr(0, text.find(' '));
    const bool plain = std::all_of(first.begin(), first.end(), [](unsigned char c) { return std::islower(c); });
    if (plain) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
}

}  // namespace stickslip
