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
printf 'surface flat() { Ci = color(1, 0, 0); Oi = 1; }' > flat.sl
await 'test $(grep -c s.png: log) -ge 2'
echo "second: $(pixel)"
