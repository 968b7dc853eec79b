// Every key that a joint file may hold, over all models, laws and kinds, with what it depends on.
#pragma once
#include "analysis/joint/keys.h"

#include <map>
#include <string>
#include <vector>

namespace stickslip {

/// A key of some joint. A row of a list has "[]" in place of its number: "friction.elements[].yield".
struct ListedKey {
    Key key;
    /// The words of other keys under which this one exists, where it does not exist under all of them:
    /// "control.structure" → {"pid"}. Under "friction.law" the laws that have it.
    std::map<std::string, std::vector<std::string>> only_with;
};

/// In the order of the file; those of the friction laws behind each other. Friction on one of several bodies
/// (friction.motor, …) and under a time lag (friction.curve) has the keys of [friction] and is not repeated.
std::vector<ListedKey> every_joint_key();

}  // namespace stickslip
