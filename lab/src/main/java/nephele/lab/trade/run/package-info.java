/** Runs the registered subjects and saves their measurements. */
package nephele.lab.trade.run;
