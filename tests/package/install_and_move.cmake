# Installs BUILD_DIR into a prefix, then renames it to PREFIX. What the components install is all that there is.
file(REMOVE_RECURSE "${PREFIX}" "${PREFIX}.first" "${PREFIX}.parts")
function(install_to prefix)
  execute_process(
    COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --prefix "${prefix}" --config "${CONFIG}" ${ARGN}
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()
install_to("${PREFIX}.first")
foreach(component IN ITEMS development runtime tools)
  install_to("${PREFIX}.parts" --component ${component})
endforeach()
file(GLOB_RECURSE all RELATIVE "${PREFIX}.first" "${PREFIX}.first/*")
file(GLOB_RECURSE parts RELATIVE "${PREFIX}.parts" "${PREFIX}.parts/*")
if(NOT all STREQUAL parts)
  list(REMOVE_ITEM all ${parts})
  message(FATAL_ERROR "In no component: ${all}")
endif()
file(REMOVE_RECURSE "${PREFIX}.parts")
file(RENAME "${PREFIX}.first" "${PREFIX}")
