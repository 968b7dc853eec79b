// What ranges of single numbers cannot say of a joint, asked of every point along an axis.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// Whether no table of the joint has a problem(): the rules between keys for which check() refuses a file, without its
/// words. Numbers within their ranges may break them together, and then there is no such joint to be judged.
bool obeys_rules(const Joint& joint);

}  // namespace stickslip
