// One piece of a boundary, step by step. Internal to analysis/boundary.
#pragma once
#include "analysis/boundary/trace/chart.h"
#include "analysis/boundary/trace/follow.h"

#include <optional>

namespace stickslip {

/// A located point in scaled coordinates, with what the next step needs.
struct Located {
    UnitPoint p;
    CurvePoint point;
    double slope = 0;      ///< |change of the measure| per unit along the axis of the bracket; 0: not known
    double missed_by = 0;  ///< distance of the prediction
    bool at_border = false;
};

/// Whether two values of a measure lie on different sides.
inline bool differ(double a, double b)
{
    return !std::isnan(a) && !std::isnan(b) && (a < 0) != (b < 0);
}

class Tracer {
  public:
    Tracer(const Sides& sides, const Axis& x, const Axis& y, const FollowingOptions& options)
        : sides_(sides), options_(options), x_(x), y_(y)
    {
    }

    double at(UnitPoint p)
    {
        ++evaluations_;
        return sides_.at(x_.value(p.u), y_.value(p.v));
    }
    int evaluations() const { return evaluations_; }
    void count(int more) { evaluations_ += more; }

    /// The boundary between two points that differ in one coordinate only and lie on different sides.
    Located locate(UnitPoint a, double fa, UnitPoint b, double fb);

    /// A whole piece through a located point: both ways from it, in the order of the walk.
    CurvePiece piece_through(const Located& start, std::vector<UnitPoint>& path);

    const UnitAxis& x() const { return x_; }
    const UnitAxis& y() const { return y_; }

  private:
    struct Exit {
        UnitPoint direction;
        double left = 0;  ///< sign of the side on the left hand
    };
    /// One way along the boundary from where the path stands to an end.
    struct Walk {
        std::vector<Located> nodes;
        CurveEnd end = CurveEnd::lost;
    };
    enum class Failure { none, no_change, undecided };
    /// What is known of the boundary near a predicted point.
    struct Prediction {
        double first, widest;  ///< how far across to look for the other side, at first and at most
        double slope = 0;      ///< of the measure; 0: not known
        double doubt = 0.3;    ///< relative error of the slope
    };

    std::vector<Exit> exits(UnitPoint centre, double radius, const UnitPoint* back = nullptr);
    Walk walk(const Located& start, Exit exit);
    std::optional<Exit> beyond_corner(const Walk& walk, const Exit& heading, double radius, bool& been);
    std::optional<Located> step(const Walk& walk, const Exit& heading, double h);
    std::optional<Located> correct(UnitPoint q, const Exit& heading, const Prediction& expected);
    Prediction predict(const Walk& walk, UnitPoint& q, bool along_y, double h) const;
    std::optional<Located> leave(UnitPoint from, UnitPoint to);
    bool closes(const Walk& walk, const Located& next) const;
    static bool travelled(const Walk& walk, UnitPoint p, double near);
    double bend(const Walk& walk) const;

    const Sides& sides_;
    const FollowingOptions& options_;
    UnitAxis x_, y_;
    int evaluations_ = 0;
    Failure failure_ = Failure::none;
};

}  // namespace stickslip
