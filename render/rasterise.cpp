// SVG to PNG, by librsvg: the same picture as pixels, for slides and papers that take no SVG.
#include "render/drawing/encode.h"
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

/// Cairo's pixels are blue, green, red and nothing, from the top.
drawing::Raster raster_of(cairo_surface_t* surface)
{
    cairo_surface_flush(surface);
    drawing::Raster raster{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), 3, {}};
    const auto pixels = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
    raster.pixels.resize(3 * pixels);
    const unsigned char* from = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    std::uint8_t* to = raster.pixels.data();
    for (int y = 0; y < raster.height; ++y, from += stride)
        for (int x = 0; x < raster.width; ++x, to += 3) {
            const unsigned char* p = from + 4 * x;
            to[0] = p[2], to[1] = p[1], to[2] = p[0];
        }
    return raster;
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
    if (!rsvg_handle_render_document(handle.get(), pen.get(), &page, nullptr) ||
        cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error("a picture could not be turned into pixels");
    return drawing::png(raster_of(surface.get()));
}

}  // namespace stickslip
