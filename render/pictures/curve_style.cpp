#include "render/pictures/curve_style.h"

#include "render/pictures/signed_field.h"

namespace stickslip::drawing {

CurveStyle curve_style(Curve::Kind kind)
{
    switch (kind) {
        case Curve::Kind::velocity_only:
            return {{from_hex(0xa4006d), 2.6, {9, 5}}, "boundary, velocity-only model"};
        case Curve::Kind::state_variable:
            return {{field_ink, 2.6, {}}, "boundary, with frictional memory"};
        case Curve::Kind::fold:
            return {{from_hex(0x00594c), 2.4, {10, 4, 2, 4}}, "fold of limit cycles"};
        case Curve::Kind::ideal_loop:
            return {{from_hex(0x00506e), 3, {3, 3}}, "boundary, the paper's ideal loop"};
        case Curve::Kind::outcome:
            break;
    }
    return {{from_hex(0x3d2f9c), 2.2, {2.5, 3}}, "boundary, nonlinear simulation"};
}

Pen halo_of(const Pen& pen)
{
    return {field_halo, pen.width + 3, {}};
}

}  // namespace stickslip::drawing
