// What a simulator cannot say of a joint, in words.
#pragma once
#include "sweep/study/export/export.h"

#include <string>

namespace stickslip {

/// "MuJoCo", "Isaac Lab".
std::string simulator_name(Simulator to);

/// What the text leaves of the gap in the records, beside the joint as it is.
std::string gap_left_text(const ExportAnswer& answer);

/// Why the key is lost, and what to do where something can be done.
std::string lost_text(const ExportAnswer& answer, const NotExpressible& lost);

/// At which velocity friction was read whose law states no Coulomb level; empty where all of them do.
std::string read_at_text(const SimulatorJoint& joint);

}  // namespace stickslip
