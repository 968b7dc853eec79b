// Any bytes as joint.toml: a joint or a list of complaints; a joint that is written down reads back as itself.
#include "analysis/joint/parameters.h"
#include "sweep/files/records/record_layout.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/joint_file.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace stickslip;
    const auto text = fuzz::text_of({data, size});
    try {
        const Joint joint = read_joint_text(text, "joint.toml", "/nonexistent");
        const std::string written = joint_text(joint);
        const Joint again = read_joint_text(written, "again.toml", "/nonexistent");
        fuzz::promise(canonical_text(joint) == canonical_text(again), "a joint changes when it is written and read");
        read_record_layout_text(text, "joint.toml", joint);
    } catch (const BadInput& refusal) {
        fuzz::promise(!refusal.messages().empty(), "a refusal without a reason");
    }
    return 0;
}
