#include "analysis/diagnosis/plant/observer.h"

namespace stickslip::gap {

void run_baseline(std::span<const Run> runs, const Kind& kind)
{
    through<lanes::Pack<2, 2>>(runs, kind);
}

void run_single(std::span<const Run> runs, const Kind& kind)
{
    through<lanes::Pack<1, 1>>(runs, kind);
}

}  // namespace stickslip::gap
