/** The overlay of a level with an observer: the outlines of the bounds, and the line that names keys and contact. */
package nephele.app.play.observer;
