# Writes OUT: a header whose namespace NAMESPACE holds SETTINGS (a file of declarations) and `sources`, a hash of the files
# that LIST names one a line. Run as a script by rules that depend on those files.
file(STRINGS ${LIST} sources)
set(text "")
foreach(source IN LISTS sources)
  file(SHA256 ${source} hash)
  string(APPEND text "${hash}\n")
endforeach()
string(SHA256 sources "${text}")
string(SUBSTRING ${sources} 0 16 sources)
file(READ ${SETTINGS} settings)
file(WRITE ${OUT} "// made by the build\n#pragma once\nnamespace ${NAMESPACE} {\n${settings}inline constexpr char sources[] = \"${sources}\";\n}\n")
