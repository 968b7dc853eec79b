#include "analysis/results/note.h"

#include <utility>

namespace stickslip {
namespace {

using Code = Note::Code;

constexpr std::pair<Code, std::string_view> names[] = {
    {Code::told, "told"},
    {Code::motor_off, "motor-off"},
    {Code::unit_between_signals, "unit-between-signals"},
    {Code::unit_by_gains, "unit-by-gains"},
    {Code::sign_by_gains, "sign-by-gains"},
    {Code::gains_of_another_joint, "gains-of-another-joint"},
    {Code::opposite_signs, "opposite-signs"},
    {Code::unit_of_rate, "unit-of-rate"},
    {Code::unit_of_effort, "unit-of-effort"},
    {Code::dead_signal, "dead-signal"},
    {Code::unit_by_travel, "unit-by-travel"},
    {Code::unit_of_clock, "unit-of-clock"},
    {Code::slow_clock, "slow-clock"},
    {Code::duty_above_one, "duty-above-one"},
    {Code::command_beyond_limit, "command-beyond-limit"},
    {Code::unsigned_numbers, "unsigned-numbers"},
    {Code::magnitude_only, "magnitude-only"},
    {Code::too_few_rows, "too-few-rows"},
    {Code::position_still, "position-still"},
    {Code::nothing_drives, "nothing-drives"},
    {Code::uneven_ticks, "uneven-ticks"},
    {Code::no_command, "no-command"},
    {Code::driven_by_effort, "driven-by-effort"},
    {Code::another_controller, "another-controller"},
    {Code::no_such_controller, "no-such-controller"},
    {Code::no_effort, "no-effort"},
    {Code::holes, "holes"},
    {Code::rows_missing, "rows-missing"},
    {Code::irregular_rows, "irregular-rows"},
    {Code::rebuilt_ticks, "rebuilt-ticks"},
    {Code::slow_log, "slow-log"},
    {Code::scattered_stamps, "scattered-stamps"},
    {Code::starts_moving, "starts-moving"},
    {Code::straight_commands, "straight-commands"},
    {Code::noisier_than_documented, "noisier-than-documented"},
    {Code::no_documented_noise, "no-documented-noise"},
    {Code::no_documented_effort_noise, "no-documented-effort-noise"},
    {Code::noise_of_noisiest, "noise-of-noisiest"},
    {Code::held_out_in_turn, "held-out-in-turn"},
    {Code::thirds_in_turn, "thirds-in-turn"},
    {Code::rest_held_out, "rest-held-out"},
    {Code::cause_almost_alone, "cause-almost-alone"},
    {Code::another_joint, "another-joint"},
    {Code::command_unknown, "command-unknown"},
    {Code::gains_not_judged, "gains-not-judged"},
    {Code::terms_to, "terms-to"},
    {Code::gains_to, "gains-to"},
    {Code::gains_to_steps, "gains-to-steps"},
    {Code::reference_late, "reference-late"},
    {Code::reference_early, "reference-early"},
    {Code::positions_scaled, "positions-scaled"},
    {Code::reference_rebuilt, "reference-rebuilt"},
    {Code::controller_unseen, "controller-unseen"},
    {Code::undocumented_k_v, "undocumented-k-v"},
    {Code::filter_as_exponential, "filter-as-exponential"},
    {Code::filter_of_two_poles, "filter-of-two-poles"},
    {Code::sample_of_integral, "sample-of-integral"},
    {Code::within_noise, "within-noise"},
    {Code::nothing_would_show, "nothing-would-show"},
    {Code::controller_and_rest, "controller-and-rest"},
    {Code::controller_and_numbers, "controller-and-numbers"},
    {Code::numbers_to_noise, "numbers-to-noise"},
    {Code::numbers_and_rest, "numbers-and-rest"},
    {Code::cause_to_noise, "cause-to-noise"},
    {Code::cause_predicts_best, "cause-predicts-best"},
    {Code::unexplained, "unexplained"},
    {Code::free_force, "free-force"},
    {Code::nothing_earns, "nothing-earns"},
    {Code::earns_implausible, "earns-implausible"},
    {Code::takes_too_little, "takes-too-little"},
    {Code::nearer_force, "nearer-force"},
    {Code::force_beside_numbers, "force-beside-numbers"},
    {Code::force_in_the_rest, "force-in-the-rest"},
    {Code::rejected_worse, "withdrawn-worse"},
    {Code::rejected_leaves_most, "withdrawn-leaves-most"},
    {Code::rejected_implausible, "withdrawn-implausible"},
    {Code::rejected_less_likely, "withdrawn-less-likely"},
    {Code::rejected_in_many_floors, "withdrawn-in-many-floors"},
    {Code::doubted_above_noise, "doubted-above-noise"},
    {Code::doubted_as_a_whole, "doubted-as-a-whole"},
    {Code::adds_up, "adds-up"},
    {Code::far_as_a_whole, "far-as-a-whole"},
    {Code::interrupted_early, "interrupted-early"},
    {Code::interrupted_located, "interrupted-located"},
    {Code::rig, "rig"},
    {Code::rig_turns_round, "rig-turns-round"},
    {Code::rig_blocks_in_turn, "rig-blocks-in-turn"},
    {Code::rig_still, "rig-still"},
    {Code::rig_laws_alike, "rig-laws-alike"},
    {Code::rig_level_suffices, "rig-level-suffices"},
    {Code::rig_no_law_predicts, "rig-no-law-predicts"},
    {Code::fifths_in_turn, "fifths-in-turn"},
    {Code::same_settings, "same-settings"},
    {Code::too_few_outcomes, "too-few-outcomes"},
    {Code::rows_contradict, "rows-contradict"},
    {Code::nominal_explains, "nominal-explains"},
    {Code::best_law_misjudges, "best-law-misjudges"},
    {Code::laws_alike, "laws-alike"},
    {Code::kinds_alike, "kinds-alike"},
    {Code::beyond_linear, "beyond-linear"},
};

constexpr bool in_order()
{
    int next = 0;
    for (const auto& [code, name] : names)
        if (static_cast<int>(code) != next++) return false;
    return next == Note::number_of_codes;
}
static_assert(in_order(), "every code has its name, at its place");

}  // namespace

std::string_view name_of(Note::Code code)
{
    return names[static_cast<int>(code)].second;
}

}  // namespace stickslip
