#include "sweep/engine/build.h"

#include "build_info.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>

namespace stickslip {
namespace {

/// glibc picks its exp, log, sin and pow by these; their last bits differ between the variants.
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

}  // namespace

std::string program_version()
{
    return build_info::version;
}

std::string build_fingerprint()
{
    return fmt::format("stickslip {} sources {}; {}; {}; glibc {}; {}", build_info::version, build_info::sources,
                       build_info::compiler, build_info::flags, gnu_get_libc_version(), cpu_kind());
}

}  // namespace stickslip
