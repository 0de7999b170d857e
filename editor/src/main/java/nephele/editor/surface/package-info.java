/**
 * The surface on which the viewport appears: a canvas of the window system, or an offscreen picture that Swing shows.
 * {@link nephele.editor.surface.ViewportSurfaces} chooses. All drawing happens on one thread: the event dispatch
 * thread, or without a display the thread that asks for pictures.
 */
package nephele.editor.surface;
