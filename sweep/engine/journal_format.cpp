#include "sweep/engine/journal_format.h"

#include <xxhash.h>

#include <bit>
#include <cstring>

namespace stickslip {
namespace {

static_assert(std::endian::native == std::endian::little, "journals are written as they lie in memory");

std::uint64_t checksum_of(const JournalHeader& header)
{
    return XXH3_64bits(&header, offsetof(JournalHeader, checksum));
}

std::uint64_t checksum_of(const ChunkHeader& header, std::span<const std::byte> payload)
{
    const std::uint64_t seed = XXH3_64bits(&header, offsetof(ChunkHeader, checksum));
    return XXH3_64bits_withSeed(payload.data(), payload.size(), seed);
}

std::size_t padded(std::size_t bytes)
{
    return (bytes + 7) / 8 * 8;
}

}  // namespace

JournalHeader journal_header(const Plan& plan)
{
    JournalHeader header;
    header.plan_high = plan.id.high;
    header.plan_low = plan.id.low;
    header.bytes_per_point = RowFormat(plan.nonlinear).bytes_per_point();
    header.checksum = checksum_of(header);
    return header;
}

HeaderCheck check(const JournalHeader& header, const Plan& plan)
{
    if (header.magic != JournalHeader::expected_magic || header.checksum != checksum_of(header))
        return HeaderCheck::damaged;
    return header.checksum == journal_header(plan).checksum ? HeaderCheck::ours : HeaderCheck::other_plan;
}

std::size_t record_bytes(const RowFormat& format, std::uint64_t count)
{
    return sizeof(ChunkHeader) + padded(format.bytes_per_point() * count);
}

void encode_record(const Plan& plan, const RowFormat& format, std::uint64_t chunk, std::span<const PointResult> rows,
                   std::vector<std::byte>& buffer)
{
    buffer.resize(record_bytes(format, rows.size()));
    const std::span payload = std::span(buffer).subspan(sizeof(ChunkHeader));
    const std::size_t used = format.bytes_per_point() * rows.size();
    format.pack(rows, payload.data());
    std::memset(payload.data() + used, 0, payload.size() - used);

    ChunkHeader header;
    header.plan_high = plan.id.high;
    header.plan_low = plan.id.low;
    header.chunk = chunk;
    header.count = static_cast<std::uint32_t>(rows.size());
    header.payload_bytes = static_cast<std::uint32_t>(payload.size());
    header.checksum = checksum_of(header, payload);
    std::memcpy(buffer.data(), &header, sizeof header);
}

bool plausible(const ChunkHeader& header, const Plan& plan, const RowFormat& format)
{
    return header.magic == ChunkHeader::expected_magic && header.plan_high == plan.id.high &&
           header.plan_low == plan.id.low && header.chunk < plan.chunks() &&
           header.count == plan.range(header.chunk).count &&
           sizeof header + header.payload_bytes == record_bytes(format, header.count);
}

bool verifies(const ChunkHeader& header, std::span<const std::byte> payload)
{
    return payload.size() == header.payload_bytes && header.checksum == checksum_of(header, payload);
}

}  // namespace stickslip
