/** A simulated walk through a level, and the interpolated frame state and camera between two ticks. */
package nephele.host.playthrough;
