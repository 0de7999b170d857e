/** Odd levels, and the rule that every level that {@code check} accepts can be drawn, simulated and played. */
package nephele.app.corpus;
