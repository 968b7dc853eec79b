// The page's own files, put into the program when it is built.
#pragma once
#include <string_view>

namespace stickslip::drawing {

struct Source {
    std::string_view text;
    std::string_view sha256;  ///< of the text, 64 hexadecimal digits
};

extern const Source page_html, figure_html, page_css, page_js;
extern const Source dygraph_min_js, dygraph_min_css;  ///< D. Vanderkam and others, MIT licence; for long time series

}  // namespace stickslip::drawing
