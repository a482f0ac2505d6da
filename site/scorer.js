// How the search orders what it finds: as Sphinx does, but first what has all that is asked for in its title, then the
// notation, which explains symbols. Pages to project say less than their lessons, the changelog has every word, and a
// class comes before its methods.
var Scorer = {
  score: ([docname, title, , , score]) => {
    const letters = (text) => text.toLowerCase().replace(/[^\p{L}\p{N}]/gu, "");
    const asked = letters(new URLSearchParams(location.search).get("q") ?? "");
    const more = { "guides/notation": 30, "guides/changelog": -40 }[docname] ?? (docname.startsWith("project/") ? -20 : 0);
    return score + more + (asked && letters(title).includes(asked) ? 40 : 0) - (/^edugym\.\w+\./.test(title) ? 40 : 0);
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
