"""Runs anysl-shade once for each line "MISTAKE: ARGUMENTS | MESSAGE" of a test; LIB stands for a library."""
import subprocess
import sys

library, test = sys.argv[1:]
checked = 0
with open(test) as file:
    for line in file:
        if not line.startswith("MISTAKE:"):
            continue
        arguments, message = (part.strip() for part in line[len("MISTAKE:"):].split("|"))
        arguments = [library if word == "LIB" else word for word in arguments.split()]
        run = subprocess.run(["anysl-shade", *arguments], capture_output=True, text=True)
        wanted = "anysl-shade: error: " + message.replace("LIB:", library + ":").replace("'LIB'", f"'{library}'") + "\n"
        assert (run.returncode, run.stdout, run.stderr) == (1, "", wanted), (arguments, run, wanted)
        checked += 1
assert checked > 30
