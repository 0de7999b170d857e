/** The knobs: one class a subject, each with a constant {@code TRADE}. */
package nephele.lab.trade.subject;
