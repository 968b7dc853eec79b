// SVG to PNG, by librsvg: the same picture as pixels, for slides and papers that take no SVG.
#include "render/render.h"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <memory>
#include <stdexcept>

namespace stickslip {
namespace {

constexpr double fineness = 1.5;  // pixels to a CSS pixel: 1350 px across, enough for a column of print

template <class Thing, void (*Free)(Thing*)>
struct Freed {
    void operator()(Thing* thing) const { Free(thing); }
};

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size)
{
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
}

void release(RsvgHandle* handle)
{
    g_object_unref(handle);
}

}  // namespace

std::string png(const RenderedFigure& figure)
{
    if (figure.svg.empty()) return "";
    GError* error = nullptr;
    const std::unique_ptr<RsvgHandle, Freed<RsvgHandle, release>> handle(rsvg_handle_new_from_data(
        reinterpret_cast<const guint8*>(figure.svg.data()), static_cast<gsize>(figure.svg.size()), &error));
    if (!handle) {
        const std::string why = error ? error->message : "unknown reason";
        g_clear_error(&error);
        throw std::runtime_error("a picture could not be turned into pixels: " + why);
    }
    const double width = fineness * figure.width, height = fineness * figure.height;
    const std::unique_ptr<cairo_surface_t, Freed<cairo_surface_t, cairo_surface_destroy>> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
    const std::unique_ptr<cairo_t, Freed<cairo_t, cairo_destroy>> pen(cairo_create(surface.get()));
    const RsvgRectangle page{0, 0, width, height};
    std::string bytes;
    if (!rsvg_handle_render_document(handle.get(), pen.get(), &page, nullptr) ||
        cairo_surface_write_to_png_stream(surface.get(), append, &bytes) != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error("a picture could not be turned into pixels");
    return bytes;
}

}  // namespace stickslip
