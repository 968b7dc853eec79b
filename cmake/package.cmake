# The analysis floor as a CMake package: find_package(stickslip) gives stickslip::analysis, and with COMPONENTS files also
# stickslip::files, which reads and writes joints and records.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/stickslip)

# "libresults.a" would say nothing in a library folder that all programs share.
set_target_properties(results PROPERTIES OUTPUT_NAME stickslip-results)
set_target_properties(analysis PROPERTIES OUTPUT_NAME stickslip-analysis)
set_target_properties(files PROPERTIES OUTPUT_NAME stickslip-files)
target_compile_features(results PUBLIC cxx_std_20)
target_include_directories(results INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

install(TARGETS results analysis files EXPORT stickslip ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(EXPORT stickslip NAMESPACE stickslip:: FILE stickslip-targets.cmake DESTINATION ${package_dir} COMPONENT library)
# public headers, and behind them only what they include
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -DSOURCE=${PROJECT_SOURCE_DIR}
  \"-DHEADERS=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\"
  -P \"${PROJECT_SOURCE_DIR}/cmake/install_headers.cmake\" COMMAND_ERROR_IS_FATAL ANY)" COMPONENT library)
configure_package_config_file(cmake/stickslip-config.cmake.in stickslip-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(stickslip-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/stickslip-config.cmake ${PROJECT_BINARY_DIR}/stickslip-config-version.cmake
  DESTINATION ${package_dir} COMPONENT library)
