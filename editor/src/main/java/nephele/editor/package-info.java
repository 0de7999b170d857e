/** The level editor in Swing. */
package nephele.editor;
