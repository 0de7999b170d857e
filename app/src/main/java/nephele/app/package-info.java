/** Command line, game, HUD, audio and trade reports: what a user starts. */
package nephele.app;
