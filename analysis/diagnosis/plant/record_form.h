// Joints in the terms in which records are simulated: Coulomb, viscous and Stribeck friction, bristles, memory.
#pragma once
#include "analysis/joint/joint.h"

#include <string>
#include <vector>

namespace stickslip::gap {

/// The same joint where its laws are written in those terms, equation by equation: LuGre is a Stribeck curve on
/// bristles, Dahl of exponent 1 a Coulomb level on bristles, regularised rate-and-state a Coulomb level with memory,
/// kinetic and static friction a Stribeck peak that is gone as soon as the body moves. Laws that have no such form stay
/// as they are, and flatten() refuses them.
Joint record_form(const Joint& joint);

/// "LuGre" and so on: the first law that record_form() writes otherwise; empty where none is.
std::string rewritten_law(const Joint& joint);

/// Keys of what the file says and no record is simulated with: normal forces that move with the joint, neighbours.
std::vector<std::string> left_out_of_records(const Joint& joint);

}  // namespace stickslip::gap
