#include "sweep/files/json/archive.h"

#include "analysis/results/point.h"

#include <limits>
#include <mutex>
#include <set>

namespace stickslip::archive {

std::string_view kept(const std::string& text)
{
    static std::mutex alone;
    static std::set<std::string> texts;
    const std::lock_guard lock(alone);
    return *texts.insert(text).first;
}

Json written(double value)
{
    if (std::isnan(value)) return nullptr;
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return value;
}

double read_number(const Json& json)
{
    if (json.is_number()) return json.get<double>();
    if (json.is_null()) return missing;
    if (json == "inf") return std::numeric_limits<double>::infinity();
    if (json == "-inf") return -std::numeric_limits<double>::infinity();
    throw std::invalid_argument("is not a number");
}

}  // namespace stickslip::archive
