/** What is derived from a level to draw it, still without OpenGL: geometry, views, visible sets, prepared light. */
package nephele.engine.scene;
