/** What the game shows over the picture: each panel lays itself out from a value. */
package nephele.app.play.hud;
