// Answers of the diagnosis in tests: none of them may contradict its own numbers.
#pragma once
#include "analysis/diagnosis/diagnose.h"
#include "analysis/results/contradictions.h"

#include <catch2/catch.hpp>

namespace stickslip::test {

inline gap::DiagnosisResult answer(const Joint& joint, const std::vector<Record>& records, const ParallelFor& parallel,
                                   const gap::DiagnosisOptions& options = {})
{
    auto result = gap::diagnose(joint, records, parallel, options);
    for (const auto contradiction : contradictions_in(result.diagnosis)) FAIL_CHECK(contradiction);
    return result;
}

}  // namespace stickslip::test
