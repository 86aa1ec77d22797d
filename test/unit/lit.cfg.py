# Unit tests: every test case of every Catch2 program in build/test/unit is one test.

import os
import subprocess
import lit.formats
import lit.Test
import lit.util


class Catch2Format(lit.formats.TestFormat):
    """Lists the cases of each `*-tests` program and runs each in a process of its own."""

    def getTestsInDirectory(self, suite, path_in_suite, lit_config, local_config):
        if path_in_suite:
            return
        folder = suite.getExecPath(())
        for program in sorted(os.listdir(folder)):
            path = os.path.join(folder, program)
            if not program.endswith("-tests") or not os.access(path, os.X_OK):
                continue
            # The exit status of listing is the number of cases.
            listing = subprocess.run([path, "--list-test-names-only"], capture_output=True, text=True)
            for case in filter(None, listing.stdout.splitlines()):
                yield lit.Test.Test(suite, (program, case), local_config)

    def execute(self, test, lit_config):
        program, case = test.path_in_suite
        command = [test.suite.getExecPath((program,)), escape(case)]
        try:
            out, err, status = lit.util.executeCommand(
                command, env=test.config.environment, timeout=lit_config.maxIndividualTestTime)
        except lit.util.ExecuteCommandTimeoutException as timeout:
            return lit.Test.TIMEOUT, timeout.msg
        return (lit.Test.PASS, "") if status == 0 else (lit.Test.FAIL, out + err)


def escape(case):
    """Catch2 reads commas and brackets in a name as a pattern."""
    return "".join("\\" + c if c in ",[]\\" else c for c in case)


config.name = "AnySL-unit"
config.test_format = Catch2Format()
config.test_source_root = os.path.join(config.anysl_source_dir, "test", "unit")
config.test_exec_root = os.path.join(config.anysl_build_dir, "test", "unit")
config.environment["PATH"] = os.pathsep.join([os.path.join(config.anysl_build_dir, "bin"), os.environ["PATH"]])
config.environment["ANYSL_SOURCE_DIR"] = config.anysl_source_dir
config.environment["ANYSL_BUILD_DIR"] = config.anysl_build_dir
