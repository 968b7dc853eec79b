// A friction law whose equations no record is fitted with.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace stickslip {

/// Thrown before a diagnosis begins. Its code and its numbers say what a joint file may hold instead.
class NotFitted : public std::invalid_argument {
  public:
    enum class Why {
        several_states,  ///< rate-and-state friction with more than one
        elements,        ///< that slip one after the other; level, viscous and stiffness are their sums
        pure_delay,      ///< lag: that of the law
        other_law
    };

    NotFitted(Why reason, std::string_view name)
        : std::invalid_argument("friction law \"" + std::string(name) + "\" cannot be fitted to records"),
          why(reason),
          law(name)
    {
    }

    Why why;
    std::string law;                               ///< its name in a joint file
    double level = 0, viscous = 0, stiffness = 0;  ///< SI
    double lag = 0;                                ///< s
};

}  // namespace stickslip
