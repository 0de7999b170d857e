/** Tools that move, turn and scale the selection by handles. */
package nephele.editor.tool.transform;
