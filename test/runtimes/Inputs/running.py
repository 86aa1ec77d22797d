"""What the scripts beside this one share."""
import shlex
import subprocess
import sys


def run(*command):
    """What a command prints; ends the script, with all of it, where the command fails."""
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{shlex.join(command)}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout
