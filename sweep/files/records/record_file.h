// A measured record from CSV or .csv.gz.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/results/note.h"
#include "sweep/files/records/record_layout.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// A record and what a user should know about it. Neither sentences nor suspicions name the record: the caller does.
struct RecordReading {
    Record record;                      ///< in SI
    std::vector<std::string> warnings;  ///< columns that are not read, units in doubt
    /// What looks wrong in what was read: degrees in a column that should be radians, a motor that was off. Nothing
    /// should be concluded from a record with one that contradicts().
    std::vector<Note> suspicions;
    /// A signal with some values missing, and the place of the first, `file:line:column: signal: …`.
    std::vector<std::pair<std::string, std::string>> missing;
    /// What the log does not say and its reader took for granted.
    std::vector<std::string> guesses;
    /// Without a position: that, with the place and what the file has instead. Rigs do without one.
    std::string no_position;

    /// Warnings and suspicions, each in a sentence.
    std::vector<std::string> sentences() const;
};

/// Bounds the memory: read, a signal takes 8 bytes a row, 80 MB for 10^7 rows, 2.7 hours at 1 kHz. A diagnosis was seen
/// to take 400 to 800 bytes a row.
struct RecordLimits {
    std::uint64_t rows = 10'000'000;  ///< more are refused
};

/// Reads a table with a header row; commas, semicolons or tabs between the columns, lines that begin
/// with `#` are comments, rows
/// in ascending time, an empty cell or "nan" for a missing value. Columns carry the names of signals() or those of the
/// layout; others are ignored with a warning. Rows with torque_enable = 0 are kept.
/// Throws BadInput (`file:line:column: signal: …`, up to 20 errors) for: no header, no time, no measured signal, rows
/// of another length, cells that are no numbers, time that is missing, equal or falling, more rows than the limit, a
/// file that is no text, empty or cut off, a column of the layout that the file lacks.
RecordReading read_record(const std::filesystem::path& file, const Joint& joint, const RecordLayout& layout = {},
                          const RecordLimits& limits = {});

}  // namespace stickslip
