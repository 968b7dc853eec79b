// Any bytes as plan.json, which merge reads from directories that others have filled: a plan or a refusal.
#include "sweep/engine/plan_file.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace stickslip;
    try {
        const Plan plan = plan_from_json(fuzz::text_of({data, size}));
        fuzz::promise(plan.chunks() > 0, "a plan without chunks");
    } catch (const std::runtime_error&) {
    }
    return 0;
}
