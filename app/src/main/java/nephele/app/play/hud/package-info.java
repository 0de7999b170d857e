/** The panels of the game's overlay. Each panel computes its layout from a value. */
package nephele.app.play.hud;
