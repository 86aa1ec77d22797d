//===-- lib/Plot/Style.h - the look of plots and pages ----------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_PLOT_STYLE_H
#define ANYSL_LIB_PLOT_STYLE_H

namespace anysl::plot {

constexpr const char *plotStyle = R"(
:root, svg { --ink: #1d2430; --soft: #66707f; --faint: #e3e7ee; --back: #ffffff; --panel: #f6f8fb;
  --good: #e9f5ec; --s0: #2563b8; --s1: #1d8a4e; --s2: #c47f00; --s3: #c7362f; --s4: #7b3fb0; --s5: #3a3f4a; }
@media (prefers-color-scheme: dark) {
  :root, svg { --ink: #e6eaf1; --soft: #98a3b3; --faint: #2b323d; --back: #12161c; --panel: #1a2029;
    --good: #17301f; --s0: #6aa5f5; --s1: #56c987; --s2: #f0b541; --s3: #f4766d; --s4: #bd8bf0; --s5: #b9c1cd; } }
.plot { font: 11px system-ui, sans-serif; width: 100%; max-width: 1200px; height: auto; }
.plot text { fill: var(--ink); }
.plot .back { fill: var(--back); }
.plot .title { font-size: 15px; font-weight: 600; }
.plot .grid { stroke: var(--faint); fill: none; }
.plot .axis { stroke: var(--soft); fill: none; }
.plot .tick, .plot .hint { fill: var(--soft); }
.plot .name { font-size: 12px; }
.plot .key { font-size: 11px; }
.plot .front { stroke: var(--soft); stroke-width: 1.5; stroke-dasharray: 5 3; fill: none; }
.plot .guide { stroke: var(--soft); stroke-width: 1; stroke-dasharray: 1 3; fill: none; }
.plot .guide-label { fill: var(--soft); font-style: italic; }
.plot .leader { stroke: var(--soft); stroke-width: 0.6; fill: none; }
.plot .label { fill: var(--soft); paint-order: stroke; stroke: var(--back); stroke-width: 3px; }
.plot .front-label { fill: var(--ink); font-weight: 600; }
.plot .dot { stroke: var(--back); stroke-width: 1; fill-opacity: 0.75; }
.plot .key-dot { fill-opacity: 1; stroke: none; }
.plot .on-front .dot { fill-opacity: 1; stroke: var(--ink); stroke-width: 1.3; }
.plot .key-shape { fill: none; stroke: var(--soft); stroke-width: 1.3; }
.plot .s0 { fill: var(--s0); } .plot .s1 { fill: var(--s1); } .plot .s2 { fill: var(--s2); }
.plot .s3 { fill: var(--s3); } .plot .s4 { fill: var(--s4); } .plot .s5 { fill: var(--s5); }
.plot text.mark { fill: var(--back); font-size: 9px; font-weight: 700; pointer-events: none; }
.plot text.key-mark { fill: var(--ink); }
.plot .heat { fill: var(--s3); } .plot .above { fill: var(--s4); }
.plot .frame { fill: none; stroke: var(--soft); }
.plot .panel { fill: var(--panel); stroke: var(--faint); }
.plot .tip { visibility: hidden; pointer-events: none; }
.plot .point:hover .tip { visibility: visible; }
.plot .point:hover .dot { fill-opacity: 1; stroke: var(--ink); stroke-width: 2.5; }
.plot .tip-title { font-size: 12px; font-weight: 600; }
.plot .tip-name { fill: var(--soft); }
)";

constexpr const char *pageStyle = R"(
body { margin: 0 auto; padding: 16px 24px 48px; max-width: 1200px; color: var(--ink); background: var(--back);
  font: 14px/1.45 system-ui, sans-serif; }
h1 { font-size: 21px; margin: 0 0 2px; } h2 { font-size: 17px; margin: 22px 0 4px; }
h3 { font-size: 14px; margin: 20px 0 6px; }
p, ul { margin: 6px 0; max-width: 78em; } .soft { color: var(--soft); }
.glance { background: var(--panel); border: 1px solid var(--faint); border-radius: 6px; padding: 8px 14px; margin: 8px 0; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 13px; }
th { text-align: left; color: var(--soft); font-weight: 500; border-bottom: 1px solid var(--soft); vertical-align: bottom; }
th, td { padding: 3px 12px 3px 0; white-space: nowrap; }
td { border-bottom: 1px solid var(--faint); } td.number { text-align: right; }
tr.chosen td { background: var(--good); }
details > summary { cursor: pointer; margin: 16px 0 6px; font-weight: 600; }
code { font-size: 12px; }
)";

} // namespace anysl::plot

#endif
