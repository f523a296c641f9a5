# pelt_find_python(): looks for an interpreter that has NumPy, and for the headers of Python and of
# pybind11. Sets PELT_PYTHON to the interpreter if all are found.
#
# `python3` on the PATH may be an interpreter that a user has installed, without NumPy. The
# interpreter of the system is therefore tried, too.
function(pelt_find_python)
  set(path "${PELT_PYTHON}")
  if(NOT path)
    find_program(on_path python3 NO_CACHE)
    foreach(candidate IN ITEMS ${on_path} /usr/bin/python3)
      pelt_runs_python(${candidate} "import numpy" has_numpy)
      if(has_numpy)
        set(path ${candidate})
        break()
      endif()
    endforeach()
  endif()
  set(PELT_PYTHON "${path}" CACHE FILEPATH "Python 3 with NumPy, for which the package is built" FORCE)
endfunction()

# pelt_runs_python(INTERPRETER STATEMENT RESULT): whether the interpreter runs a statement.
function(pelt_runs_python interpreter statement result)
  execute_process(COMMAND ${interpreter} -c ${statement} RESULT_VARIABLE failed
                  OUTPUT_QUIET ERROR_QUIET)
  set(${result} FALSE PARENT_SCOPE)
  if(failed STREQUAL 0)
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()
