#include "analysis/diagnosis/plant/observer.h"

namespace stickslip::gap {

void run_avx512(std::span<const Run> runs, const Kind& kind)
{
    if (runs.size() > 4)
        Observer<lanes::Pack<8, 1>>(kind).through(runs);
    else
        Observer<lanes::Pack<4, 1>>(kind).through(runs);
}

}  // namespace stickslip::gap
