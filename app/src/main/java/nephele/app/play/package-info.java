/** The game: its loop, the current level and its recording, and the menu's control. */
package nephele.app.play;
