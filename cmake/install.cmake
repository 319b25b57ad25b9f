# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause

# What find_package(yorb) needs, and the data that the program finds from its own place (../share/yorb).
include(CMakePackageConfigHelpers)
set(cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/yorb)

install(EXPORT yorbTargets NAMESPACE yorb:: DESTINATION ${cmake_dir})
configure_package_config_file(cmake/yorbConfig.cmake.in ${PROJECT_BINARY_DIR}/yorbConfig.cmake
                              INSTALL_DESTINATION ${cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/yorbConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/yorbConfig.cmake ${PROJECT_BINARY_DIR}/yorbConfigVersion.cmake
        DESTINATION ${cmake_dir})

foreach(data configs models)
  if(EXISTS ${PROJECT_SOURCE_DIR}/${data})
    install(DIRECTORY ${data}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/yorb/${data})
  endif()
endforeach()
install(FILES README.md LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
