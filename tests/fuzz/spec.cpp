// Any bytes as spec.toml: a sweep that a plan can be made of, or a list of complaints.
#include "sweep/engine/plan.h"
#include "sweep/engine/plan_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/spec_file.h"
#include "tests/fuzz/input_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace stickslip;
    const std::string text(fuzz::text_of({data, size}));
    try {
        const Spec spec = read_spec_text(text, "spec.toml", "/nonexistent");
        design_joint(spec);
        const Plan plan = make_plan(spec.joint, spec.axes, {.title = spec.title, .spec = text});
        fuzz::promise(plan.points == spec.points(), "the plan has another number of points than its spec");
        if (plan.points < 1000)
            fuzz::promise(plan_from_json(to_json(plan)).id == plan.id, "a plan changes when it is written and read");
    } catch (const BadInput& refusal) {
        fuzz::promise(!refusal.messages().empty(), "a refusal without a reason");
    }
    return 0;
}
