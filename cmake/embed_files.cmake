# embed_files(SOURCE FOLDER NAMESPACE NAME HEADER FILE...): makes the source SOURCE of the current folder, which holds the
# files of FOLDER for the function NAME (embed.cmake). A page of it is edited as a file and needs no other step.
set(embed_script ${CMAKE_CURRENT_LIST_DIR}/embed.cmake)
function(embed_files source folder namespace name header)
  get_filename_component(folder ${folder} ABSOLUTE)
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE paths)
  list(JOIN ARGN "|" names)
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${CMAKE_CURRENT_BINARY_DIR}/${source} -DFILES=${names}
      -DFOLDER=${folder} -DNAMESPACE=${namespace} -DNAME=${name} -DHEADER=${header}
      -P ${embed_script}
    DEPENDS ${paths} ${embed_script} VERBATIM)
endfunction()
