/** Writes the findings to files: CSV, plots, pictures and one page that needs no other file. */
package nephele.lab.trade.report;
