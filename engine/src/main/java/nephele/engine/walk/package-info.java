/** A simulated walk through a level, and what a camera sees of it between two ticks. */
package nephele.engine.walk;
