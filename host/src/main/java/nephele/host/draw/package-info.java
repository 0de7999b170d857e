/**
 * Shared by all programs that draw a level: the user's choice of quality, the output that follows from it, and the
 * preparation of a level for drawing.
 */
package nephele.host.draw;
