// The fields of plain results, each once: axes, curves, points, margins. See answer_fields.h.
#pragma once
#include "sweep/files/json/answer_names.h"
#include "sweep/study/sweep_answer.h"

namespace stickslip {

using archive::Like;

template <class A>
void fields(A& a, Like<Axis> auto& v)
{
    a("path", v.path), a("symbol", v.symbol), a("name", v.name), a("quantity", v.quantity), a("log", v.log);
    a("values", v.values);
}

template <class A>
void fields(A& a, Like<Curve> auto& v)
{
    a("kind", v.kind), a("x", v.x), a("y", v.y), a("precision", v.precision);
}

template <class A>
void fields(A& a, Like<DesignPoint> auto& v)
{
    a("x", v.x), a("y", v.y), a("inside", v.inside), a("region", v.region);
    a("spectral_abscissa", v.spectral_abscissa);
}

template <class A>
void fields(A& a, Like<MapMotion> auto& v)
{
    a("x", v.x), a("y", v.y), a("time", v.time), a("velocity", v.velocity);
}

template <class A>
void fields(A& a, Like<BoundaryPoint> auto& v)
{
    a("value", v.value), a("low", v.low), a("high", v.high), a("direction", v.direction);
    a("converged", v.converged), a("evaluations", v.evaluations), a("method", v.method);
}

template <class A>
void fields(A& a, Like<Margin> auto& v)
{
    a("axis", v.axis), a("value", v.value), a("found", v.found), a("boundary", v.boundary);
    a("low", v.low), a("high", v.high);
}

template <class A>
void fields(A& a, Like<NearestMove> auto& v)
{
    a("path", v.path), a("less", v.less), a("from", v.from), a("to", v.to);
}

template <class A>
void fields(A& a, Like<NearestBoundary> auto& v)
{
    a("decided", v.decided), a("stable", v.stable), a("found", v.found), a("distance", v.distance);
    a("moves", v.moves), a("direction", v.direction), a("evaluations", v.evaluations);
}

}  // namespace stickslip
