#include "tests/render/well_formed.h"

#include <cctype>
#include <regex>
#include <set>
#include <vector>

namespace stickslip::oracle {

std::string fault_in_markup(const std::string& text)
{
    static const std::set<std::string> voids{"meta", "link", "img", "br", "hr", "input", "!doctype"};
    static const std::regex entity("^&(amp|lt|gt|quot|apos|#[0-9]+|#x[0-9a-fA-F]+);");
    std::vector<std::string> open;
    const auto near = [&](std::size_t at) { return text.substr(at, 60); };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '>') return "stray > at: " + near(i);
        if (text[i] == '&' && !std::regex_search(text.substr(i, 12), entity)) return "bare & at: " + near(i);
        if (text[i] != '<') continue;
        const std::size_t start = i;
        const bool ends = text[i + 1] == '/';
        i += ends ? 2 : 1;
        std::string name;
        while (i < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '!' || text[i] == '?'))
            name += text[i++];
        if (name.empty()) return "nameless tag at: " + near(start);
        bool closed = false;
        for (; i < text.size() && text[i] != '>'; ++i) {
            if (text[i] == '<') return "< inside a tag at: " + near(start);
            closed = text[i] == '/' || text[i] == '?';
            if (text[i] != '=') continue;
            if (text[i + 1] != '"') return "unquoted attribute at: " + near(start);
            for (i += 2; i < text.size() && text[i] != '"'; ++i) {
                if (text[i] == '<') return "< inside an attribute at: " + near(start);
                if (text[i] == '&' && !std::regex_search(text.substr(i, 12), entity)) return "bare & at: " + near(i);
            }
        }
        if (i == text.size()) return "tag without end at: " + near(start);
        if (ends) {
            if (open.empty() || open.back() != name) return "</" + name + "> closes nothing at: " + near(start);
            open.pop_back();
        } else if (name == "script" || name == "style") {
            i = text.find("</" + name + ">", i);
            if (i == std::string::npos) return name + " without end";
            i += name.size() + 2;
        } else if (!closed && !voids.count(name)) {
            open.push_back(name);
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

}  // namespace stickslip::oracle
