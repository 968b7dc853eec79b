#include "sweep/program/verbs/no_sliding.h"

#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"
#include "sweep/files/toml/stated_place.h"
#include "sweep/program/verbs/say.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/low_limit_text.h"
#include "sweep/words/plain_text.h"

namespace stickslip {

void say_no_sliding(const std::filesystem::path& file, const std::vector<std::string>& settings, const Joint& joint)
{
    if (possible_sliding(joint).reason != Reason::limit_too_low) return;
    const auto low = low_limit(joint, sliding_velocity(joint));
    if (!low) return;
    const auto side = plain_text(side_text(gear_side(joint), false));
    say("{}: {}: {}{}\n", stated_place(file, settings, low->path), low->path, plain_text(low_limit_words(*low, joint)),
        side.empty() ? "" : ". " + side);
}

}  // namespace stickslip
