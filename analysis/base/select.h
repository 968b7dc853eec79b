// What code writes that runs on one number and on packs of them: the choices of simulation/lanes/pack.h for bare
// doubles. A pack's own are found by argument.
#pragma once
#include <cmath>

namespace stickslip {

inline double select(bool which, double yes, double no)
{
    return which ? yes : no;
}
inline bool any(bool which)
{
    return which;
}
inline double sine(double x)
{
    return std::sin(x);
}

}  // namespace stickslip
