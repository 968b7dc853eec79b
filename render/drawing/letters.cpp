#include "render/drawing/letters.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace stickslip::drawing {
namespace {

/// Takes the next character off the front; a byte that belongs to none reads as U+FFFD.
char32_t next_character(std::string_view& text)
{
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t more = first < 0x80 ? 0 : first < 0xc2 ? 4 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
    text.remove_prefix(1);
    if (more > text.size()) return U'\ufffd';
    char32_t character = more == 0 ? first : first & (0x3f >> more);
    for (std::size_t i = 0; i < more; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xc0) != 0x80) return U'\ufffd';
        character = character << 6 | (byte & 0x3f);
    }
    text.remove_prefix(more);
    return character;
}

struct Closed {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using Face = std::unique_ptr<std::remove_pointer_t<FT_Face>, Closed>;

/// One library and one open file a typeface for each thread: FreeType lets no two threads share a face.
FT_Face face_of(const std::string& file)
{
    struct Library {
        FT_Library handle = nullptr;
        Library()
        {
            if (FT_Init_FreeType(&handle)) throw std::runtime_error("FreeType does not start");
        }
        ~Library() { FT_Done_FreeType(handle); }
    };
    thread_local const Library library;
    thread_local std::map<std::string, Face> faces;
    Face& face = faces[file];
    if (!face) {
        FT_Face opened = nullptr;
        if (FT_New_Face(library.handle, file.c_str(), 0, &opened))
            throw std::runtime_error(file + ": is no typeface that FreeType reads");
        face.reset(opened);
    }
    return face.get();
}

/// Calls `visit(pen)` with the glyph of each character loaded and the pen before it; returns the pen behind the last.
/// Everything in units of the typeface.
template <class Visit>
double write(FT_Face face, std::string_view text, Visit&& visit)
{
    double pen = 0;
    FT_UInt before = 0;
    while (!text.empty()) {
        const FT_UInt glyph = FT_Get_Char_Index(face, next_character(text));
        FT_Vector kerning{};
        if (before && glyph) FT_Get_Kerning(face, before, glyph, FT_KERNING_UNSCALED, &kerning);
        pen += static_cast<double>(kerning.x);
        if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE)) throw std::runtime_error("a letter cannot be read");
        visit(pen);
        pen += static_cast<double>(face->glyph->metrics.horiAdvance);
        before = glyph;
    }
    return pen;
}

/// Data of an SVG path, from outlines in units of the typeface.
class Path {
  public:
    Path(double scale, double degrees)
        : cosine_(scale * std::cos(degrees * M_PI / 180)), sine_(scale * std::sin(degrees * M_PI / 180))
    {
    }
    void start(double pen) { pen_ = pen; }
    void add(char command, std::initializer_list<const FT_Vector*> points)
    {
        data_ += command;
        for (const FT_Vector* p : points) {
            const double along = pen_ + static_cast<double>(p->x), up = static_cast<double>(p->y);
            number(along * cosine_ - up * sine_);
            number(-along * sine_ - up * cosine_);
        }
    }
    std::string data() && { return std::move(data_); }

  private:
    void number(double value)
    {
        const long tenths = std::lround(10 * value);
        char digits[24];
        char* const end = std::to_chars(digits, digits + sizeof digits, std::abs(tenths) / 10).ptr;
        if (tenths < 0)
            data_ += '-';
        else if (data_.back() >= '0' && data_.back() <= '9')
            data_ += ' ';
        data_.append(digits, end);
        if (tenths % 10) (data_ += '.') += static_cast<char>('0' + std::abs(tenths) % 10);
    }

    double cosine_, sine_, pen_ = 0;
    std::string data_;
};

}  // namespace

double text_advance(const std::string& font_file, std::string_view text)
{
    const FT_Face face = face_of(font_file);
    return write(face, text, [](double) {}) / face->units_per_EM;
}

std::string outlines(const std::string& font_file, std::string_view text, double size, double angle)
{
    const FT_Face face = face_of(font_file);
    Path path(size / face->units_per_EM, angle);
    FT_Outline_Funcs draw{};
    draw.move_to = [](const FT_Vector* to, void* out) { return static_cast<Path*>(out)->add('M', {to}), 0; };
    draw.line_to = [](const FT_Vector* to, void* out) { return static_cast<Path*>(out)->add('L', {to}), 0; };
    draw.conic_to = [](const FT_Vector* by, const FT_Vector* to, void* out) {
        return static_cast<Path*>(out)->add('Q', {by, to}), 0;
    };
    draw.cubic_to = [](const FT_Vector* by, const FT_Vector* and_by, const FT_Vector* to, void* out) {
        return static_cast<Path*>(out)->add('C', {by, and_by, to}), 0;
    };
    write(face, text, [&](double pen) {
        path.start(pen);
        if (FT_Outline_Decompose(&face->glyph->outline, &draw, &path))
            throw std::runtime_error("a letter has no outline");
    });
    return std::move(path).data();
}

}  // namespace stickslip::drawing
