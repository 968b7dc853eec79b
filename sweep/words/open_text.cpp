#include "sweep/words/open_text.h"

#include "sweep/words/reason_text.h"

#include <fmt/ranges.h>

namespace stickslip {

std::string open_ending_text(const NonlinearVerdict& verdict)
{
    const std::string reason = reason_text(verdict);
    return "Undecided " +
           std::string(verdict.outcome == Outcome::stable_sliding
                           ? "whether larger disturbances also end in steady sliding"
                           : "how the motion ends after the disturbance") +
           (reason.empty() ? "." : ": " + reason + ".");
}

std::string open_text(const NonlinearVerdict& verdict)
{
    return open_ending_text(verdict) + " Small disturbances:";
}

std::string contradicted_text(const std::vector<std::string>& terms, bool grows)
{
    return std::string(grows ? "Stick-slip: small disturbances grow" : "Smooth sliding: small disturbances decay") +
           " in the simulation of this joint. The linear theory, which has no term for " +
           fmt::format("{}", fmt::join(terms, ", ")) + ", gives the opposite:";
}

}  // namespace stickslip
