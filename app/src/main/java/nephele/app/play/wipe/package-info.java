/** The wipe between two compared techniques: its keys, and its figures in words. */
package nephele.app.play.wipe;
