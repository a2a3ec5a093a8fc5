# The files of a prefix, and find_package(mirocup) from a prefix and from the build tree. Programs find their parts relative to
# themselves (system/locations.hpp), so a prefix can be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/mirocup)

install(TARGETS mirocup mirocup_strategy mirocup_predict mirocup_team mirocup_training EXPORT mirocup)
install(DIRECTORY training/include/ TYPE INCLUDE)
install(DIRECTORY training/python/ DESTINATION share/mirocup/python PATTERN __pycache__ EXCLUDE)
install(TARGETS mirocup-league)
install(TARGETS mirocup-plugin-host mirocup-careful-host mirocup-project-compiler RUNTIME DESTINATION libexec/mirocup)
install(PROGRAMS ${PROJECT_BINARY_DIR}/mirocup-credentials DESTINATION libexec/mirocup)
install(DIRECTORY plugins/include/ TYPE INCLUDE)
install(FILES server/record/record.schema.json DESTINATION share/mirocup)
install(DIRECTORY examples DESTINATION share/mirocup USE_SOURCE_PERMISSIONS PATTERN pitch EXCLUDE)  # it needs the source tree
install(DIRECTORY plugins/template/ DESTINATION share/mirocup/team)
install(DIRECTORY plugins/drills DESTINATION share/mirocup)
install(EXPORT mirocup NAMESPACE mirocup:: FILE mirocup-targets.cmake DESTINATION ${package_folder})

write_basic_package_version_file(${PROJECT_BINARY_DIR}/lib/cmake/mirocup/mirocup-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/mirocup-config.cmake ${PROJECT_BINARY_DIR}/lib/cmake/mirocup/mirocup-config-version.cmake
  DESTINATION ${package_folder})

# The build tree looks like a prefix to find_package and to `mirocup new`.
export(TARGETS mirocup mirocup_strategy mirocup_predict mirocup_team mirocup_training NAMESPACE mirocup::
  FILE ${PROJECT_BINARY_DIR}/lib/cmake/mirocup/mirocup-targets.cmake)
configure_file(cmake/mirocup-config.cmake ${PROJECT_BINARY_DIR}/lib/cmake/mirocup/mirocup-config.cmake COPYONLY)
foreach(file CMakeLists.txt CMakePresets.json README.md team.cpp team_test.cpp)
  configure_file(plugins/template/${file} ${PROJECT_BINARY_DIR}/share/mirocup/team/${file} COPYONLY)
endforeach()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/plugins/include/mirocup ${PROJECT_BINARY_DIR}/include/mirocup
  COPY_ON_ERROR SYMBOLIC)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/mirocup)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/plugins/drills ${PROJECT_BINARY_DIR}/share/mirocup/drills COPY_ON_ERROR SYMBOLIC)
