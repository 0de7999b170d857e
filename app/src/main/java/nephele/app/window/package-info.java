/** The window with its keyboard and mouse input, without any rule of the game. */
package nephele.app.window;
