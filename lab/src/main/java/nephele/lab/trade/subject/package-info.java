/** The knobs, each a constant of type {@link nephele.lab.trade.Trade}, and what measures them. */
package nephele.lab.trade.subject;
