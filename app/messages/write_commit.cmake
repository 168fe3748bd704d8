# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D SOURCE=FOLDER -D COMMIT=TEXT -D HEADER=FILE -P write_commit.cmake: writes HEADER, which defines SHERD_COMMIT
# as TEXT or, if TEXT is empty, as the commit that SOURCE has checked out. Does not touch a HEADER that has this content
# already.
function(git result)
    execute_process(COMMAND git -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
                    RESULT_VARIABLE code)
    if(NOT code EQUAL 0)
        set(text "")
    endif()
    set(${result} "${text}" PARENT_SCOPE)
endfunction()

if(NOT COMMIT)
    set(COMMIT "unknown: not built from a repository of git")
    git(top rev-parse --show-toplevel)
    if(top STREQUAL SOURCE)
        git(COMMIT log -1 "--format=%h of %cs" --abbrev=12)
        git(changes status --porcelain --untracked-files=no)
        if(changes)
            string(APPEND COMMIT ", and changes to it")
        endif()
    endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define SHERD_COMMIT \"${COMMIT}\"\n" @ONLY)
