/** The subjects, each a constant of type {@link nephele.lab.trade.Trade}, and their experiments. */
package nephele.lab.trade.subject;
