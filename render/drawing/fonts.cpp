#include "render/drawing/fonts.h"

#include <filesystem>

namespace stickslip::drawing {

const std::vector<std::string>& font_folders()
{
    static const std::vector<std::string> folders{
        "/usr/share/fonts/truetype/dejavu",    // Debian, Ubuntu: fonts-dejavu-core
        "/usr/share/fonts/dejavu-sans-fonts",  // Fedora
        "/usr/share/fonts/TTF",                // Arch
        "/usr/share/fonts/dejavu"};
    return folders;
}

Fonts find_fonts(const std::vector<std::string>& folders)
{
    Fonts fonts;
    std::string searched;
    for (const std::string& folder : folders) {
        std::error_code ignored;
        const std::string regular = folder + "/DejaVuSans.ttf", bold = folder + "/DejaVuSans-Bold.ttf";
        if (std::filesystem::exists(regular, ignored) && std::filesystem::exists(bold, ignored)) {
            fonts.regular = regular;
            fonts.bold = bold;
            return fonts;
        }
        searched += (searched.empty() ? "" : ", ") + folder;
    }
    fonts.missing = "the typeface DejaVu Sans was not found in " + searched + " (Debian: install fonts-dejavu-core)";
    return fonts;
}

}  // namespace stickslip::drawing
