#include "sweep/files/text/line_stream.h"

#include "sweep/files/text/bad_input.h"

#include <zlib.h>

#include <cstring>

namespace stickslip::files {
namespace {

constexpr std::size_t first_buffer = 1u << 16;  // most rows are short, and so are many records
constexpr std::size_t longest_line = 1u << 20;  // far beyond any row; a file without line ends is no table

}  // namespace

void LineStream::Close::operator()(gzFile_s* file) const
{
    gzclose(file);
}

LineStream::LineStream(const std::filesystem::path& file) : name_(file.string())
{
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw BadInput(name_ + ": there is no such file");
    if (std::filesystem::is_directory(file, error)) throw BadInput(name_ + ": is a folder, expected a CSV file");
    file_.reset(gzopen(name_.c_str(), "rb"));
    if (!file_) throw BadInput(name_ + ": cannot be opened for reading");
    gzbuffer(file_.get(), first_buffer);
    buffer_.resize(first_buffer);
}

void LineStream::fill()
{
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    if (2 * end_ > buffer_.size()) buffer_.resize(2 * buffer_.size());
    const int got = gzread(file_.get(), buffer_.data() + end_, static_cast<unsigned>(buffer_.size() - end_));
    int code = Z_OK;
    std::string why = gzerror(file_.get(), &code);
    if (const auto name = why.rfind(": "); name != std::string::npos) why.erase(0, name + 2);
    if (got < 0 || code == Z_BUF_ERROR)
        throw BadInput(name_ + ": the archive is damaged or cut off" +
                       (line_number_ > 0 ? " behind line " + std::to_string(line_number_) : "") +
                       (code == Z_ERRNO ? "" : " (" + why + ")"));
    finished_ = got == 0;
    end_ += static_cast<std::size_t>(got);
    if (line_number_ == 0) learn_line_end();
}

void LineStream::learn_line_end()
{
    const std::string_view known(buffer_.data(), end_);
    const auto mark = known.find('\r');
    const bool mac = mark < known.size() && (mark + 1 < known.size() || finished_) && known.find('\n') == known.npos;
    line_end_ = mac ? '\r' : '\n';
}

void LineStream::verify_archive()
{
    if (gzdirect(file_.get())) return;
    line_number_ = 0;  // a wrong checksum does not tell the place
    for (end_ = begin_ = 0; !finished_; end_ = begin_ = 0) fill();
}

std::string_view LineStream::head()
{
    constexpr std::size_t enough = 4096;
    if (end_ == 0) fill();
    return std::string_view(buffer_.data(), end_).substr(0, enough);
}

bool LineStream::next(std::string_view& line)
{
    while (true) {
        const char* from = buffer_.data() + begin_;
        const void* stop = std::memchr(from, line_end_, end_ - begin_);
        if (!stop && end_ - begin_ > longest_line)
            throw BadInput(name_ + ":" + std::to_string(line_number_ + 1) +
                           ":1: the line is longer than 1 MiB, this is not a table of numbers");
        if (!stop && !finished_) {
            fill();
            continue;
        }
        if (!stop && begin_ == end_) return false;
        const std::size_t length =
            stop ? static_cast<std::size_t>(static_cast<const char*>(stop) - from) : end_ - begin_;
        line = {from, length};
        if (line.ends_with('\r')) line.remove_suffix(1);
        begin_ += length + (stop ? 1 : 0);
        // spreadsheets begin their UTF-8 with a mark
        if (++line_number_ == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
        return true;
    }
}

}  // namespace stickslip::files
