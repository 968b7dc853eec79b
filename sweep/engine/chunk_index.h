// What the journals hold: for every chunk of the plan where its verified record lies, if it has one.
#pragma once
#include "sweep/engine/journal_format.h"
#include "sweep/engine/posix.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace stickslip {

/// What reading the journals found.
struct ScanReport {
    std::uint64_t files = 0, records = 0;
    std::uint64_t duplicates = 0;     ///< the same chunk once more, equal bit for bit
    std::uint64_t damaged_bytes = 0;  ///< torn tails and records that do not verify: computed again
    std::vector<std::string> damaged_files;
};

/// 24 bytes a chunk, however many points a chunk has. has() and add() of different chunks may run at the same time.
class ChunkIndex {
  public:
    explicit ChunkIndex(const Plan& plan) : places_(plan.chunks()) {}

    bool has(std::uint64_t chunk) const { return places_[chunk].file != nowhere; }
    std::uint64_t count() const;

    /// A journal file that places may refer to; its number.
    std::uint32_t add_file(const std::filesystem::path& path);

    /// Enters a record that has verified. False if the chunk is known with the same content already.
    /// Throws std::runtime_error if it is known with other content: then builds or CPUs were mixed, or memory is
    /// faulty.
    bool add(std::uint64_t chunk, std::uint32_t file, std::uint64_t offset, std::uint64_t checksum);

    struct Place {
        std::uint32_t file = nowhere;
        std::uint64_t offset = 0, checksum = 0;
    };
    const Place& place(std::uint64_t chunk) const { return places_[chunk]; }
    const std::vector<std::filesystem::path>& files() const { return files_; }

  private:
    static constexpr std::uint32_t nowhere = ~std::uint32_t{0};
    std::vector<Place> places_;
    std::vector<std::filesystem::path> files_;
};

/// Reads every *.journal of the directory, in the order of their names, and enters each record that verifies. Damaged
/// parts are skipped and counted: behind a flipped bit reading goes on with the next whole record. Memory: one record.
/// Throws std::runtime_error for a journal of another plan and for records that contradict each other.
void scan_journals(const std::filesystem::path& directory, const Plan& plan, ChunkIndex& index, ScanReport& report);

/// Reads single chunks back. Not thread-safe.
class ChunkReader {
  public:
    ChunkReader(const Plan& plan, const ChunkIndex& index);

    /// The packed rows (RowFormat) of a chunk that the index has, verified anew; valid until the next call.
    /// Throws std::runtime_error if the record no longer verifies.
    std::span<const std::byte> read(std::uint64_t chunk);

  private:
    const Plan& plan_;
    const ChunkIndex& index_;
    const RowFormat format_;
    std::vector<FileHandle> open_;
    std::size_t open_count_ = 0;
    std::vector<std::byte> buffer_;
};

}  // namespace stickslip
