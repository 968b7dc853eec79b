# The rule that makes build_info.h: version, compiler, flags and a hash of the sources that make the numbers. Included by
# sweep/CMakeLists.txt.
file(GLOB_RECURSE numeric_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/analysis/*.h ${PROJECT_SOURCE_DIR}/analysis/*.cpp
  ${PROJECT_SOURCE_DIR}/sweep/study/evaluate.cpp)
list(SORT numeric_sources)
set(made ${CMAKE_CURRENT_BINARY_DIR}/made)
string(REPLACE ";" "\n" lines "${numeric_sources}")
file(CONFIGURE OUTPUT ${made}/numeric_sources.txt CONTENT "${lines}\n" @ONLY)

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
get_directory_property(options COMPILE_OPTIONS)
set(flags ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${options})
list(FILTER flags EXCLUDE REGEX "^-W")
list(JOIN flags " " flags)
string(STRIP "${flags}" flags)
file(CONFIGURE OUTPUT ${made}/settings.txt CONTENT "inline constexpr char version[] = \"${PROJECT_VERSION}\";
inline constexpr char compiler[] = \"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\";
inline constexpr char flags[] = \"${flags}\";
" @ONLY)

add_custom_command(OUTPUT ${made}/build_info.h
  COMMAND ${CMAKE_COMMAND} -DLIST=${made}/numeric_sources.txt -DSETTINGS=${made}/settings.txt -DOUT=${made}/build_info.h
          -DNAMESPACE=stickslip::build_info -P ${PROJECT_SOURCE_DIR}/cmake/hash_of_sources.cmake
  DEPENDS ${numeric_sources} ${made}/numeric_sources.txt ${made}/settings.txt ${PROJECT_SOURCE_DIR}/cmake/hash_of_sources.cmake
  COMMENT "Fingerprint of the numeric sources" VERBATIM)
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/engine/build.cpp PROPERTIES OBJECT_DEPENDS ${made}/build_info.h)
set_property(SOURCE ${CMAKE_CURRENT_SOURCE_DIR}/engine/build.cpp APPEND PROPERTY INCLUDE_DIRECTORIES ${made})
