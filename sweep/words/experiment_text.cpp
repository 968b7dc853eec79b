#include "sweep/words/experiment_text.h"

namespace stickslip {

std::string_view motion_text(TestMotion motion)
{
    switch (motion) {
        case TestMotion::none:
            break;
        case TestMotion::slow_stroke:
            return "to and fro over the stroke at a fiftieth of the largest speed";
        case TestMotion::small_sine:
            return "a sine of small amplitude with many reversals";
        case TestMotion::falling_sine:
            return "a sine from 0.2 to 5 Hz whose amplitude falls as its frequency rises";
        case TestMotion::steps_and_rests:
            return "steps over the whole stroke with standstills of one and a half seconds";
        case TestMotion::steps_of_speed:
            return "steps of speed: a tenth, a third and the whole of the largest speed";
        case TestMotion::rig_step_down:
            return "a step down to a tenth of the first speed and back";
        case TestMotion::rig_step_up:
            return "a step up to ten times the first speed and back";
        case TestMotion::rig_hold:
            return "a hold at rest between two slides at the first speed";
    }
    return "";
}

}  // namespace stickslip
