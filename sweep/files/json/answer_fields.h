// The fields of every struct of an answer, each once: what answer.json says and how it is read back. Here those of a
// sweep; those of one joint and of plain results in the headers below.
#pragma once
#include "sweep/files/json/joint_answer_fields.h"

namespace stickslip {

template <class A>
void fields(A& a, Like<Extent> auto& v)
{
    a("low", v.low), a("high", v.high);
}

template <class A>
void fields(A& a, Like<FoldReach> auto& v)
{
    a("ratio", v.ratio), a("k_p", v.k_p), a("k_cr", v.k_cr), a("at", v.at);
}

template <class A>
void fields(A& a, Like<LargeDisturbances> auto& v)
{
    a("bistable", v.bistable), a("of_linearly_stable", v.of_linearly_stable), a("x", v.x), a("y", v.y);
    a("folds", v.folds), a("reach", v.reach), a("without_boundary", v.without_boundary);
}

template <class A>
void fields(A& a, Like<ReducedModel> auto& v)
{
    a("model", v.model), a("assumption", v.assumption), a("boundary", v.boundary);
    a("wrong_stable", v.wrong_stable), a("wrong_unstable", v.wrong_unstable);
}

template <class A>
void fields(A& a, Like<ReducedMap> auto& v)
{
    a("full", v.full), a("models", v.models), a("columns", v.columns), a("rows", v.rows);
}

template <class A>
void fields(A& a, Like<MapAnswer> auto& v)
{
    a("curves", v.curves), a("layer_curves", v.layer_curves), a("precision", v.precision), a("mesh", v.mesh);
    a("design", v.design), a("motions", v.motions), a("large", v.large), a("reduced", v.reduced);
}

template <class A>
void fields(A& a, Like<PanelsAnswer> auto& v)
{
    a("curves", v.curves), a("design", v.design);
}

template <class A>
void fields(A& a, Like<ProfileAnswer> auto& v)
{
    a("velocity_only_abscissa", v.velocity_only_abscissa), a("memory", v.memory);
    a("velocity_only", v.velocity_only);
}

template <class A>
void fields(A& a, Like<GainSurface> auto& v)
{
    a("x", v.x), a("y", v.y), a("k_cr", v.k_cr), a("always", v.always), a("never", v.never), a("windows", v.windows);
}

template <class A>
void fields(A& a, Like<LeftOut> auto& v)
{
    a("loop", v.loop), a("growth", v.growth);
}

template <class A>
void fields(A& a, Like<IdleAxis> auto& v)
{
    a("path", v.path), a("why", v.why), a("matters", v.matters);
}

template <class A>
void fields(A& a, Like<SweepAnswer> auto& v)
{
    a("plan_id", v.plan_id), a("spec", v.spec), a("design", v.design), a("margins", v.margins), a("maps", v.maps);
    a("panels", v.panels), a("profiles", v.profiles), a("surfaces", v.surfaces);
    a("left_out", v.left_out), a("idle", v.idle);
}

}  // namespace stickslip
