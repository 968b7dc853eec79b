// Every key of a joint with all that its declaration says: numbers, words and flags, with their defaults. Made from
// Joint::fields alone; `list keys`, `new joint` and `export` read it.
#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint.h"

namespace stickslip {

/// What stands behind a key.
enum class KeyKind { number, numbers, flag, choice, text };

/// One key as the given joint has it. Which keys there are depends on its model, laws and kinds.
struct Key {
    std::string path;  ///< "control.k_p"; of a list "friction.B"; of row 2 of a list "friction.elements.1.yield"
    KeyKind kind = KeyKind::number;        ///< what its value is
    Quantity quantity = Quantity::number;  ///< of numbers; its unit follows from it
    Range range;                           ///< of numbers, in SI
    Need need = Need::optional;            ///< whether a file has to state it
    std::string help;                      ///< half a sentence
    std::vector<std::string> words;        ///< what a choice allows
    std::string value;                     ///< as a file would have it, without quotes; empty: not set
    std::string standard;                  ///< the same of a joint where nothing was said; empty: there is none
    bool in_row = false;                   ///< stands in a table of a list, [[…]]

    /// Whether the key changes anything: a key at its default could as well be absent.
    bool in_force() const { return value != standard; }
};

/// In the order of the file.
std::vector<Key> keys(const Joint& joint);

/// Gives the choice at a path ("joint.model", "control.kind", "friction.law", "friction.motor.law") one of its words. A
/// new law starts with its numbers not set. False: no such choice, or no such word.
bool choose(Joint& joint, const std::string& path, const std::string& word);

}  // namespace stickslip
