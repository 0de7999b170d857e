/** What is under the pointer: the shapes and bounds of a level's entities, rays against them, and snapping to a grid. */
package nephele.editor.pick;
