# What `cmake --install` lays down: the program, the library with its modules and headers, the CMake package, pkg-config,
# manual, completion and documents. Consumers: find_package(mrsim), target mrsim::mrsim.
include(CMakePackageConfigHelpers)

set(mrsim_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mrsim)
install(TARGETS mrsim EXPORT mrsimTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
get_property(mrsim_modules GLOBAL PROPERTY MRSIM_MODULES)
install(TARGETS ${mrsim_modules} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/mrsim)
install(TARGETS mrsim_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/mrsim DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT mrsimTargets NAMESPACE mrsim:: DESTINATION ${mrsim_package_dir})

configure_package_config_file(cmake/mrsimConfig.cmake.in ${PROJECT_BINARY_DIR}/mrsimConfig.cmake
  INSTALL_DESTINATION ${mrsim_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/mrsimConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/mrsimConfig.cmake ${PROJECT_BINARY_DIR}/mrsimConfigVersion.cmake
  DESTINATION ${mrsim_package_dir})

# Relative to the file itself, so that an installed tree may be moved.
file(RELATIVE_PATH mrsim_pc_up /p/${CMAKE_INSTALL_LIBDIR}/pkgconfig /p)
configure_file(cmake/mrsim.pc.in ${PROJECT_BINARY_DIR}/mrsim.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/mrsim.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${PROJECT_BINARY_DIR}/share/mrsim.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/share/completion.bash RENAME mrsim
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(DIRECTORY docs/schema DESTINATION ${CMAKE_INSTALL_DATADIR}/mrsim)
install(FILES README.md CHANGELOG.md LICENSE docs/licences.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# A package for Debian: cpack --config build/CPackConfig.cmake
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "mrsim maintainers <maintainers@users.noreply.example>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
include(CPack)
