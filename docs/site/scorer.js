// The search's order of results: Sphinx's own scores, and what kind of page a reader with a task wants first.
var Scorer = {
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
  score: ([docname, , , , score]) => {
    const folders = [
      ["how-to/messages", -6], ["how-to/index", 0], ["how-to/", 4], ["tutorials/", 3], ["from-other-tools/", 3], ["gallery/", 1],
      ["reference/cpp/", -8], ["project/", -4],
    ];
    const [, more] = folders.find(([folder]) => docname.startsWith(folder)) || ["", docname === "glossary" ? 2 : 0];
    return score + more;
  },
};
