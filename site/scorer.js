// How the search orders what it finds: as Sphinx does, but of pages that have a word, the notation, which explains it, comes first.
var Scorer = {
  score: ([docname, , , , score]) => (docname === "guides/notation" ? score + 30 : score),
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
