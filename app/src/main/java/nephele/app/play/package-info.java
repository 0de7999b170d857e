/** The game: window, input, the loop and what it shows over the picture. */
package nephele.app.play;
