/** Odd levels, and the rule that whatever {@code check} accepts can be drawn, simulated and played. */
package nephele.app.corpus;
