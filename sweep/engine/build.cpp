#include "sweep/engine/build.h"

#include "analysis/simulation/lanes/instructions.h"
#include "build_info.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>
#include <xxhash.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace stickslip {
namespace {

/// The lanes' vector code and Eigen's are fixed when they are compiled; what the machine has is reported for the
/// reader.
std::string cpu_kind()
{
    utsname machine{};
    uname(&machine);
    std::string kind = machine.machine;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) kind += " avx2";
    if (__builtin_cpu_supports("fma")) kind += " fma";
    if (__builtin_cpu_supports("fma4")) kind += " fma4";
    if (__builtin_cpu_supports("avx512f")) kind += " avx512f";
#endif
    return kind;
}

/// glibc picks its exp, log, sin and pow when a program starts, by the CPU and by GLIBC_TUNABLES, and their last bits
/// differ between the variants: their answers tell which ones are at work, whatever the reason.
std::uint64_t mathematics()
{
    constexpr int arguments = 4096;
    constexpr double golden = 0.6180339887498949;  // spreads the arguments evenly over decades
    std::vector<double> answers;
    for (int i = 1; i <= arguments; ++i) {
        const double even = std::fmod(i * golden, 1.0), x = std::exp2(16 * even - 8), y = 4 * even - 2;
        answers.insert(answers.end(),
                       {std::exp(y), std::expm1(y), std::log(x), std::log1p(x), std::log10(x), std::pow(x, y),
                        std::sin(x), std::cos(x), std::tanh(y), std::sinh(y), std::asinh(x), std::atan2(x, y),
                        std::cbrt(x), std::hypot(x, y), std::exp2(y), std::log2(x)});
    }
    return XXH3_64bits(answers.data(), answers.size() * sizeof(double));
}

}  // namespace

std::string program_version()
{
    return build_info::version;
}

std::string method_hash()
{
    return build_info::sources;
}

std::string build_fingerprint()
{
    return fmt::format("stickslip {} sources {}; {}; {}; glibc {}; {}; lanes {}; mathematics {:016x}",
                       build_info::version, build_info::sources, build_info::compiler, build_info::flags,
                       gnu_get_libc_version(), cpu_kind(), lanes::name_of(lanes::best_instructions()), mathematics());
}

}  // namespace stickslip
