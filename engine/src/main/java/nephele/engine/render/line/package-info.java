/**
 * Lines, translucent polygons and squares of the world, drawn over a finished picture with its depth. The CPU projects
 * them in double precision relative to the eye; their widths are in pixels and their edges smooth. No level requires
 * them: the program that shows them creates {@link nephele.engine.render.line.LineDrawing}.
 */
package nephele.engine.render.line;
