// Words into HTML. Everything that a user wrote passes through one of these.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace stickslip::drawing {

/// & < > " ' as entities: safe as text and inside a quoted attribute.
std::string escape(std::string_view text);

/// Text of unknown origin without control characters, marks of writing direction and bytes that are no UTF-8: each
/// becomes U+FFFD. escape and json_string see to it themselves.
std::string readable(std::string_view text);

/// Chart mark-up, "k_{p}" → "k<sub>p</sub>"; all else escaped.
std::string html_of_markup(std::string_view markup);

/// A JSON string literal that cannot end the script element it stands in.
std::string json_string(std::string_view text);

/// Replaces each {{name}} once, from left to right; what is put in is not searched again. Throws std::logic_error on a
/// name that has no value.
std::string fill(std::string_view page, const std::map<std::string, std::string, std::less<>>& values);

/// "sha256-…" as a content security policy wants it, from hexadecimal digits.
std::string policy_hash(std::string_view hexadecimal);

}  // namespace stickslip::drawing
