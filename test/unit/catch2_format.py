# A lit test format in which every test case of a Catch2 program is one test.

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
