#include "sweep/files/json/motion_json.h"

#include "sweep/files/json/verdict_json.h"

#include <utility>

namespace stickslip {

nlohmann::ordered_json motion_json(const MotionMeasures& m, Units units)
{
    nlohmann::ordered_json motion;
    motion["travel"] = json_number(m.travel);
    motion["overshoot"] = json_number(m.overshoot);
    motion["settling_time"] = json_number(m.settling_time);
    motion["final_error"] = json_number(m.final_error);
    motion["stairs"] = m.stairs;
    motion["stair_height"] = json_number(m.stair_height);
    motion["stair_rate"] = json_number(m.stair_rate);
    nlohmann::ordered_json written;
    for (const auto& [name, quantity] : {std::pair{"time", Quantity::time},
                                         {"position", Quantity::position},
                                         {"velocity", Quantity::velocity},
                                         {"effort", Quantity::effort},
                                         {"command", Quantity::command}})
        written[name] = unit_of(quantity, units);
    return {{"format", "stickslip-motion/1"}, {"motion", motion}, {"units", written}};
}

}  // namespace stickslip
