#include "analysis/diagnosis/plant/observer.h"

namespace stickslip::gap {

void run_baseline(std::span<const Run> runs, const Kind& kind)
{
    Observer<lanes::Pack<2, 2>>(kind).through(runs);
}

void run_single(std::span<const Run> runs, const Kind& kind)
{
    Observer<lanes::Pack<1, 1>>(kind).through(runs);
}

}  // namespace stickslip::gap
