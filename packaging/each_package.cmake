# Read by CPack for each kind of package. Archives and their members get the date of the version.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  set(ENV{SOURCE_DATE_EPOCH} ${CPACK_KINESTAT_EPOCH})
endif()

# There is one archive, which unpacks into its own folder.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  list(FILTER CPACK_COMPONENTS_ALL EXCLUDE REGEX "^debian_")
  list(APPEND CPACK_COMPONENTS_ALL zsh licences)
  set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
endif()
