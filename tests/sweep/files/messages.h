// What a reader of files says about bad input.
#pragma once
#include "sweep/files/text/bad_input.h"

#include <string>
#include <vector>

namespace stickslip {

/// The messages of the BadInput that `action` throws; empty if it throws none.
template <class Action>
std::vector<std::string> messages_of(Action&& action)
{
    try {
        action();
    } catch (const BadInput& bad) {
        return bad.messages();
    }
    return {};
}

}  // namespace stickslip
