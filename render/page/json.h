// JSON for the page's data, member by member; every text passes the escaping that keeps it inside its script element.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::drawing {

class JsonObject {
  public:
    JsonObject& text(std::string_view name, std::string_view value);
    JsonObject& flag(std::string_view name, bool value);
    JsonObject& number(std::string_view name, double value);
    JsonObject& numbers(std::string_view name, const std::vector<double>& values);
    JsonObject& raw(std::string_view name, std::string_view json);
    std::string close() const { return text_.empty() ? "{}" : text_ + "}"; }

  private:
    std::string text_;
};

std::string json_numbers(const std::vector<double>& values);
std::string json_array(const std::vector<std::string>& items);

}  // namespace stickslip::drawing
