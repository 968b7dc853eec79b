// What the answer of a rig holds beside its causes. Internal to analysis/diagnosis/rig.
#pragma once
#include "analysis/diagnosis/rig/rig_laws.h"
#include "analysis/results/diagnosis.h"

#include <vector>

namespace stickslip::gap {

/// Records, runs that are not the whole of one, and how data are held out.
void describe(const Rig& rig, const std::vector<Record>& records, Diagnosis& d);

/// What the mean level leaves of the rig's friction, what the best law leaves, and the noise.
void add_gap(const Rig& rig, double before, double after, double noise, Diagnosis& d);

/// What the page draws: the friction of every run, its level, and the best law.
std::vector<DiagnosedTrace> traces_of(const Rig& rig, const std::vector<Record>& records, RigLaw law,
                                      const RigNumbers& p);

}  // namespace stickslip::gap
