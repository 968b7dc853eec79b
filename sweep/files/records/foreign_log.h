// A log that the Python readers turn into a table: MCAP, ROS 1 bag, Parquet, SAGE, BAM, .npz, .mat, HDF5, NetCDF.
#pragma once
#include "sweep/files/records/joint_log.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// The words of `python3 -m stickslip.convert LOG TABLE …`.
std::vector<std::string> conversion_command(const std::string& log, const std::string& table, const std::string& joint,
                                            const LogOptions& options);

/// Runs such a command; its exit code, or 128 + the signal that ended it. What it says goes to `said`, and what it
/// prints nowhere; without `said` both go where this program's own goes. An interrupt of this program is passed on.
/// Throws BadInput if there is no Python.
int run_conversion(std::vector<std::string> words, std::string* said = nullptr);

/// The table of one joint, in a folder that goes with this object.
class ForeignLog {
  public:
    /// Throws BadInput with what the reader says of a log that it cannot read.
    ForeignLog(const std::filesystem::path& log, const std::string& joint, const LogOptions& options);
    ~ForeignLog();
    ForeignLog(const ForeignLog&) = delete;
    ForeignLog& operator=(const ForeignLog&) = delete;

    const std::filesystem::path& table() const { return table_; }
    /// What the log does not say and the reader took for granted.
    const std::vector<std::string>& guesses() const { return guesses_; }
    /// Messages about the table, as ones about the log.
    std::vector<std::string> as_of_the_log(std::vector<std::string> messages) const;

  private:
    std::filesystem::path log_, folder_, table_;
    std::vector<std::string> guesses_;
};

}  // namespace stickslip
