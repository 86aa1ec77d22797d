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
printf 'surface flat(color c = color(1, 0, 0)) { Ci = c; Oi = 1; }' > flat.sl
await 'test $(grep -c s.png: log) -ge 2'
echo "second: $(pixel)"
echo "time: $(grep -o 'first pixels .*' log | tail -1)"
sleep 0.3
sed -i 's/"flat"/"flat" "c" [0 1 0]/' s.rib
await 'test $(grep -c s.png: log) -ge 3'
echo "third: $(pixel)"
