// The catalogue of effects as edits of a machine. An edit has everything drawn but its size, which a case then chooses
// so that the gap has the wanted strength.
#pragma once
#include "tests/blind/generate/machine.h"

#include <functional>
#include <string>
#include <vector>

namespace blind {

class Draw;
struct Nominal;

/// A number that the effect changed, under the name that the joint file gives it.
struct Parameter {
    std::string path;
    double nominal = 0, value = 0;
};

struct Edit {
    std::string name, variant;
    double smallest = 0.02, largest = 1;  ///< plausible sizes; what a size means is the edit's own business
    /// Puts the effect of that size into the machine and says what it changed.
    std::function<std::vector<Parameter>(Machine&, double size)> apply;
    /// Catalogue effects that no experiment of this kind could tell from it.
    std::vector<std::string> equivalent;
    bool differs_by_record = false;  ///< random, or time-locked with a phase of its own in every record
};

const std::vector<std::string>& effect_names();
/// Families of joints on which the effect can be seen at all.
/// Whether a controller of this structure can have the effect: the gains of a PD law alone, those of an integral not.
bool controller_has(const std::string& structure, const std::string& effect);
std::vector<std::string> families_for(const std::string& effect);
/// Draws everything but the size. `peak_command` is the largest drive signal of the nominal records.
Edit draw_effect(const std::string& name, const Nominal& nominal, double peak_command, Draw& draw);
/// The same for a cause outside the catalogue.
Edit draw_outside(const std::string& name, const Nominal& nominal, Draw& draw);
/// Whether two effects may act together in a pair case: not the same, and not two names for nearly the same motion.
bool may_pair(const std::string& one, const std::string& other);

}  // namespace blind
