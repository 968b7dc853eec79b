#include "analysis/stability/warming.h"

#include "analysis/stability/linear_joint.h"

#include <algorithm>

namespace stickslip {

double warming(const Joint& joint)
{
    const Chain chain = chain_of(joint);
    double more = 0;
    for (int i = 0; i < chain.bodies; ++i)
        more += chain.body[i].ratio * std::max(0.0, chain.body[i].friction->drift.change);
    return joint.mechanism.model == Model::single_mass ? more / (1 - joint.friction.load_coefficient) : more;
}

}  // namespace stickslip
