// Ways to walk the description of a joint: check it, find a number by its dotted path, list all numbers, write
// canonical text.
#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint.h"

namespace stickslip {

/// A number inside a joint, by its dotted path.
struct Parameter {
    std::string path;                      ///< "friction.L" or "friction.L.0"; a list of one answers to both
    Quantity quantity = Quantity::number;  ///< its unit follows from it and the units of the joint
    Range range;                           ///< allowed values, in SI
    Need need = Need::optional;            ///< a required number has no default
    std::string help;                      ///< half a sentence
    double* value = nullptr;               ///< into the joint that was walked
    Role role = Role::plain;               ///< what it is to those that move it
};

/// Every numeric leaf of the joint in file order, pointing into it (model and laws decide which leaves there are).
std::vector<Parameter> parameters(Joint& joint);

/// The number at a path such as "control.k_p", or nullptr. The pointer lives as long as the joint and its law are kept.
const double* find_parameter(const Joint& joint, std::string_view path);

/// A number of a joint to read and to move, for as long as the joint and its law are kept. What follows from it moves
/// with it: inertia and gravity from the pose of a robot.
class JointNumber {
  public:
    /// Of a joint and a number in it.
    JointNumber(Joint& joint, double& number);
    JointNumber(const JointNumber&) = default;
    JointNumber& operator=(const JointNumber&) = delete;  // of another joint

    /// Its value.
    operator double() const { return number_; }
    /// Moves it.
    const JointNumber& operator=(double value) const
    {
        number_ = value;
        if (posed_) joint_.pose.of->apply(joint_.pose.coordinates, joint_);
        return *this;
    }

  private:
    Joint& joint_;
    double& number_;
    bool posed_ = false;
};

/// The number at a path. Throws std::invalid_argument for a path that the joint lacks.
JointNumber number_at(Joint& joint, std::string_view path);

/// Of the number at a path; Quantity::number where the joint lacks it.
Quantity quantity_of(const Joint& joint, std::string_view path);

/// A table of samples that a law takes from a file: `name` is the file as it stands in joint.toml (empty: none),
/// the reader of files fills `table`. check() complains about a named table that was not filled.
struct TableSlot {
    std::string path;                   ///< of the key that names the file
    const std::string* name = nullptr;  ///< of the file, as the joint has it
    KernelTablePtr* table = nullptr;    ///< where what the file holds goes
};
/// Every such table of the joint, pointing into it.
std::vector<TableSlot> tables(Joint& joint);

/// Every path whose spelling comes close to the given one, nearest first, at most three.
std::vector<std::string> nearest_names(std::string_view given, const std::vector<std::string>& known);

/// What is wrong with a value: where, and in words what was given and what is allowed.
struct Problem {
    std::string path;     ///< of the key
    std::string message;  ///< what is wrong and what is expected, without the path
};

/// Everything that forbids using this joint: missing numbers, values outside their range, lists of unequal length.
std::vector<Problem> check(const Joint& joint);

/// One line a leaf, "path = value" with 17 digits, in file order: equal text means equal joints. Plans are hashed from
/// it.
std::string canonical_text(const Joint& joint);

/// In words: "> 0", "≥ 0", "within [0, 1)".
std::string describe(const Range& range);

}  // namespace stickslip
