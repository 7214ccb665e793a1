# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# find_package(findspace): the target findspace::findspace, and what its static libraries need.
include(CMakeFindDependencyMacro)
find_dependency(PkgConfig)
pkg_check_modules(LIBGMP REQUIRED IMPORTED_TARGET gmp)
pkg_check_modules(LIBMPFR REQUIRED IMPORTED_TARGET mpfr)
pkg_check_modules(PUGIXML REQUIRED IMPORTED_TARGET pugixml)
pkg_check_modules(EXPAT REQUIRED IMPORTED_TARGET expat)
pkg_check_modules(SQLITE REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(CLP REQUIRED IMPORTED_TARGET clp)
pkg_check_modules(LIBZIP IMPORTED_TARGET libzip)
find_dependency(fmt)
find_dependency(nlohmann_json)
find_dependency(TBB)
include(${CMAKE_CURRENT_LIST_DIR}/findspaceTargets.cmake)
