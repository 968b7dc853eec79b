#include "analysis/diagnosis/plant/observer.h"

namespace stickslip::gap {

void run_avx2(std::span<const Run> runs, const Kind& kind)
{
    if (runs.size() > 4)
        through<lanes::Pack<4, 2>>(runs, kind);
    else
        through<lanes::Pack<4, 1>>(runs, kind);
}

}  // namespace stickslip::gap
