#include "sweep/program/verbs/progress_line.h"

#include "sweep/program/verbs/say.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace stickslip {
namespace {

std::string duration(double seconds)
{
    if (!std::isfinite(seconds)) return "?";
    const auto s = static_cast<long long>(std::ceil(seconds));
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
    return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

/// Three digits: "631 k", "12.5", "0.31".
std::string rate(double per_second)
{
    return per_second < 1e3   ? fmt::format("{:.3g}", per_second)
           : per_second < 1e6 ? fmt::format("{:.3g} k", per_second / 1e3)
                              : fmt::format("{:.3g} M", per_second / 1e6);
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::update(const Progress& p)
{
    if (!terminal_ || p.total == 0) return;
    say("\r\033[K{:5.1f} %  {} of {} points  {} points/s  {} left",
        100.0 * static_cast<double>(p.done) / static_cast<double>(p.total), p.done, p.total, rate(p.rate),
        duration(p.seconds_left));
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressLine::say_next(const std::string& what)
{
    if (!terminal_) return;
    say("\r\033[K{}", what);
    std::fflush(stderr);
    drawn_ = true;
}

void ProgressLine::end()
{
    if (drawn_) say("\r\033[K");
    drawn_ = false;
}

}  // namespace stickslip
