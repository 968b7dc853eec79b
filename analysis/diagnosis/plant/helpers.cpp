#include "analysis/diagnosis/plant/helpers.h"

namespace stickslip::gap {
namespace {

thread_local const Helpers* own = nullptr;

}  // namespace

Helpers::Helpers(const ParallelFor& run, const Unbegun* unbegun) : run_(&run), unbegun_(unbegun), before_(own)
{
    own = this;
}

Helpers::~Helpers()
{
    own = before_;
}

const ParallelFor* Helpers::of_this_thread()
{
    return own && (!own->unbegun_ || *own->unbegun_ == 0) ? own->run_ : nullptr;
}

}  // namespace stickslip::gap
