// Where results go first: an append-only file of this process alone. What it holds survives a kill at any instant.
#pragma once
#include "sweep/engine/journal_format.h"
#include "sweep/engine/posix.h"

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>
#include <thread>
#include <variant>

namespace stickslip {

/// Appends records to one file, HOST-PID-TIME.journal, which is made at the first append and never opened for writing
/// again. Thread-safe. A killed process loses nothing that append has returned from; a power cut at most the last
/// sync_seconds.
class Journal {
  public:
    static constexpr int sync_seconds = 3;

    /// `directory` must exist.
    Journal(std::filesystem::path directory, const Plan& plan);
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;
    ~Journal();

    /// Writes one record (encode_record) and returns its offset, or why it could not be written: disk full, quota,
    /// device error. After an error the file is cut back to its last whole record and every further append fails alike.
    std::variant<std::uint64_t, std::error_code> append(std::span<const std::byte> record);

    /// Waits until everything appended is on the disk. The first error of the journal's life, if there was one.
    std::error_code close();

    /// The file; empty while nothing has been appended.
    const std::filesystem::path& path() const { return path_; }

  private:
    std::error_code create();
    void sync_now_and_then();

    const std::filesystem::path directory_;
    const JournalHeader header_;
    std::filesystem::path path_;
    FileHandle file_;
    std::uint64_t size_ = 0;  ///< whole records only

    std::mutex mutex_;  ///< guards everything above and below
    std::condition_variable wake_;
    std::error_code error_;
    bool dirty_ = false, closing_ = false;
    std::thread syncer_;
};

}  // namespace stickslip
