/** The knobs: one class a subject, each with a constant {@code TRADE}. */
package nephele.app.trade.subject;
