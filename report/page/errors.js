// Counts what goes wrong on the page, for whoever tests it: <html data-errors="0">.
(function () {
  const root = document.documentElement;
  root.dataset.errors = "0";
  function count() { root.dataset.errors = String(Number(root.dataset.errors) + 1); }
  window.addEventListener("error", count);
  window.addEventListener("unhandledrejection", count);
  document.addEventListener("securitypolicyviolation", count);
  const report = console.error;
  console.error = function () { count(); report.apply(console, arguments); };
})();
