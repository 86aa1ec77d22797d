# How the lit tests of this tree run; the site file that CMake writes says where the build lies.

import os
import shutil
import lit.formats

config.name = "AnySL"
config.test_format = lit.formats.ShTest(execute_external=True)
config.suffixes = [".sl", ".ll", ".c", ".cpp", ".rib", ".test"]
config.excludes = ["Inputs"]
config.test_source_root = os.path.join(config.anysl_source_dir, "test")
config.test_exec_root = os.path.join(config.anysl_build_dir, "test")

tools = os.path.join(config.anysl_build_dir, "bin")
test_tools = os.path.join(config.anysl_build_dir, "test", "bin")
config.environment["PATH"] = os.pathsep.join([tools, test_tools, config.anysl_llvm_bin, os.environ["PATH"]])
# Compiled shaders of one run must not serve the next.
config.environment["XDG_CACHE_HOME"] = os.path.join(config.test_exec_root, "cache")

config.substitutions += [
    ("%plugin", os.path.join(config.anysl_build_dir, "lib", "libanysl-vectorize.so")),
    ("%examples", os.path.join(config.anysl_source_dir, "examples")),
    ("%anysl_include", "-I%s/include -I%s/include" % (config.anysl_source_dir, config.anysl_build_dir)),
    ("%tools_dir", tools),
    ("%lib_dir", os.path.join(config.anysl_build_dir, "lib")),
    ("%source_dir", config.anysl_source_dir),
    ("%build_dir", config.anysl_build_dir),
]

if config.anysl_sanitize:
    config.available_features.add("sanitizer")
    # The distribution's opt cannot load a plugin that wants a sanitizer's runtime; ours has its passes.
    config.substitutions.insert(0, ("opt -load-pass-plugin=%plugin", os.path.join(tools, "anysl-opt")))
# A headless browser, to see pages as people do.
config.anysl_browser = next(filter(None, map(shutil.which, ["chromium-headless-shell", "chromium"])), None)
if config.anysl_browser:
    config.available_features.add("browser")
    config.substitutions.append(("%browser", config.anysl_browser + " --headless --no-sandbox --disable-gpu --hide-scrollbars"))
with open("/proc/cpuinfo") as cpuinfo:
    flags = set(next((line for line in cpuinfo if line.startswith("flags")), "").split())
for feature, needed in {"avx2": {"avx2", "fma"}, "avx512": {"avx512f", "avx512dq", "avx512vl", "avx512bw"}}.items():
    if needed <= flags:
        config.available_features.add(feature)
