// Lines of a text file, plain or gzip, without holding more than one of them. Internal to sweep/files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct gzFile_s;

namespace stickslip::files {

class LineStream {
  public:
    /// Throws BadInput where the file cannot be opened.
    explicit LineStream(const std::filesystem::path& file);

    /// The next line without its end, valid until the next call; false at the end of the file. Throws BadInput for a
    /// damaged or cut-off archive and for a line longer than any row of numbers.
    bool next(std::string_view& line);

    /// The first bytes of the file, before the first next(): enough to tell text from anything else.
    std::string_view head();

    /// Reads the rest of an archive, whose checksum stands at its end: damage that explains more than its cells do.
    /// Throws BadInput for a damaged one; a plain file is left as it is. No line can be read after it.
    void verify_archive();

    /// Number of the line that next() returned last, from 1.
    std::uint64_t line_number() const { return line_number_; }

  private:
    struct Close {
        void operator()(gzFile_s* file) const;
    };
    void fill();
    /// A file without a single \n, as spreadsheets of old Macs write it, has \r between its lines.
    void learn_line_end();

    std::string name_;
    std::unique_ptr<gzFile_s, Close> file_;
    std::string buffer_;
    std::size_t begin_ = 0, end_ = 0;  ///< what of the buffer is not yet returned
    std::uint64_t line_number_ = 0;
    bool finished_ = false;
    char line_end_ = '\n';
};

}  // namespace stickslip::files
