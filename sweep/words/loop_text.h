// Which loop a verdict is about, in words.
#pragma once
#include "analysis/loop/loop_use.h"
#include "analysis/results/report.h"
#include "sweep/study/left_out_loop.h"
#include "sweep/study/loop_growth.h"

#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// "ideal", "continuous", "sampled".
std::string loop_name(LoopKind kind);

/// Why a term of the joint is no part of the linear verdict.
std::string why_text(WhyNot why);

/// A sentence with what the loop used and what it could not; empty for an ideal loop that leaves nothing out.
std::string loop_text(const LoopUse& loop);

/// What `--ideal-loop` leaves out of the joint that its file describes, and whether that joint slides: by its growth
/// rate, NaN where it has none.
std::string left_out_text(const LoopUse& described, double growth);

/// Of a page about the ideal loop, which calls sliding `stable`: names what was left out. Where the loop as it is does
/// not slide, that is no clean yes.
void tell_left_out(const LeftOut& left_out, bool stable, Report& report);

/// A verdict on the ideal loop of a joint whose file describes another: it begins with the loop that it is about.
std::string of_ideal_loop(const std::string& verdict);

/// At which side of a gear numbers are counted, of a record or of a verdict; empty without a gear between.
std::string side_text(const GearSide& gear, bool of_record);

/// A loop that leaves its reference, as a sentence.
std::string unstable_loop_text(const UnstableLoop& loop, Units units);

/// How a diagnosis writes a law that records are not simulated in as it stands.
std::string rewritten_law_text(std::string_view law);
/// What the file says and records are simulated without.
std::string left_out_text(const std::vector<std::string>& keys);

/// Whether something that matters was left out: such a verdict is no clean yes.
bool leaves_out_what_matters(const LoopUse& loop);
Headline::Tone without_what_matters(Headline::Tone tone, const LoopUse& loop);  ///< a warning in place of good

}  // namespace stickslip
