// What a sweep is to compute, validated and in SI: the joint, the axes, and what to compute at each point.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/results/disturbance.h"
#include "analysis/results/stability_map.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// The disturbance of analysis/results/disturbance.h as it stands in a file.
struct DisturbanceSpec {
    static constexpr Choice<DisturbanceKind> kinds[] = {
        {"position", DisturbanceKind::position}, {"velocity", DisturbanceKind::velocity},
        {"impulse", DisturbanceKind::impulse},   {"offset", DisturbanceKind::offset},
        {"state", DisturbanceKind::state},       {"start", DisturbanceKind::start}};
    Disturbance disturbance;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        auto& d = self.disturbance;
        visit.choice("kind", "what is disturbed", d.kind, kinds);
        const Quantity unit = d.kind == DisturbanceKind::position || d.kind == DisturbanceKind::offset
                                  ? Quantity::position
                              : d.kind == DisturbanceKind::velocity ? Quantity::velocity
                              : d.kind == DisturbanceKind::impulse  ? Quantity::impulse
                              : d.kind == DisturbanceKind::state    ? Quantity::effort
                                                                    : Quantity::number;
        visit.number({"size", unit, any_finite, Need::optional, "size; not set: small, in the slow mode"}, d.size);
    }
};

/// The nonlinear outcome at each point. Linear verdicts are always computed.
struct NonlinearSpec {
    bool enabled = false;
    DisturbanceSpec disturbance;
    double tolerance = 1e-8;
    double interpolation = 1e-4;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        constexpr Range tolerances{1e-13, 1e-2, false, false}, bounds{0, 1e-2, false, false};
        visit.flag("enabled", "simulate every point", self.enabled);
        visit.table("disturbance", "what starts the motion", self.disturbance);
        visit.number(
            {"tolerance", Quantity::number, tolerances, Need::optional, "relative tolerance of the integration"},
            self.tolerance);
        visit.number({"interpolation", Quantity::number, bounds, Need::optional,
                      "of dense maps: relative error up to which amplitude, period and the like are taken from points "
                      "around, checked by points between; 0: every point is computed"},
                     self.interpolation);
    }
};

/// The questions of `stickslip boundary SPEC` where its command line has none.
struct BoundarySpec {
    std::vector<BoundaryKind> kinds;  ///< empty: both linear theories
    std::vector<std::string> along;   ///< "PATH" or "PATH=FROM..TO", as in --along
    std::vector<std::string> over;    ///< two of the same; both empty: the axes and charts of the spec
    double guard = not_set;           ///< cells along each axis of the guarding grid
    double precision = not_set;       ///< largest relative width of the final brackets, for kinds that can be as fine

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        constexpr Range precisions{1e-12, 0.1, false, false}, cells{2, 512, false, false, true};
        visit.number({"guard", Quantity::number, cells, Need::optional, "cells along each axis of the guarding grid"},
                     self.guard);
        visit.number({"precision", Quantity::number, precisions, Need::optional, "relative bracket width"},
                     self.precision);
    }
};

/// What `stickslip check SPEC BASELINE` accepts.
struct CheckSpec {
    double tolerance = 1e-6;  ///< largest relative move of a located boundary; written into each baseline

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        constexpr Range share{0, 1, false, false};
        visit.number({"tolerance", Quantity::number, share, Need::optional, "largest relative move of a boundary"},
                     self.tolerance);
    }
};

/// Which pictures the report shows; each entry is a pair of axis paths. Empty: the report chooses.
struct ReportSpec {
    std::string title;
    std::vector<std::array<std::string, 2>> charts;
    std::vector<std::array<std::string, 2>> surfaces;
};

struct Spec {
    std::string title;
    std::string joint_file;  ///< resolved path, empty where the joint stands in the spec
    Joint joint;             ///< design values of paths that are no axis are already set in it
    std::vector<Axis> axes;  ///< in the order of the file; the last one varies fastest in the plan
    std::vector<std::pair<std::string, double>>
        design;  ///< the marked point: one value an axis, in the order of the axes
    NonlinearSpec nonlinear;
    std::optional<BoundarySpec> boundary;  ///< no [boundary] table: none
    ReportSpec report;
    CheckSpec check;

    /// Number of points of the sweep; the reader has refused specs where it would overflow.
    std::uint64_t points() const
    {
        std::uint64_t product = 1;
        for (const auto& axis : axes) product *= axis.values.size();
        return product;
    }
};

/// The marked design: the joint with the design value of every axis. An axis whose value the joint leaves open stands
/// at its middle value.
Joint design_joint(const Spec& spec);

/// The axis of that path, or nullptr.
const Axis* axis_of(const Spec& spec, const std::string& path);

}  // namespace stickslip
