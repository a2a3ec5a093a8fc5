# All files of a package have one date, so that two builds give the same package: the date of the sources (SOURCE_DATE_EPOCH), if the
# environment has it. cpack runs this script before it packs.
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND find ${CPACK_TEMPORARY_DIRECTORY} -exec touch --no-dereference --date=@$ENV{SOURCE_DATE_EPOCH} {} +
    COMMAND_ERROR_IS_FATAL ANY)
endif()
