// The header row of a record: which column is which signal. Internal to sweep/files.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/files/records/record_layout.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::files {

struct RecordHeader {
    /// A column of the file; no signal: it is not read.
    struct Column {
        const Signal* signal = nullptr;
        Scaling scaling;
    };
    char separator = ',';
    std::vector<Column> columns;
    std::vector<std::string> warnings, errors;  ///< errors stand with their place
    std::string no_position;                    ///< to say, with the place, where the record has no position
};

/// Where the header row stands.
struct HeaderPlace {
    std::string file;
    std::uint64_t line = 0;
};

/// Matches names with the layout first, then with signals(). Errors: no header, a name twice, a column of the layout
/// that is not there, no time, no measured signal. Of two drive signals the one that the joint's actuator takes is
/// read.
RecordHeader match_header(std::string_view line, const HeaderPlace& place, const RecordLayout::Rule& rule,
                          const Joint& joint);

}  // namespace stickslip::files
