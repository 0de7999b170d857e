/**
 * The speed/accuracy report: {@link nephele.lab.trade.TradeRun} measures the cost of each setting of a parameter and its error,
 * {@link nephele.lab.trade.Findings} evaluates them, {@link nephele.lab.trade.Report} writes CSV, plots, pictures and one page.
 */
package nephele.lab.trade;
