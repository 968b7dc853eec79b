# `cmake --build build --target package` writes stickslip_<version>_<architecture>.deb and a tar: program, manual, completions,
# library, headers and the Python package.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/stickslip DESTINATION lib/python3/dist-packages
  FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/stickslip RENAME copyright OPTIONAL)

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME stickslip)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_CONTACT "stickslip <stickslip@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# dpkg-shlibdeps knows what the program links; it draws with a typeface and, for surfaces, by way of EGL
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, libegl1, libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3, python3-numpy, python3-pandas, python3-xarray, python3-netcdf4, python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, python3-h5py, python3-scipy, python3-lz4, python3-zstandard")
include(CPack)
