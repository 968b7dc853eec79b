// Where a motion ends, in words and numbers for a reader who does not know the code's names.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/results/report.h"

#include <string>
#include <vector>

namespace stickslip {

/// "Smooth: the disturbance decays." One sentence, mark-up.
std::string ending_text(const NonlinearVerdict& verdict);

/// Good where the joint comes to slide, bad where it oscillates, a warning where nobody knows.
Headline::Tone ending_tone(const NonlinearVerdict& verdict);

/// The numbers of the limit cycle that the motion ends in; the decay where there is none.
std::vector<Headline> ending_headlines(const Joint& joint, const NonlinearVerdict& verdict);

}  // namespace stickslip
