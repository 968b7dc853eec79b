// locate_over_chart: marching over a mesh whose crossings are located exactly.
#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/parameters.h"
#include "analysis/numerics/root.h"

#include <array>
#include <map>
#include <stdexcept>

namespace stickslip {
namespace {

struct Node {
    double x, y;
};

/// An edge of the mesh: from node (i, j) to the right (across = false) or upwards (across = true).
struct Edge {
    int i, j;
    bool up;
    auto operator<=>(const Edge&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 finds one in it
};

/// The axis' own values with each interval cut evenly until there are at least `mesh` of them.
std::vector<double> refined(const Axis& axis, int mesh)
{
    if (axis.values.size() < 2) return axis.values;
    const int cuts =
        std::max(1, (mesh + static_cast<int>(axis.values.size()) - 2) / (static_cast<int>(axis.values.size()) - 1));
    std::vector<double> nodes;
    for (std::size_t k = 0; k + 1 < axis.values.size(); ++k) {
        const double a = axis.values[k], b = axis.values[k + 1];
        for (int c = 0; c < cuts; ++c) {
            const double share = static_cast<double>(c) / cuts;
            nodes.push_back(c == 0 ? a : axis.log ? a * std::pow(b / a, share) : a + share * (b - a));
        }
    }
    nodes.push_back(axis.values.back());
    return nodes;
}

/// One theory's boundary over one mesh.
class Marching {
  public:
    Marching(const Joint& joint, const Axis& x, const Axis& y, Curve::Kind theory, int mesh)
        : joint_(joint),
          theory_(theory),
          xs_(refined(x, mesh)),
          ys_(refined(y, mesh)),
          x_(number_at(joint_, x.path)),
          y_(number_at(joint_, y.path))
    {
        for (const double v : ys_)
            for (const double u : xs_) values_.push_back(at(u, v));
    }

    Curve run()
    {
        for (int j = 0; j + 1 < rows(); ++j)
            for (int i = 0; i + 1 < columns(); ++i) cross_cell(i, j);
        Curve curve;
        curve.kind = theory_;
        while (!links_.empty()) append_piece(curve);
        curve.precision = precision_;
        return curve;
    }

  private:
    int columns() const { return static_cast<int>(xs_.size()); }
    int rows() const { return static_cast<int>(ys_.size()); }
    double value(int i, int j) const
    {
        return values_[static_cast<std::size_t>(j) * xs_.size() + static_cast<std::size_t>(i)];
    }

    double at(double x, double y)
    {
        x_ = x, y_ = y;
        return instability(joint_, theory_);
    }

    bool crosses(const Edge& e)
    {
        const double a = value(e.i, e.j), b = e.up ? value(e.i, e.j + 1) : value(e.i + 1, e.j);
        if (std::isnan(a) || std::isnan(b) || (a < 0) == (b < 0)) return false;
        return a != 0 && b != 0 ? true : neutral_at_node_only(e, a == 0);
    }

    /// Between a stable and a neutral node: where decay reaches up to the node, a boundary runs through it. Where it
    /// fades before, sliding is neutral over an area, a class of its own, at whose edge nothing begins to grow.
    bool neutral_at_node_only(const Edge& e, bool at_first)
    {
        constexpr double next_to_node = 1e-6;  ///< of the edge
        const double share = at_first ? next_to_node : 1 - next_to_node;
        const auto between = [share](double from, double to) { return from + share * (to - from); };
        return e.up ? at(xs_[e.i], between(ys_[e.j], ys_[e.j + 1])) < 0
                    : at(between(xs_[e.i], xs_[e.i + 1]), ys_[e.j]) < 0;
    }

    void link(const Edge& a, const Edge& b)
    {
        links_[a].push_back(b);
        links_[b].push_back(a);
    }

    void cross_cell(int i, int j)
    {
        // counter-clockwise: bottom, right, top, left
        const std::array<Edge, 4> around{{{i, j, false}, {i + 1, j, true}, {i, j + 1, false}, {i, j, true}}};
        std::vector<Edge> crossed;
        for (const auto& e : around)
            if (crosses(e)) crossed.push_back(e);
        if (crossed.size() == 2) link(crossed[0], crossed[1]);
        if (crossed.size() != 4) return;
        // a saddle: the centre says which corners belong together
        const double centre = at((xs_[i] + xs_[i + 1]) / 2, (ys_[j] + ys_[j + 1]) / 2);
        const bool joins_lower_left = (centre < 0) == (value(i, j) < 0);
        link(crossed[0], crossed[joins_lower_left ? 1 : 3]);
        link(crossed[2], crossed[joins_lower_left ? 3 : 1]);
    }

    Node located(const Edge& e)
    {
        const double fa = value(e.i, e.j);
        if (e.up) {
            const double x = xs_[e.i];
            const auto root = bracketed_root([&](double y) { return at(x, y); }, ys_[e.j], fa, ys_[e.j + 1],
                                             value(e.i, e.j + 1), linear_precision);
            precision_ = std::max(precision_, (root.high - root.low) / std::abs(root.value));
            return {x, root.value};
        }
        const double y = ys_[e.j];
        const auto root = bracketed_root([&](double x) { return at(x, y); }, xs_[e.i], fa, xs_[e.i + 1],
                                         value(e.i + 1, e.j), linear_precision);
        precision_ = std::max(precision_, (root.high - root.low) / std::abs(root.value));
        return {root.value, y};
    }

    /// Takes one connected piece out of the links, from an open end if there is one.
    void append_piece(Curve& curve)
    {
        auto start = links_.begin();
        for (auto it = links_.begin(); it != links_.end(); ++it)
            if (it->second.size() == 1) {
                start = it;
                break;
            }
        if (!curve.x.empty()) curve.x.push_back(missing), curve.y.push_back(missing);
        const std::size_t piece = curve.x.size();
        const Edge first = start->first;
        Edge here = first;
        for (;;) {
            const auto node = located(here);
            curve.x.push_back(node.x), curve.y.push_back(node.y);
            auto& next = links_[here];
            if (next.empty()) break;
            const Edge there = next.back();
            next.pop_back();
            std::erase(links_[there], here);
            if (next.empty()) links_.erase(here);
            here = there;
            if (here == first) {  // a closed curve ends where it began
                curve.x.push_back(curve.x[piece]), curve.y.push_back(curve.y[piece]);
                break;
            }
        }
        links_.erase(here);
    }

    Joint joint_;
    Curve::Kind theory_;
    std::vector<double> xs_, ys_;
    JointNumber x_, y_;
    std::vector<double> values_;
    std::map<Edge, std::vector<Edge>> links_;
    double precision_ = 0;
};

}  // namespace

Curve locate_over_chart(const Joint& joint, const Axis& x, const Axis& y, Curve::Kind theory, int mesh)
{
    return Marching(joint, x, y, theory, mesh).run();
}

}  // namespace stickslip
