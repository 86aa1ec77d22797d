# Unit tests: every test case of every Catch2 program in build/test/unit is one test.

import os
import sys

sys.path.insert(0, os.path.join(config.anysl_source_dir, "test", "unit"))
from catch2_format import Catch2Format

config.name = "AnySL-unit"
config.test_format = Catch2Format()
config.test_source_root = os.path.join(config.anysl_source_dir, "test", "unit")
config.test_exec_root = os.path.join(config.anysl_build_dir, "test", "unit")
config.environment["PATH"] = os.pathsep.join([os.path.join(config.anysl_build_dir, "bin"), os.environ["PATH"]])
config.environment["ANYSL_SOURCE_DIR"] = config.anysl_source_dir
config.environment["ANYSL_BUILD_DIR"] = config.anysl_build_dir
