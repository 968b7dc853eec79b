// Bad input by the user: everything that is wrong with it, at once, each line ready to print.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// The program ends with exit code 2. Each message reads `file:line:column: path: what was given, what is allowed`.
class BadInput : public std::runtime_error {
  public:
    explicit BadInput(std::vector<std::string> messages)
        : std::runtime_error(joined(messages)), messages_(std::move(messages))
    {
    }
    explicit BadInput(const std::string& message) : BadInput(std::vector<std::string>{message}) {}

    const std::vector<std::string>& messages() const { return messages_; }

  private:
    static std::string joined(const std::vector<std::string>& messages)
    {
        std::string text;
        for (const auto& m : messages) text += (text.empty() ? "" : "\n") + m;
        return text;
    }

    std::vector<std::string> messages_;
};

}  // namespace stickslip
