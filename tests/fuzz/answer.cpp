// Any bytes as diagnosis.json, which compare, timeline and check read: facts of a diagnosis, or a refusal.
#include "sweep/files/json/diagnosis_file.h"
#include "sweep/files/text/bad_input.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace stickslip;
    try {
        const fuzz::InputFile file({data, size});
        read_diagnosis(file.path());
    } catch (const BadInput& refusal) {
        fuzz::promise(!refusal.messages().empty(), "a refusal without a reason");
    }
    return 0;
}
