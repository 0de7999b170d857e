/** What every command that draws has in common: from where, how large, how well. */
package nephele.app.draw;
