#include "sweep/program/process.h"

#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/verbs.h"

#include <fcntl.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace stickslip {
namespace {

std::atomic<bool>* interrupt_flag = nullptr;
std::string_view last_words;

extern "C" void on_interrupt(int)
{
    interrupt_flag->store(true);
}

extern "C" void leave_at_once(int)
{
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, last_words.data(), last_words.size());
    ::_exit(exit_interrupted);
}

void handle(void (*handler)(int), int flags)
{
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

void leave_on_interrupts(std::string_view words)
{
    last_words = words;
    handle(leave_at_once, 0);
}

void catch_interrupts(Invocation& invocation)
{
    interrupt_flag = &invocation.interrupted;
    handle(on_interrupt, SA_RESETHAND);  // a second Ctrl-C ends the program the ordinary way
}

LateInterruptsIgnored::~LateInterruptsIgnored()
{
    handle(SIG_IGN, 0);
}

void keep_streams()
{
    // the lowest free number is taken: those below are open by then
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF)
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void keep_freed_memory()
{
#ifdef __GLIBC__
    constexpr int megabyte = 1 << 20;
    mallopt(M_TOP_PAD, 32 * megabyte);
    mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
    mallopt(M_MMAP_THRESHOLD, 32 * megabyte);  // larger arrays, those of a large sweep, go back at once
#endif
}

void survive_size_limits()
{
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace stickslip
