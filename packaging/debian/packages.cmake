# The Debian packages, each a group of components. The program and the shared library are separate
# packages, so that the program needs no other.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SOURCE kinestat)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_POST_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/compress.cmake)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog)
find_program(AWK_PROGRAM awk)
if(AWK_PROGRAM AND GZIP_PROGRAM)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${CMAKE_CURRENT_LIST_DIR}/changelog.awk)
  execute_process(
    COMMAND ${AWK_PROGRAM} -v package=kinestat -v maintainer=${CPACK_PACKAGE_CONTACT}
      -f ${CMAKE_CURRENT_LIST_DIR}/changelog.awk ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    OUTPUT_FILE ${changelog} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${GZIP_PROGRAM} -9nkf ${changelog} COMMAND_ERROR_IS_FATAL ANY)
endif()

# The first line of a description is its summary; there is no common one.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")

set(packages kinestat)
set(components_of_kinestat program data)
set(CPACK_DEBIAN_KINESTAT_DESCRIPTION "batch analysis of mechanisms by Davies' method
Reads bodies, couplings and drives of a mechanism from a YAML file and solves
kinematics and statics by screw theory with Kirchhoff's laws: mobility,
motion, power flow, gears, sweeps and synthesis. Answers are tables, JSON,
CSV and pages.")
set(CPACK_DEBIAN_KINESTAT_PACKAGE_SECTION science)
if(NOT KINESTAT_LINKS_STATICALLY)
  set(CPACK_DEBIAN_KINESTAT_PACKAGE_SHLIBDEPS ON)
endif()
if(TARGET kinestat_shared)
  list(APPEND packages libkinestat0 libkinestat-dev python3-kinestat)
  set(components_of_libkinestat0 library)
  set(CPACK_DEBIAN_LIBKINESTAT0_DESCRIPTION "analysis of mechanisms by Davies' method - library
Reads mechanism files, analyses them, and plays a recorded case for arrays of
parameters.")
  set(CPACK_DEBIAN_LIBKINESTAT0_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_LIBKINESTAT0_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_LIBKINESTAT0_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_LIST_DIR}/libkinestat0/triggers)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")

  set(components_of_libkinestat-dev development)
  set(CPACK_DEBIAN_LIBKINESTAT-DEV_DESCRIPTION "analysis of mechanisms by Davies' method - headers
The interface of libkinestat for C and C++, with what CMake and pkg-config
find it by, and programs to begin with.")
  set(CPACK_DEBIAN_LIBKINESTAT-DEV_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_LIBKINESTAT-DEV_PACKAGE_DEPENDS "libkinestat0 (= ${PROJECT_VERSION})")

  set(components_of_python3-kinestat python)
  set(CPACK_DEBIAN_PYTHON3-KINESTAT_DESCRIPTION "analysis of mechanisms by Davies' method - Python
Reads mechanism files, analyses them, and plays a recorded case for arrays of
parameters, those of NumPy where it is installed.")
  set(CPACK_DEBIAN_PYTHON3-KINESTAT_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON3-KINESTAT_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_PYTHON3-KINESTAT_PACKAGE_DEPENDS
    "python3:any (>= 3.9), libkinestat0 (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_PYTHON3-KINESTAT_PACKAGE_RECOMMENDS python3-numpy)
  set(CPACK_DEBIAN_PYTHON3-KINESTAT_PACKAGE_SUGGESTS python3-pandas)
  set(CPACK_DEBIAN_PYTHON3-KINESTAT_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_LIST_DIR}/python3-kinestat/postinst
    ${CMAKE_CURRENT_LIST_DIR}/python3-kinestat/prerm)
endif()

# The components, and for each package `debian_PACKAGE`, with the remaining files.
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL "")
foreach(package ${packages})
  string(TOUPPER ${package} upper_package)
  set(CPACK_DEBIAN_${upper_package}_PACKAGE_NAME ${package})
  foreach(component ${components_of_${package}} debian_${package})
    string(TOUPPER ${component} upper_component)
    set(CPACK_COMPONENT_${upper_component}_GROUP ${package})
    list(APPEND CPACK_COMPONENTS_ALL ${component})
  endforeach()
  set(of_debian COMPONENT debian_${package} EXCLUDE_FROM_ALL)
  set(doc ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES ${changelog}.gz DESTINATION ${doc} ${of_debian} OPTIONAL)
  if(package STREQUAL "libkinestat0")
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/copyright DESTINATION ${doc} ${of_debian})
  elseif(NOT package STREQUAL "kinestat")
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${doc} RENAME copyright ${of_debian})
  endif()
  if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/${package}/lintian-overrides)
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/${package}/lintian-overrides
      DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME ${package} ${of_debian})
  endif()
endforeach()
