#include "sweep/files/text/unit_symbols.h"

#include <numbers>

namespace stickslip {
namespace {

constexpr double pi = std::numbers::pi;

struct Symbol {
    std::string_view name;
    bool prefixable;
    Unit unit;
};

//                              m  kg  s  A rad K
constexpr Dimension none_d{{0, 0, 0, 0, 0, 0}};

constexpr Dimension length_d{{1, 0, 0, 0, 0, 0}};

constexpr Dimension mass_d{{0, 1, 0, 0, 0, 0}};

constexpr Dimension time_d{{0, 0, 1, 0, 0, 0}};

constexpr Dimension current_d{{0, 0, 0, 1, 0, 0}};

constexpr Dimension angle_d{{0, 0, 0, 0, 1, 0}};

constexpr Dimension kelvin_d{{0, 0, 0, 0, 0, 1}};

constexpr Dimension per_time{{0, 0, -1, 0, 0, 0}};

constexpr Dimension turning{{0, 0, -1, 0, 1, 0}};

constexpr Dimension force_d{{1, 1, -2, 0, 0, 0}};

constexpr Dimension torque_d{{2, 1, -2, 0, 0, 0}};

constexpr Dimension impulse_d{{2, 1, -1, 0, 0, 0}};

constexpr Dimension power_d{{2, 1, -3, 0, 0, 0}};

constexpr Dimension pressure_d{{-1, 1, -2, 0, 0, 0}};

constexpr Dimension voltage_d{{2, 1, -3, -1, 0, 0}};

constexpr Dimension volt_second_d{{2, 1, -2, -1, 0, 0}};

constexpr Dimension ohm_d{{2, 1, -3, -2, 0, 0}};

const Symbol symbols[] = {
    {"m", true, {length_d}},
    {"g", true, {mass_d, 1, -3}},
    {"s", true, {time_d}},
    {"A", true, {current_d}},
    {"K", true, {kelvin_d}},
    {"rad", true, {angle_d}},
    {"N", true, {force_d}},
    {"Nm", true, {torque_d}},
    {"Nms", true, {impulse_d}},
    {"J", true, {torque_d}},
    {"W", true, {power_d}},
    {"Pa", true, {pressure_d}},
    {"V", true, {voltage_d}},
    {"Vs", true, {volt_second_d}},  // back-EMF constants of data sheets, Vs/rad
    {"Ω", true, {ohm_d}},
    {"\u2126", true, {ohm_d}},  // the ohm sign, another code point than the Greek letter
    {"ohm", true, {ohm_d}},
    {"Ohm", true, {ohm_d}},
    {"Hz", true, {per_time}},
    {"min", false, {time_d, 60}},
    {"h", false, {time_d, 3600}},
    {"deg", true, {angle_d, pi / 180}},
    {"°", false, {angle_d, pi / 180}},
    {"arcmin", false, {angle_d, pi / 10800}},
    {"arcsec", false, {angle_d, pi / 648000}},
    {"rev", false, {angle_d, 2 * pi}},
    {"turn", false, {angle_d, 2 * pi}},
    {"rpm", false, {turning, pi / 30}},
    {"°C", false, {kelvin_d, 1, 0, 273.15}},
    {"degC", false, {kelvin_d, 1, 0, 273.15}},
    {"1", false, {none_d}},
    {"%", false, {none_d, 1, -2}},
};

struct Prefix {
    std::string_view name;
    int decimals;
};

constexpr Prefix prefixes[] = {{"p", -12}, {"n", -9}, {"u", -6}, {"\u00b5", -6}, {"\u03bc", -6},
                               {"m", -3},  {"c", -2}, {"k", 3},  {"M", 6},       {"G", 9}};

}  // namespace

std::optional<Unit> unit_named(std::string_view name)
{
    for (const auto& s : symbols)
        if (s.name == name) return s.unit;
    for (const auto& p : prefixes) {
        if (!name.starts_with(p.name)) continue;
        for (const auto& s : symbols) {
            if (!s.prefixable || s.name != name.substr(p.name.size())) continue;
            Unit unit = s.unit;
            unit.decimals += p.decimals;
            return unit;
        }
    }
    return {};
}

}  // namespace stickslip
