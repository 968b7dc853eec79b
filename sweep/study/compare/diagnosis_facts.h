// What one diagnosis says that another can be held against: the numbers of diagnosis.json, read back.
#pragma once
#include "analysis/results/diagnosis.h"

#include <string>
#include <vector>

namespace stickslip {

/// A number of the joint as a diagnosis found it.
struct FoundNumber {
    enum class Of {
        sheet,      ///< of the data sheet, with the named cause in it: "Coulomb level"
        parameter,  ///< of the named cause
        correction  ///< refitted beside the cause
    };
    Of of = Of::parameter;
    FittedParameter number;
};

struct DiagnosisFacts {
    std::string source;  ///< its file
    Verdict verdict = Verdict::insufficient_data;
    bool interrupted = false;
    std::vector<std::string> causes;  ///< that were named together; none without a gap
    double probability = 0;
    std::vector<std::vector<std::string>> ambiguous_with;
    std::vector<FoundNumber> numbers;
    std::vector<SignalGap> gap;
    OverallGap overall;

    bool differs() const { return verdict == Verdict::gap || verdict == Verdict::unknown; }
    bool answered() const { return verdict != Verdict::insufficient_data && !interrupted; }
};

}  // namespace stickslip
