// What lumped models are drawn of: boxes on the ground, springs, dampers, walls and arrows, from left to right.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/line_drawing.h"
#include "analysis/results/text.h"

#include <string>
#include <utility>
#include <vector>

namespace stickslip::sketch {

inline constexpr double box_width = 124, box_height = 64, gap = 164, floor_y = 148, box_top = floor_y - box_height;
inline constexpr double spring_y = box_top + 18, damper_y = box_top + 46, middle_y = box_top + box_height / 2;
inline constexpr double wall_height = 100, margin = 60, height = 216;

/// "k_{p} = 2 kN/m", or the symbol alone where there is no number.
inline std::string labelled(const std::string& symbol, double value, Quantity quantity, Units units)
{
    return is_set(value) ? symbol + " = " + with_unit(value, quantity, units) : symbol;
}

/// A drawing under way, from left to right.
class Sketch {
  public:
    explicit Sketch(Units units) : units_(units) {}

    void line(std::vector<std::pair<double, double>> points) { drawing_.lines.push_back(std::move(points)); }
    void text(double x, double y, std::string markup, LineDrawing::Anchor anchor = LineDrawing::Anchor::middle)
    {
        drawing_.labels.push_back({x, y, std::move(markup), anchor});
    }
    void ring(double x, double y, double radius) { drawing_.rings.push_back({x, y, radius}); }

    void box(double x, const char* name, std::string inertia)
    {
        drawing_.boxes.push_back({x, box_top, box_width, box_height});
        text(x + box_width / 2, middle_y - 6, name);
        text(x + box_width / 2, middle_y + 14, std::move(inertia));
    }
    /// Ground under a body: that is where its friction acts.
    void friction(double x, const char* symbol, const Friction& f)
    {
        line({{x - 10, floor_y}, {x + box_width + 10, floor_y}});
        for (double at = x - 4; at < x + box_width + 10; at += 10) line({{at, floor_y}, {at - 7, floor_y + 8}});
        text(x + box_width / 2, floor_y + 28, std::string(symbol) + ": " + std::string(info(f.law).name));
    }
    void spring(double x1, double x2, double y, std::string label)
    {
        constexpr int turns = 12;
        const double lead = 14, step = (x2 - x1 - 2 * lead) / turns;
        std::vector<std::pair<double, double>> points{{x1, y}, {x1 + lead, y}};
        for (int i = 0; i < turns; ++i) points.emplace_back(x1 + lead + (i + 0.5) * step, y + (i % 2 ? 7 : -7));
        points.emplace_back(x2 - lead, y);
        points.emplace_back(x2, y);
        line(std::move(points));
        text((x1 + x2) / 2, y - 14, std::move(label));
    }
    void damper(double x1, double x2, double y, std::string label)
    {
        const double m = (x1 + x2) / 2;
        line({{x1, y}, {m - 4, y}});
        line({{m - 16, y - 8}, {m + 12, y - 8}, {m + 12, y + 8}, {m - 16, y + 8}});
        line({{m - 4, y - 6}, {m - 4, y + 6}});
        line({{m + 12, y}, {x2, y}});
        text(m, y + 26, std::move(label));
    }
    /// A wall with its hatching to the outer side.
    void wall(double x, double outwards)
    {
        line({{x, middle_y - wall_height / 2}, {x, middle_y + wall_height / 2}});
        for (double y = middle_y - wall_height / 2 + 8; y <= middle_y + wall_height / 2; y += 10)
            line({{x, y}, {x + 8 * outwards, y - 7}});
    }
    void arrow(double x1, double x2, double y, std::string label)
    {
        line({{x1, y}, {x2, y}});
        line({{x2 - 8, y - 5}, {x2, y}, {x2 - 8, y + 5}});
        text((x1 + x2) / 2, y - 8, std::move(label));
    }

    LineDrawing finish(double width, std::string title, std::vector<std::string> notes)
    {
        drawing_.width = width;
        drawing_.height = height;
        drawing_.title = std::move(title);
        drawing_.notes = std::move(notes);
        return std::move(drawing_);
    }

    Units units() const { return units_; }

  private:
    Units units_;
    LineDrawing drawing_;
};

}  // namespace stickslip::sketch
