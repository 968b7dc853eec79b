// Which column of a foreign file is which signal, in which unit: the [record] table of a joint file or of a sidecar.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/files/records/signals.h"
#include "sweep/files/text/units.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip {

/// How a number of a file becomes SI: value · multiply / divide + add.
struct Scaling {
    double multiply = 1, divide = 1, add = 0;
    double operator()(double value) const { return value * multiply / divide + add; }
    bool changes() const { return multiply != divide || add != 0; }
};

/// What a unit makes of a number, then a factor and an offset in SI.
inline Scaling scaling_of(const Unit& unit, double scale = 1, double offset = 0)
{
    return {unit.factor * scale * std::pow(10.0, std::max(0, unit.decimals)),
            std::pow(10.0, std::max(0, -unit.decimals)), unit.offset * scale + offset};
}

struct RecordLayout {
    struct Column {
        std::string signal, name;
        Scaling scaling;
        std::string where;  ///< file:line:column of the entry, for messages
        bool unit_named = false;
    };
    /// What holds for the files whose name matches the pattern (`*`, `?`, `[…]`).
    struct Rule {
        std::string pattern = "*";
        std::vector<Column> columns;
        std::vector<std::pair<std::string, double>> constants;  ///< signal → value of every row
        std::vector<std::pair<std::string, double>> overrides;  ///< path of the joint → value
        std::optional<bool> at_rest_at_start;
        std::vector<std::string> others;  ///< columns of other joints: left alone without a word
    };
    std::vector<Rule> rules;  ///< later ones win

    /// Everything that holds for one file, as a single rule.
    Rule rule_for(const std::string& file_name) const;
};

/// Reads
///   [record]
///   at_rest_at_start = true
///   [record.columns]
///   time = "t"                                                        # a name; the values are SI
///   position = { name = "angle_deg", unit = "deg", scale = -1, offset = "2 deg" }   # SI = scale · value + offset
///   [record.constants]
///   supply_voltage = "12 V"                                           # for signals without a column
///   [record.files."kp100-*"]
///   control.k_p = 100                                                 # or k_p, where one number has that key
/// of a joint file, or the same of a sidecar (with or without the [record] header). `columns`, `constants` and
/// at_rest_at_start may stand under a file pattern too. No table: an empty layout. Throws BadInput with every error.
RecordLayout read_record_layout(const std::filesystem::path& file, const Joint& joint);
RecordLayout read_record_layout_text(std::string_view text, const std::string& name, const Joint& joint);

/// The layout for one record: that of the joint file, then `record.toml` beside the record, where there is one.
RecordLayout record_layout_for(const std::filesystem::path& record, const std::filesystem::path& joint_file,
                               const Joint& joint);

}  // namespace stickslip
