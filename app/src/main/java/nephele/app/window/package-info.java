/** The window and what its keyboard and mouse say, without any rule of the game. */
package nephele.app.window;
