//! The style of all pages: light and dark, for screens of any width and for paper.

/// The style sheet.
pub(super) const STYLE: &str = r#":root {
  color-scheme: light dark;
  --ink: #1c1c1e; --paper: #fdfdfb; --soft: #5a5a60; --line: #d5d5d0; --panel: #f3f3ee;
  --good: #17613a; --bad: #a31621; --known: #7a4b00; --mark: #ffe08a; --link: #0b4f9e;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ink: #ececf0; --paper: #17181b; --soft: #a9a9b2; --line: #3a3b40; --panel: #212227;
    --good: #7fd6a4; --bad: #ff9a9a; --known: #f0c27a; --mark: #6b5400; --link: #8ec2ff;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 1.06rem/1.6 Georgia, "Times New Roman", serif; }
main { max-width: 46rem; margin: 0 auto; padding: 1.5rem 1rem 4rem; }
h1, h2, h3 { line-height: 1.25; margin: 2rem 0 .6rem; }
a { color: var(--link); }
a:focus-visible, summary:focus-visible, [tabindex]:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
.skip { position: absolute; left: -100rem; }
.skip:focus { left: .5rem; top: .5rem; background: var(--paper); padding: .4rem .8rem; }
.path { color: var(--soft); font-family: ui-monospace, monospace; font-size: .9rem; overflow-wrap: anywhere; margin: 0; }
p, li, td { overflow-wrap: anywhere; }
code, pre { font-family: ui-monospace, "SFMono-Regular", Menlo, monospace; font-size: .86em; }
.wide { overflow-x: auto; max-width: 100%; }
pre.wide { background: var(--panel); padding: .6rem .8rem; border-radius: .3rem; }
table { border-collapse: collapse; }
caption { text-align: left; color: var(--soft); font-size: .9rem; }
th, td { text-align: left; padding: .25rem .9rem .25rem 0; border-bottom: 1px solid var(--line); vertical-align: top; font-weight: normal; }
thead th { color: var(--soft); font-size: .9rem; }
.equation { margin: 1.1rem 0; padding: .5rem .8rem; background: var(--panel); border-left: .25rem solid var(--line); border-radius: .3rem; }
.equation.certified, .equation.verified, .equation.definition, .equation.law { border-left-color: var(--good); }
.equation.refuted, .equation.domain { border-left-color: var(--bad); }
.equation.undecided, .equation.unreadable, .equation.unclaimed, .equation.assumed { border-left-color: var(--known); }
.line { display: flex; flex-wrap: wrap; align-items: center; gap: .3rem .9rem; }
.line > .wide { flex: 1 1 16rem; min-width: 0; padding: .2rem 0; }
.number { color: var(--soft); }
.badge { font: 600 .84rem/1.4 system-ui, sans-serif; white-space: nowrap; }
.badge.good { color: var(--good); } .badge.bad { color: var(--bad); } .badge.known { color: var(--known); }
details { font-size: .95rem; }
summary { cursor: pointer; color: var(--soft); font: .84rem/1.8 system-ui, sans-serif; }
mark { background: var(--mark); color: inherit; }
.repair { border-top: 1px solid var(--line); margin-top: .5rem; }
math { font-size: 1.08em; }
.display { overflow-x: auto; }
@media print {
  body { font-size: 10.5pt; background: none; }
  details > * { display: block; }
  .equation { break-inside: avoid; background: none; }
}
"#;
