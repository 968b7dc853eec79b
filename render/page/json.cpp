#include "render/page/json.h"

#include "render/csv/csv.h"
#include "render/page/html.h"

#include <cmath>

namespace stickslip::drawing {
namespace {

std::string json_number(double value)
{
    return std::isfinite(value) ? number(value) : "null";
}

}  // namespace

JsonObject& JsonObject::text(std::string_view name, std::string_view value)
{
    return raw(name, json_string(value));
}

JsonObject& JsonObject::flag(std::string_view name, bool value)
{
    return raw(name, value ? "true" : "false");
}

JsonObject& JsonObject::number(std::string_view name, double value)
{
    return raw(name, json_number(value));
}

JsonObject& JsonObject::numbers(std::string_view name, const std::vector<double>& values)
{
    return raw(name, json_numbers(values));
}

JsonObject& JsonObject::raw(std::string_view name, std::string_view json)
{
    text_.append(text_.empty() ? "{" : ",").append(json_string(name)).append(":").append(json);
    return *this;
}

std::string json_numbers(const std::vector<double>& values)
{
    std::vector<std::string> items;
    for (const double v : values) items.push_back(json_number(v));
    return json_array(items);
}

std::string json_array(const std::vector<std::string>& items)
{
    std::string list = "[";
    for (const std::string& item : items) list.append(list.size() > 1 ? "," : "").append(item);
    return list + "]";
}

}  // namespace stickslip::drawing
