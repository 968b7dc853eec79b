// The fields of the answer about one joint, each once. See answer_fields.h.
#pragma once
#include "sweep/files/json/plain_fields.h"

namespace stickslip {

template <class A>
void fields(A& a, Like<Interval> auto& v)
{
    a("low", v.low), a("high", v.high);
}

template <class A>
void fields(A& a, Like<SteadySliding> auto& v)
{
    a("velocity", v.velocity), a("slides_at", v.slides_at), a("friction", v.friction);
    a("deflection", v.deflection), a("reason", v.reason);
}

template <class A>
void fields(A& a, Like<VelocityOnlyVerdict> auto& v)
{
    a("stable", v.stable), a("neutral", v.neutral), a("k_v_min", v.k_v_min), a("stable_k_v", v.stable_k_v);
    a("slope", v.slope);
}

template <class A>
void fields(A& a, Like<Crossing> auto& v)
{
    a("k_p", v.k_p), a("omega", v.omega), a("direction", v.direction);
}

template <class A>
void fields(A& a, Like<StateVariableVerdict> auto& v)
{
    a("stable", v.stable), a("neutral", v.neutral), a("spectral_abscissa", v.spectral_abscissa);
    a("eigenvalues", v.eigenvalues), a("multipliers", v.multipliers), a("all_eigenvalues", v.all_eigenvalues);
    a("f_v", v.f_v), a("kernel_integral", v.kernel_integral), a("gain_margin_db", v.gain_margin_db);
    a("phase_margin_deg", v.phase_margin_deg), a("crossings", v.crossings);
    a("stable_intervals", v.stable_intervals), a("k_cr", v.k_cr), a("searched_from", v.searched_from),
        a("searched_to", v.searched_to);
    a("doubtful", v.doubtful);
}

template <class A>
void fields(A& a, Like<UnusedTerm> auto& v)
{
    a("key", v.key), a("why", v.why), a("matters", v.matters);
}

template <class A>
void fields(A& a, Like<GearSide> auto& v)
{
    a("ratio", v.ratio), a("gain", v.gain);
}

template <class A>
void fields(A& a, Like<LoopUse> auto& v)
{
    a("kind", v.kind), a("used", v.used), a("not_used", v.not_used), a("gear", v.gear);
}

template <class A>
void fields(A& a, Like<LinearVerdict> auto& v)
{
    a("steady", v.steady), a("velocity_only", v.velocity_only), a("state_variable", v.state_variable);
    a("loop", v.loop);
}

template <class A>
void fields(A& a, Like<Disturbance> auto& v)
{
    a("kind", v.kind), a("size", v.size);
}

template <class A>
void fields(A& a, Like<NonlinearVerdict> auto& v)
{
    a("outcome", v.outcome), a("region", v.region), a("disturbance", v.disturbance);
    a("growth_rate", v.growth_rate), a("amplitude", v.amplitude), a("jitter", v.jitter);
    a("noise_suffices", v.noise_suffices), a("held_places", v.held_places), a("places_alike", v.places_alike);
    a("velocity_min", v.velocity_min);
    a("velocity_max", v.velocity_max), a("period", v.period), a("stick_fraction", v.stick_fraction);
    a("overshoot", v.overshoot), a("multipliers", v.multipliers), a("repeats", v.repeats);
    a("criticality", v.criticality), a("lyapunov", v.lyapunov), a("fold_k_p", v.fold_k_p), a("path", v.path);
    a("reason", v.reason), a("explanation", v.detail), a("growth_missing", v.growth_missing);
    a("fold_missing", v.fold_missing), a("searched_from", v.searched_from), a("used_fallback", v.used_fallback);
}

template <class A>
void fields(A& a, Like<StableVelocities> auto& v)
{
    a("intervals", v.intervals), a("least", v.least), a("all_above", v.all_above);
    a("least_force_rate", v.least_force_rate);
}

template <class A>
void fields(A& a, Like<RangeGain> auto& v)
{
    a("k_v", v.k_v), a("velocity", v.velocity), a("stable_k_v", v.stable_k_v);
}

template <class A>
void fields(A& a, Like<Comparison> auto& v)
{
    a("k_v_velocity_only", v.k_v_velocity_only), a("k_v_memory", v.k_v_memory);
    a("k_p_velocity_only", v.k_p_velocity_only), a("k_p_memory", v.k_p_memory);
    a("forbidden_needlessly", v.forbidden_needlessly), a("allowed_wrongly", v.allowed_wrongly);
    a("searched_to", v.searched_to), a("known", v.known);
}

template <class A>
void fields(A& a, Like<ResponsePeak> auto& v)
{
    a("omega", v.omega), a("magnitude", v.magnitude);
}

template <class A>
void fields(A& a, Like<LoopMargins> auto& v)
{
    a("gain_below", v.gain_below), a("gain_above", v.gain_above), a("phase", v.phase), a("crossover", v.crossover);
}

template <class A>
void fields(A& a, Like<GainMix> auto& v)
{
    a("k_p", v.k_p), a("k_v", v.k_v), a("noise", v.noise);
}

template <class A>
void fields(A& a, Like<ForceRamp> auto& v)
{
    a("rate", v.rate), a("velocity_only", v.velocity_only), a("state_variable", v.state_variable);
}

template <class A>
void fields(A& a, Like<ReductionError> auto& v)
{
    a("full", v.full), a("reduced", v.reduced), a("error", v.error);
}

template <class A>
void fields(A& a, Like<ReductionStudy> auto& v)
{
    a("name", v.name), a("model", v.model), a("neglected", v.neglected), a("refused", v.refused);
    a("unsearched", v.unsearched);
    a("boundary_path", v.boundary_path), a("assumption_path", v.assumption_path), a("assumption", v.assumption);
    a("own", v.own), a("searched_low", v.searched_low), a("searched_high", v.searched_high);
    a("values", v.values), a("at", v.at), a("good_from", v.good_from), a("fair_from", v.fair_from);
}

template <class A>
void fields(A& a, Like<LinearStudy> auto& v)
{
    a("compliance", v.compliance), a("peak", v.peak), a("margins", v.margins), a("velocities", v.velocities);
    a("velocity_only", v.velocity_only), a("state_variable", v.state_variable), a("range_gain", v.range_gain);
    a("comparison", v.comparison), a("velocity_noise", v.velocity_noise), a("mix", v.mix), a("ramp", v.ramp);
    a("velocities_looked_at", v.velocities_looked_at), a("mix_searched", v.mix_searched);
    a("reductions", v.reductions);
}

template <class A>
void fields(A& a, Like<Samples> auto& v)
{
    a("x", v.x), a("y", v.y);
}

template <class A>
void fields(A& a, Like<LeastVelocities> auto& v)
{
    a("k_v", v.k_v), a("over_k_p", v.over_k_p), a("here", v.here);
}

template <class A>
void fields(A& a, Like<RampSprings> auto& v)
{
    a("above", v.above), a("below", v.below), a("here", v.here);
}

template <class A>
void fields(A& a, Like<LinearDetails> auto& v)
{
    a("study", v.study), a("velocity", v.velocity), a("sampled_finely", v.sampled_finely);
    a("demanded_memory", v.demanded_memory), a("demanded_simple", v.demanded_simple);
    a("least_velocities", v.least_velocities), a("response_memory", v.response_memory);
    a("response_simple", v.response_simple), a("ramp_rate", v.ramp_rate), a("ramps", v.ramps);
}

template <class A>
void fields(A& a, Like<RootLocus> auto& v)
{
    a("gains", v.gains), a("roots", v.roots), a("own_gain", v.own_gain), a("own", v.own), a("limit", v.limit),
        a("rational", v.rational);
    a("crossings", v.crossings);
}

template <class A>
void fields(A& a, Like<VelocitySearch> auto& v)
{
    a("velocity", v.velocity), a("low", v.low), a("high", v.high), a("found", v.found);
}

template <class A>
void fields(A& a, Like<JointAnswer> auto& v)
{
    a("linear", v.linear), a("nonlinear", v.nonlinear), a("region", v.region), a("slides", v.slides);
    a("nearest", v.nearest), a("velocities", v.velocities), a("ideal_gains", v.ideal_gains), a("details", v.details),
        a("locus", v.locus);
}

}  // namespace stickslip
