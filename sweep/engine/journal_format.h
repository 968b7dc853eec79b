// The bytes of a journal: one header, then records, each a multiple of eight bytes long. All numbers little-endian.
#pragma once
#include "sweep/engine/plan.h"
#include "sweep/engine/row_format.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace stickslip {

/// First in the file: whose journal this is.
struct JournalHeader {
    static constexpr std::uint64_t expected_magic = 0x314c4e524a535353;  // "SSSJRNL1"
    std::uint64_t magic = expected_magic;
    std::uint64_t plan_high = 0, plan_low = 0;
    std::uint64_t bytes_per_point = 0;
    std::uint64_t checksum = 0;  ///< XXH3-64 of the fields above
};

/// In front of the packed rows of one chunk (RowFormat), which are padded with zeros.
struct ChunkHeader {
    static constexpr std::uint64_t expected_magic =
        0x4b4e5548435353ab;  // no ASCII text, no small number, no usual double
    std::uint64_t magic = expected_magic;
    std::uint64_t plan_high = 0, plan_low = 0;
    std::uint64_t chunk = 0;
    std::uint32_t count = 0;          ///< points
    std::uint32_t payload_bytes = 0;  ///< with padding
    std::uint64_t checksum = 0;       ///< XXH3-64 of the payload, seeded with that of the fields above
};
static_assert(sizeof(JournalHeader) == 40 && sizeof(ChunkHeader) == 48);

JournalHeader journal_header(const Plan& plan);

/// Is this the header of a journal of that plan?
enum class HeaderCheck { ours, other_plan, damaged };
HeaderCheck check(const JournalHeader& header, const Plan& plan);

/// Bytes of the record of a chunk of that many points.
std::size_t record_bytes(const RowFormat& format, std::uint64_t count);

/// A record ready to be written: rows packed, header filled in, checksum computed. Reuses `buffer`; allocates only to
/// grow.
void encode_record(const Plan& plan, const RowFormat& format, std::uint64_t chunk, std::span<const PointResult> rows,
                   std::vector<std::byte>& buffer);

/// Could this be the header of a record of that plan? Its checksum is not looked at.
bool plausible(const ChunkHeader& header, const Plan& plan, const RowFormat& format);

/// Does the payload belong to the header, bit for bit?
bool verifies(const ChunkHeader& header, std::span<const std::byte> payload);

}  // namespace stickslip
