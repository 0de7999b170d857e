/** Runs subjects, keeps what was learnt, and knows all of them. */
package nephele.lab.trade.run;
