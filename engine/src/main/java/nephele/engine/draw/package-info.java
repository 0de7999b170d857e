/** What every program that draws a level shares: the quality a user chooses, the output it leads to, and the level prepared to be drawn. */
package nephele.engine.draw;
