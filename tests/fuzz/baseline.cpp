// Any bytes as a baseline: boundaries that can be described, or a refusal.
#include "sweep/files/json/baseline_file.h"
#include "sweep/files/text/bad_input.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace stickslip;
    try {
        const fuzz::InputFile file({data, size});
        const auto watched = read_baseline(file.path());
        for (const Deviation& deviation : compare(watched, {watched.begin(), watched.begin() + watched.size() / 2}))
            describe(deviation);
    } catch (const BadInput& refusal) {
        fuzz::promise(!refusal.messages().empty(), "a refusal without a reason");
    }
    return 0;
}
