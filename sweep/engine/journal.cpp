#include "sweep/engine/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>

namespace stickslip {

Journal::Journal(std::filesystem::path directory, const Plan& plan)
    : directory_(std::move(directory)), header_(journal_header(plan))
{
}

Journal::~Journal()
{
    close();
}

std::error_code Journal::create()
{
    // The time makes the name new even where process numbers come round again, as in containers; O_EXCL proves it.
    const auto time = std::chrono::system_clock::now().time_since_epoch().count();
    path_ = directory_ / (host_name() + "-" + std::to_string(::getpid()) + "-" + std::to_string(time) + ".journal");
    file_ = FileHandle(::open(path_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_APPEND | O_CLOEXEC, 0666));
    if (!file_) return last_error();
    if (const auto error = write_all(file_.get(), std::as_bytes(std::span(&header_, 1)))) return error;
    size_ = sizeof header_;
    syncer_ = std::thread([this] { sync_now_and_then(); });
    return {};
}

std::variant<std::uint64_t, std::error_code> Journal::append(std::span<const std::byte> record)
{
    const std::scoped_lock lock(mutex_);
    if (!error_ && !file_) error_ = create();
    if (error_) return error_;
    error_ = write_all(file_.get(), record);
    if (error_) {
        // A torn record would be skipped by the reader anyway; cutting it off only keeps reports of damage for real
        // damage.
        [[maybe_unused]] const int ignored = ::ftruncate(file_.get(), static_cast<off_t>(size_));
        return error_;
    }
    dirty_ = true;
    const std::uint64_t offset = size_;
    size_ += record.size();
    return offset;
}

void Journal::sync_now_and_then()
{
    bool first = true;
    std::unique_lock lock(mutex_);
    while (!closing_ || dirty_) {
        wake_.wait_for(lock, std::chrono::seconds(sync_seconds), [this] { return closing_; });
        if (!dirty_) continue;
        dirty_ = false;
        lock.unlock();  // appends go on while the disk works
        std::error_code error;
        if (::fdatasync(file_.get()) != 0) error = last_error();
        if (first && !error) {
            try {
                sync_directory(directory_);
            } catch (const std::system_error& e) {
                error = e.code();
            }
        }
        first = false;
        lock.lock();
        if (error && !error_) error_ = error;
    }
}

std::error_code Journal::close()
{
    {
        const std::scoped_lock lock(mutex_);
        closing_ = true;
    }
    wake_.notify_all();
    if (syncer_.joinable()) syncer_.join();
    return error_;
}

}  // namespace stickslip
