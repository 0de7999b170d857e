/** The select tool: click, drill through, boxes of entities touching or inside, and moving by dragging. */
package nephele.editor.tool.select;
