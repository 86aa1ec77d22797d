# Changes flat.sl while anysl-render --watch runs on s.rib; waits for each effect for 60 s at most.
anysl-render s.rib --watch --cache cache 2> log &
watcher=$!
trap 'kill $watcher' EXIT
await() { for _ in $(seq 600); do eval "$1" > /dev/null 2>&1 && return; sleep 0.1; done; echo "timeout: $1"; cat log; exit 1; }
pixel() { oiiotool --dumpdata s.png | grep Pixel; }

await 'grep s.png: log'
echo "first: $(pixel)"
sleep 0.3
printf 'surface flat() { Ci = ; }' > flat.sl
await 'grep "does not compile" log'
echo "broken: $(grep -o error log | head -1)"
sleep 0.3
printf 'surface flat(color c = color(1, 0, 0); string map = "";) { Ci = c; if (map != "") Ci *= color texture(map); Oi = 1; }' > flat.sl
await 'test $(grep -c s.png: log) -ge 2'
echo "second: $(pixel)"
echo "time: $(grep -o 'first pixels .*' log | tail -1)"
sleep 0.3
sed -i 's/"flat"/"flat" "c" [0 1 0]/' s.rib
await 'test $(grep -c s.png: log) -ge 3'
echo "third: $(pixel)"
# Pictures: one that the shader looks up, and one that such a picture is made of.
picture() { oiiotool --pattern constant:color=$1 1x1 3 -o new.exr && mv new.exr $2; }
picture 1,0,1 dot.exr
sed -i 's/"c" \[0 1 0\]/"c" [1 1 1] "map" "dot.exr"/' s.rib
await 'test $(grep -c s.png: log) -ge 4'
echo "fourth: $(pixel)"
compiled=$(grep -c 'shaders compiled before' log)
sleep 0.3
picture 1,1,0 dot.exr
await 'test $(grep -c s.png: log) -ge 5'
echo "fifth: $(pixel)"
echo "compiled for it: $(($(grep -c 'shaders compiled before' log) - compiled))"
sleep 0.3
picture 0,0,1 source.exr
sed -i 's/^/MakeTexture "source.exr" "made.tex" "periodic" "periodic" "box" 1 1\n/; s/dot.exr/made.tex/' s.rib
await 'test $(grep -c s.png: log) -ge 6'
echo "sixth: $(pixel)"
sleep 0.3
picture 0,1,1 source.exr
await 'test $(grep -c s.png: log) -ge 7'
echo "seventh: $(pixel)"
sleep 1
echo "pictures: $(grep -c s.png: log)"
