// Any bytes as a table of outcomes: rows that set what the header names, or a list of complaints.
#include "sweep/files/records/outcome_file.h"
#include "sweep/files/text/bad_input.h"
#include "tests/fuzz/input_file.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace stickslip;
    static const Joint joint;
    try {
        const fuzz::InputFile file({data, size});
        if (!is_outcome_file(file.path())) return 0;
        std::vector<std::string> warnings;
        const OutcomeTable table = read_outcomes(file.path(), joint, warnings);
        for (const OutcomeRow& row : table.rows) {
            fuzz::promise(row.settings.size() == table.paths.size(), "a row sets another number of things");
            for (const double value : row.settings) fuzz::promise(std::isfinite(value), "a setting that is not finite");
            fuzz::promise(!std::isinf(row.amplitude), "an infinite amplitude");
        }
    } catch (const BadInput& refusal) {
        fuzz::promise(!refusal.messages().empty(), "a refusal without a reason");
    }
    return 0;
}
