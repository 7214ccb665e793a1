# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# `cmake --build build/release --target package` makes findspace_VERSION_ARCH.deb there: program, library, headers, CMake
# package, documentation. dpkg-shlibdeps finds what the program depends on. A user of the library needs the libraries
# that tools/packages.txt lists for the build, too; the package suggests these.
include(GNUInstallDirs)  # documentation in share/doc/findspace
install(FILES README.md LICENSE cmake/copyright TYPE DOC)
install(DIRECTORY docs examples TYPE DOC PATTERN "*.html" EXCLUDE)

file(STRINGS tools/packages.txt libraries REGEX "^build +(lib|nlohmann).*-dev$")
list(TRANSFORM libraries REPLACE "^build +" "")
list(JOIN libraries ", " CPACK_DEBIAN_PACKAGE_SUGGESTS)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "findspace contributors <contributors@findspace.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_FILE ${PROJECT_SOURCE_DIR}/cmake/description.txt)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
include(CPack)
