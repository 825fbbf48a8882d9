include(GNUInstallDirs)

# sir_installed(TARGET HEADER...): the library is installed as sir::NAME (of sir_NAME) with these of
# its folder's headers, which are included by their paths from the project's root, as here.
function(sir_installed target)
  string(REPLACE "sir_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_sources(${target} INTERFACE FILE_SET HEADERS
    BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARGN})
  install(TARGETS ${target} EXPORT sirTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sir COMPONENT dev)
endfunction()
