"""Says how many back edges the functions named *.point of printed LLVM code have: python3 loops.py FILE.ll..."""
import re
import sys

for path in sys.argv[1:]:
    loops = 0
    for body in re.findall(r"^define [^\n]*@[^\n]*\.point\(.*?^}", open(path).read(), re.M | re.S):
        blocks = re.split(r"\n(?=[\w.\-\"]+:)", body)
        names = [None] + [re.match(r"[\w.\-\"]+", block)[0] for block in blocks[1:]]
        successors = {name: re.findall(r"label %([\w.\-\"]+)", block) for name, block in zip(names, blocks)}
        state = {}  # 1: on the way, 2: done
        stack = [(None, iter(successors[None]))]
        state[None] = 1
        while stack:
            name, rest = stack[-1]
            following = next(rest, None)
            if following is None:
                state[name] = 2
                stack.pop()
            elif state.get(following) == 1:
                loops += 1
            elif following not in state:
                state[following] = 1
                stack.append((following, iter(successors[following])))
    print(f"{path}: {loops} loops")
