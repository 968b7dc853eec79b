// How many roots lie right of a vertical line: the argument principle.
#pragma once
#include <optional>
#include <vector>

#include "analysis/stability/linear_joint.h"

namespace stickslip {

/// The roots right of Re s = σ, a pair counted twice, and where the line was looked at: close enough for the phase of
/// the characteristic function to be followed.
struct LineCount {
    struct Node {
        double omega;
        double steepness;  ///< |F'/F|: large next to a root
    };
    double sigma = 0;
    int roots = 0;
    std::vector<Node> nodes;
};

/// Follows the phase of F(s) Π(s − λ), the λ being the rates of all friction states: an entire function whose zeros are
/// the roots of the joint, whichever side of the poles of G they lie on. A step is taken only where the slopes of the
/// phase at both its ends foretell the change that is seen, and where it is short beside the longest delay or what is
/// delayed cannot turn F (Rouché). Nothing if a root lies on the line within rounding, if numbers overflow, or if
/// `most` steps do not reach the end.
std::optional<LineCount> count_right_of(const LinearJoint& joint, double sigma, int most = 200'000);

/// The roots right of Re s = σ alone.
std::optional<int> roots_right_of(const LinearJoint& joint, double sigma);

}  // namespace stickslip
