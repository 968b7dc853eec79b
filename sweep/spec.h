// What a sweep is to compute, validated and in SI: the joint, the axes, and what is asked at each point.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/stability_map.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// How the steadily sliding joint is disturbed before its nonlinear outcome is watched.
struct Disturbance {
    enum class Kind {
        position,      ///< the body is displaced, m | rad
        velocity,      ///< the velocity jumps, m/s | rad/s
        state,         ///< every friction state is moved, N | N·m
        force_impulse  ///< a short push of this impulse, N·s | N·m·s
    };
    static constexpr Choice<Kind> kinds[] = {{"position", Kind::position},
                                             {"velocity", Kind::velocity},
                                             {"state", Kind::state},
                                             {"force-impulse", Kind::force_impulse}};
    Kind kind = Kind::velocity;
    double size = not_set;  ///< in the unit of its kind; not set: the evaluation chooses and states it

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        constexpr Quantity quantities[] = {Quantity::position, Quantity::velocity, Quantity::effort, Quantity::impulse};
        visit.choice("kind", "what is disturbed", self.kind, kinds);
        visit.number({"size", quantities[static_cast<int>(self.kind)], any_finite, Need::optional, "size"}, self.size);
    }
};

/// The nonlinear outcome at each point. Linear verdicts are always computed.
struct NonlinearSpec {
    bool enabled = false;
    Disturbance disturbance;
    double tolerance = 1e-8;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        constexpr Range tolerances{1e-13, 1e-2, false, false};
        visit.flag("enabled", "simulate every point", self.enabled);
        visit.table("disturbance", "what starts the motion", self.disturbance);
        visit.number(
            {"tolerance", Quantity::number, tolerances, Need::optional, "relative tolerance of the integration"},
            self.tolerance);
    }
};

/// Boundaries located point by point along one parameter.
struct BoundarySpec {
    std::string axis;         ///< dotted path that is moved; empty: the y axis of each chart
    double precision = 1e-6;  ///< largest relative width of the final bracket

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        constexpr Range precisions{1e-12, 0.1, false, false};
        visit.text("axis", "dotted path along which the boundary is located", self.axis);
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
    std::optional<BoundarySpec> boundary;  ///< no [boundary] table: not asked
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

}  // namespace stickslip
