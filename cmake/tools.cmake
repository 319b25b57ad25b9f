# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause

# The project's own scripts are tested as its libraries are.
find_package(Python3 COMPONENTS Interpreter)
if(YORB_TESTS AND Python3_FOUND)
  add_test(NAME tools.check_layers COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_layers.py)
  add_test(NAME tools.check_layers_test COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/tools/check_layers_test.py)
endif()
