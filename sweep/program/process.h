// What the program asks of the system that runs it.
#pragma once

namespace stickslip {

/// Standard streams that the caller has closed: their numbers would go to the next files that are opened, and what is
/// printed into these. They are opened for nothing, so that writing to them fails and is reported.
void keep_streams();

/// A file that grows beyond a limit (ulimit -f, a quota of a batch system) is reported as a full disk is, instead of
/// ending the program by a signal.
void survive_size_limits();

/// Interrupts that come when the answer stands, until the program has ended: they change nothing, and what they would
/// be noted in is gone by then.
struct LateInterruptsIgnored {
    LateInterruptsIgnored() = default;
    LateInterruptsIgnored(const LateInterruptsIgnored&) = delete;
    ~LateInterruptsIgnored();
};

/// Freed memory stays with the process up to a bound, and the heap grows in large steps: pages that go back and forth
/// are cleared by the kernel each time, which took a third of the time to compose a page.
void keep_freed_memory();

}  // namespace stickslip
