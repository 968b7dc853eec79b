// What a diagnosis gives back.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// A diagnosis and the joint with the named effects in it (equal to the nominal joint where nothing was named).
struct DiagnosisResult {
    Diagnosis diagnosis;
    Joint after;
};

}  // namespace stickslip::gap
