// Any bytes as a reference for `simulate`: columns of equal length in ascending time, or a list of complaints.
#include "sweep/files/records/reference_file.h"
#include "sweep/files/text/bad_input.h"
#include "tests/fuzz/input_file.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace stickslip;
    try {
        const fuzz::InputFile file({data, size});
        const ReferenceMotion motion = read_reference(file.path(), Units(Motion::revolute));
        const std::size_t rows = motion.time.size();
        fuzz::promise(rows >= 2, "a motion without an interval");
        for (const auto* column : {&motion.position, &motion.velocity, &motion.feed_forward}) {
            fuzz::promise(column->empty() || column->size() == rows, "columns of different length");
            for (const double value : *column) fuzz::promise(std::isfinite(value), "a value that is not finite");
        }
        for (std::size_t k = 1; k < rows; ++k)
            fuzz::promise(motion.time[k] > motion.time[k - 1], "time that does not ascend");
    } catch (const BadInput& refusal) {
        fuzz::promise(!refusal.messages().empty(), "a refusal without a reason");
    }
    return 0;
}
