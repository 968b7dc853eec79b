#include "render/pictures/signed_field.h"

#include "analysis/results/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::drawing {

double FieldScale::at(double value) const
{
    return 0.5 + 0.5 * std::asinh(value / knee) / std::asinh(limit / knee);
}

double FieldScale::value(double position) const
{
    return knee * std::sinh((2 * position - 1) * std::asinh(limit / knee));
}

FieldScale field_scale(const std::vector<double>& field)
{
    std::vector<double> sizes;
    for (const double value : field)
        if (std::isfinite(value) && value != 0) sizes.push_back(std::abs(value));
    if (sizes.empty()) return {};
    std::sort(sizes.begin(), sizes.end());
    const double limit = sizes.back(), fifth = sizes[sizes.size() / 5];
    const double knee = std::pow(10, std::floor(std::log10(std::clamp(fifth, limit / 1e4, limit))));
    return {knee, limit};
}

std::vector<ColourBar::Mark> field_marks(const FieldScale& scale, double height)
{
    constexpr double room = 22;  // px between labels
    std::vector<ColourBar::Mark> marks{{0.5, "0"}};
    const auto place = [&](double value) {
        const double position = scale.at(value);
        if (position < 0 || position > 1) return;
        for (const auto& mark : marks)
            if (std::abs(mark.position - position) * height < room) return;
        marks.push_back({position, plain_number(value)});
    };
    const int first = static_cast<int>(std::floor(std::log10(scale.knee))) - 1;
    const int last = static_cast<int>(std::floor(std::log10(scale.limit)));
    for (const double digit : {1.0, 5.0, 2.0})
        for (int exponent = last; exponent >= first; --exponent)
            for (const double sign : {1.0, -1.0}) place(sign * digit * std::pow(10, exponent));
    return marks;
}

Raster field_raster(const Grid& grid, const std::vector<double>& field, const FieldScale& scale, int width, int height)
{
    std::vector<double> positions(field.size());
    std::transform(field.begin(), field.end(), positions.begin(), [&](double v) { return scale.at(v); });
    return table_raster(grid, positions, vik_table, width, height);
}

Raster table_raster(const Grid& grid, const std::vector<double>& positions, const ColourTable& table, int width,
                    int height, const Shown& shown)
{
    Raster raster{width, height, 3, {}};
    raster.pixels.reserve(static_cast<std::size_t>(width) * height * 3);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const Grid::Place place = grid.at((column + 0.5) / width, 1 - (row + 0.5) / height);
            double position = 0, weight = 0;
            for (std::size_t k = 0; k < 4; ++k)
                if (std::isfinite(positions[place.node[k]])) {
                    position += place.weight[k] * positions[place.node[k]];
                    weight += place.weight[k];
                }
            Colour colour = no_value;
            const bool here = shown ? shown(column, row) : std::isfinite(positions[place.nearest()]);
            if (here && weight > 0) {
                // Whole entries of the table: neighbouring pixels repeat, and the PNG shrinks to a third.
                const auto entry = std::lround(255 * std::clamp(position / weight, 0.0, 1.0));
                colour = from_hex(table[static_cast<std::size_t>(entry)]);
            }
            raster.pixels.insert(raster.pixels.end(), {colour.red, colour.green, colour.blue});
        }
    return raster;
}

}  // namespace stickslip::drawing
