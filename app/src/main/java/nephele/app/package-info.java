/** The program that a user starts: command line, game, HUD, scene viewer and reports. */
package nephele.app;
