#include "render/page/layer_data.h"

#include "render/axes/frame.h"
#include "render/drawing/colour_map.h"
#include "render/page/figure_data.h"
#include "render/page/json.h"
#include "render/page/pack_arrays.h"
#include "render/pictures/design_mark.h"
#include "render/pictures/signed_field.h"

#include <cmath>
#include <stdexcept>

namespace stickslip::drawing {
namespace {

// A thousandth of this square is finer than a pixel of any screen.
constexpr double square = 1000;

/// Boundary pieces as positions across and down in [0, 1], NaN between pieces.
std::string curve_data(const Curve& curve, const Frame& frame)
{
    std::vector<double> positions;
    for (const Polyline& piece : visible(curve.x, curve.y, frame)) {
        if (!positions.empty()) positions.insert(positions.end(), {NAN, NAN});
        for (const Point p : piece) positions.insert(positions.end(), {p.x / square, p.y / square});
    }
    return JsonObject()
        .flag("memory", curve.kind == Curve::Kind::state_variable)
        .flag("ideal", curve.kind == Curve::Kind::ideal_loop)
        .text("points", pack_coarse(positions))
        .close();
}

std::string colour_bytes(const ColourTable& table)
{
    std::vector<std::uint8_t> bytes;
    for (const auto entry : table) {
        const Colour c = from_hex(entry);
        bytes.insert(bytes.end(), {c.red, c.green, c.blue});
    }
    return pack(bytes);
}

}  // namespace

std::string depth_data(const StabilityMap& map)
{
    const std::size_t points = map.abscissa.size();
    Axis axis = map.depth;
    axis.values.clear();
    std::vector<double> fields;
    std::vector<Region> regions;
    std::vector<std::string> curves;
    const Frame frame{
        {0, 0, square, square}, {spanning(map.x.values, map.x.log), {}}, {spanning(map.y.values, map.y.log), {}}};
    std::size_t own = 0;
    for (const MapLayer& layer : map.layers) {
        if (layer.abscissa.size() != points || layer.region.size() != points)
            throw std::invalid_argument("stability map \"" + map.title + "\": a layer with " +
                                        std::to_string(layer.abscissa.size()) + " points instead of " +
                                        std::to_string(points));
        if (layer.value == map.depth_value) own = axis.values.size();
        axis.values.push_back(layer.value);
        fields.insert(fields.end(), layer.abscissa.begin(), layer.abscissa.end());
        regions.insert(regions.end(), layer.region.begin(), layer.region.end());
        std::vector<std::string> list;
        for (const Curve& curve : layer.curves) list.push_back(curve_data(curve, frame));
        curves.push_back(json_array(list));
    }
    const FieldScale scale = field_scale(map.abscissa);
    return JsonObject()
        .raw("axis", axis_data(axis, map.units))
        .number("at", static_cast<double>(own))
        .text("field", pack_coarse(fields))
        .text("class", pack(region_codes(regions)))
        .raw("curves", json_array(curves))
        .text("colours", colour_bytes(vik_table))
        .number("knee", scale.knee)
        .number("limit", scale.limit)
        .close();
}

std::string motion_data(const StabilityMap& map)
{
    std::vector<double> places, lengths, time, velocity;
    for (const MapMotion& motion : map.motions) {
        if (motion.time.size() != motion.velocity.size())
            throw std::invalid_argument("stability map \"" + map.title + "\": a motion with " +
                                        std::to_string(motion.time.size()) + " times and " +
                                        std::to_string(motion.velocity.size()) + " velocities");
        places.insert(places.end(), {motion.x, motion.y});
        lengths.push_back(static_cast<double>(motion.time.size()));
        time.insert(time.end(), motion.time.begin(), motion.time.end());
        velocity.insert(velocity.end(), motion.velocity.begin(), motion.velocity.end());
    }
    return JsonObject()
        .text("places", pack(places))
        .numbers("lengths", lengths)
        .text("time", pack_coarse(time))
        .text("velocity", pack_coarse(velocity))
        .text("unit", unit_of(Quantity::velocity, map.units))
        .close();
}

}  // namespace stickslip::drawing
