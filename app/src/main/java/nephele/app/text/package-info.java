/** The texts of the game in its languages: {@link nephele.app.text.Phrase}. */
package nephele.app.text;
