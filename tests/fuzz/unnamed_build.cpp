// The instrumented build is made of a few rooms only and computes no results: it needs no fingerprint.
#include "sweep/engine/build.h"

namespace stickslip {

std::string program_version()
{
    return "fuzzed";
}

std::string build_fingerprint()
{
    return "fuzzed";
}

}  // namespace stickslip
