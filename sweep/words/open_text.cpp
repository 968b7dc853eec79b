#include "sweep/words/open_text.h"

#include "sweep/words/verdict_text.h"

namespace stickslip {

std::string open_text(const NonlinearVerdict& verdict)
{
    const std::string reason = reason_text(verdict), because = reason.empty() ? "." : ": " + reason + ".";
    return (verdict.outcome == Outcome::stable_sliding
                ? "Undecided whether larger disturbances also end in steady sliding" + because
                : "Undecided how the motion after the disturbance ends" + because) +
           " About small disturbances:";
}

}  // namespace stickslip
