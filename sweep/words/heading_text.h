// What stands at the head of pages: which question a page answers, about which joint.
#pragma once
#include "analysis/joint/joint.h"

#include <string>

namespace stickslip {

/// "Margins: Ball screw": two pages about one joint do not look alike. `joint` is its title; empty: the question alone.
std::string page_title(const std::string& question, const std::string& joint);

/// "k_{p} = 60 kN/m · k_{v} = 900 N·s/m", mark-up.
std::string gains_text(const Joint& joint);

}  // namespace stickslip
