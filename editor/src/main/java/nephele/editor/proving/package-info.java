/**
 * What the viewport tells about the open level, without windows: problems, heat map of portal placement, solution, traced
 * picture, compared clouds.
 */
package nephele.editor.proving;
