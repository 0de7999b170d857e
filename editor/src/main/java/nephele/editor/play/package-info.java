/** Playing from the editor: the game in a process of its own that is started beforehand, and solutions replayed. */
package nephele.editor.play;
