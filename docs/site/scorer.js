/* Rank of a search result: pages that answer a question before lists of names, those before methods and decisions. */
var Scorer = {
  score: ([page, title, anchor, descr, score, filename, kind]) => {
    if (/^howto\/questions$/.test(page)) return score + 60;
    if (/^(howto\/|tutorial$|glossary$|faq$|try$|gallery$|mechanisms$|limits$)/.test(page)) return score + 50;
    if (/^(benchmarks|reliability|_made\/(ledger|stability|validity)\/.*)$/.test(page)) return score + 20;
    if (kind === "object" || kind === "index") return score - 5;
    if (/^(decisions|methods)\//.test(page)) return score - 10;
    return score;
  },
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
