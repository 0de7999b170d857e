/** Moves, turns and scales entities of any kind by the meaning of their components in the world. */
package nephele.editor.transform;
