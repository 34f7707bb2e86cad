# Writes the manual pages and the shell completions, as printed by the program.
# cmake -DPROGRAM=… -DFOLDER=… -P shell_files.cmake
function(write file)
  cmake_path(GET file PARENT_PATH folder)
  file(MAKE_DIRECTORY ${FOLDER}/${folder})
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${FOLDER}/${file}
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
write(man/man1/kinestat.1 help --man)

# The page of the program lists all others.
file(READ ${FOLDER}/man/man1/kinestat.1 page)
string(REPLACE "\\-" "-" page "${page}")
string(REGEX REPLACE "\\\\f[BIR]" "" page "${page}")
foreach(section 1 7)
  string(REGEX MATCHALL "kinestat-[a-z0-9-]+\\(${section}\\)" names "${page}")
  list(REMOVE_DUPLICATES names)
  foreach(name ${names})
    string(REGEX REPLACE "^kinestat-(.*)\\(.\\)$" "\\1" word ${name})
    if(section EQUAL 7)
      write(man/man7/kinestat-${word}.7 help --man ${word}.7)
    else()
      write(man/man1/kinestat-${word}.1 help --man ${word})
    endif()
  endforeach()
endforeach()

write(bash-completion/completions/kinestat completion bash)
write(zsh/site-functions/_kinestat completion zsh)
write(fish/vendor_completions.d/kinestat.fish completion fish)

if(GZIP)
  file(GLOB_RECURSE pages ${FOLDER}/man/*)
  execute_process(COMMAND ${GZIP} -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
endif()
