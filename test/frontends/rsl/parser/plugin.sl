// RUN: rslc -verify -fsyntax-only %s
plugin "shadeops";          // expected-warning {{plugin "shadeops" is ignored}}
plugin "more"               // expected-warning {{plugin "more" is ignored}}
surface plugins(float plugin = 1) { Ci = plugin; }
