/** The guided first room: six steps, each with what it asks for and how to tell that it is done. */
package nephele.editor.guide;
