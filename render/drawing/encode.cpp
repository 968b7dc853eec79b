#include "render/drawing/encode.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace stickslip::drawing {

std::string png(const Raster& raster)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(raster.width, raster.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, raster.channels);
    auto* target = static_cast<std::uint8_t*>(image->GetScalarPointer());
    const auto row = static_cast<std::size_t>(raster.width) * raster.channels;
    for (int y = 0; y < raster.height; ++y)  // VTK's first row is the lowest
        std::copy_n(raster.pixels.begin() + y * row, row, target + (raster.height - 1 - y) * row);
    vtkNew<vtkPNGWriter> writer;
    writer->SetCompressionLevel(6);
    writer->WriteToMemoryOn();
    writer->SetInputData(image);
    writer->Write();
    auto* bytes = writer->GetResult();
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

std::string base64(std::string_view bytes)
{
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < have ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= have ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace stickslip::drawing
