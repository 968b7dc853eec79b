#include "sweep/engine/run_record.h"

#include "sweep/engine/posix.h"

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>
#include <thread>

namespace stickslip {
namespace {

std::string cpu_model()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(std::min(line.find(": ") + 2, line.size()));
    return "unknown";
}

const char* name_of(RunEnd end)
{
    switch (end) {
        case RunEnd::complete:
            return "complete";
        case RunEnd::interrupted:
            return "interrupted";
        case RunEnd::write_failed:
            return "write-failed";
    }
    return "unknown";
}

}  // namespace

void write_run_record(const std::filesystem::path& path, const Plan& plan, RunEnd end, const ComputeReport& computed,
                      const ScanReport& scan, std::uint64_t resumed_chunks, Shard shard,
                      const std::optional<MergeReport>& merged)
{
    nlohmann::ordered_json json = {
        {"format", "stickslip-run/1"},
        {"plan_id", to_text(plan.id)},
        {"end", name_of(end)},
        {"ended_at", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()))},
        {"host", host_name()},
        {"cpu", cpu_model()},
        {"cores", std::thread::hardware_concurrency()},
        {"threads", computed.threads},
        {"compute_seconds", computed.seconds},
        {"points_computed", computed.points},
        {"points_per_second", computed.seconds > 0 ? static_cast<double>(computed.points) / computed.seconds : 0.0},
        {"chunks_computed", computed.chunks},
        {"chunks_resumed", resumed_chunks},
        {"chunks_in_plan", plan.chunks()},
        {"damaged_bytes_skipped", scan.damaged_bytes},
    };
    if (!shard.whole()) json["shard"] = fmt::format("{}/{}", shard.index, shard.count);
    if (merged) json["merge_seconds"] = merged->seconds;
    if (!computed.message.empty()) json["message"] = computed.message;
    replace_file(path, json.dump(1) + "\n");
}

}  // namespace stickslip
