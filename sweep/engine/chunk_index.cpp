#include "sweep/engine/chunk_index.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace stickslip {
namespace {

constexpr std::size_t most_open_files = 200;

std::uint64_t size_of(int descriptor)
{
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

/// The next offset behind a damaged place at which the magic of a record stands. Records start at multiples of eight
/// bytes.
std::uint64_t next_magic(int descriptor, std::uint64_t offset, std::uint64_t size)
{
    std::array<std::uint64_t, 8192> words;
    while (offset + sizeof(ChunkHeader) <= size) {
        const std::size_t count = std::min<std::uint64_t>(words.size(), (size - offset) / sizeof(std::uint64_t));
        if (!read_exactly(descriptor, std::as_writable_bytes(std::span(words.data(), count)), offset)) return size;
        const auto end = words.begin() + static_cast<std::ptrdiff_t>(count);
        const auto found = std::find(words.begin(), end, ChunkHeader::expected_magic);
        offset += static_cast<std::uint64_t>(found - words.begin()) * sizeof(std::uint64_t);
        if (found != end) return offset;
    }
    return size;
}

/// Reads the record at the offset if a whole one stands there.
bool read_record(int descriptor, std::uint64_t offset, const Plan& plan, const RowFormat& format, ChunkHeader& header,
                 std::vector<std::byte>& payload)
{
    if (!read_exactly(descriptor, std::as_writable_bytes(std::span(&header, 1)), offset)) return false;
    if (!plausible(header, plan, format)) return false;
    payload.resize(header.payload_bytes);
    return read_exactly(descriptor, payload, offset + sizeof header) && verifies(header, payload);
}

void scan_file(const std::filesystem::path& path, const Plan& plan, ChunkIndex& index, ScanReport& report)
{
    const FileHandle file = open_file(path, O_RDONLY);
    const std::uint64_t size = size_of(file.get());
    const std::uint64_t damage_before = report.damaged_bytes;
    ++report.files;

    JournalHeader start;
    const bool whole_start = read_exactly(file.get(), std::as_writable_bytes(std::span(&start, 1)), 0);
    const HeaderCheck verdict = whole_start ? check(start, plan) : HeaderCheck::damaged;
    if (verdict == HeaderCheck::other_plan)
        throw std::runtime_error(fmt::format("{} belongs to another sweep", path.string()));
    if (verdict == HeaderCheck::damaged) report.damaged_bytes += std::min<std::uint64_t>(size, sizeof start);

    const RowFormat format(plan.nonlinear);
    const std::uint32_t number = index.add_file(path);
    std::vector<std::byte> payload;
    ChunkHeader header;
    std::uint64_t offset = sizeof start;
    while (offset + sizeof header <= size) {
        if (read_record(file.get(), offset, plan, format, header, payload)) {
            ++report.records;
            if (!index.add(header.chunk, number, offset, header.checksum)) ++report.duplicates;
            offset += sizeof header + header.payload_bytes;
        } else {
            const std::uint64_t next = next_magic(file.get(), offset + sizeof(std::uint64_t), size);
            report.damaged_bytes += next - offset;
            offset = next;
        }
    }
    if (offset < size) report.damaged_bytes += size - offset;
    if (report.damaged_bytes != damage_before) report.damaged_files.push_back(path.string());
}

}  // namespace

std::uint64_t ChunkIndex::count() const
{
    return static_cast<std::uint64_t>(
        std::ranges::count_if(places_, [](const Place& place) { return place.file != nowhere; }));
}

std::uint32_t ChunkIndex::add_file(const std::filesystem::path& path)
{
    files_.push_back(path);
    return static_cast<std::uint32_t>(files_.size() - 1);
}

bool ChunkIndex::add(std::uint64_t chunk, std::uint32_t file, std::uint64_t offset, std::uint64_t checksum)
{
    Place& place = places_[chunk];
    if (place.file == nowhere) {
        place = {file, offset, checksum};
        return true;
    }
    if (place.checksum != checksum)
        throw std::runtime_error(
            fmt::format("chunk {} has different results in {} and {}: programs or CPUs were mixed, or a "
                        "memory is faulty; remove the journal that you trust less",
                        chunk, files_[place.file].string(), files_[file].string()));
    return false;
}

void scan_journals(const std::filesystem::path& directory, const Plan& plan, ChunkIndex& index, ScanReport& report)
{
    if (!std::filesystem::exists(directory)) return;
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(directory))
        if (entry.path().extension() == ".journal") paths.push_back(entry.path());
    std::ranges::sort(paths);
    for (const auto& path : paths) scan_file(path, plan, index, report);
}

ChunkReader::ChunkReader(const Plan& plan, const ChunkIndex& index)
    : plan_(plan), index_(index), format_(plan.nonlinear), open_(index.files().size())
{
}

std::span<const std::byte> ChunkReader::read(std::uint64_t chunk)
{
    const auto& place = index_.place(chunk);
    FileHandle& file = open_.at(place.file);
    if (!file) {
        if (open_count_ == most_open_files) {
            for (FileHandle& other : open_) other = FileHandle();
            open_count_ = 0;
        }
        file = open_file(index_.files()[place.file], O_RDONLY);
        ++open_count_;
    }
    ChunkHeader header;
    if (!read_record(file.get(), place.offset, plan_, format_, header, buffer_) || header.chunk != chunk)
        throw std::runtime_error(
            fmt::format("{} was damaged while it was read; run the same command again to recompute what is "
                        "missing",
                        index_.files()[place.file].string()));
    return std::span(buffer_).first(format_.bytes_per_point() * header.count);
}

}  // namespace stickslip
