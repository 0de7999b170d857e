/**
 * The surface on which the viewport appears: {@link nephele.editor.surface.ViewportSurface} draws on a thread of its own,
 * because a picture can take seconds; Swing's thread hands over what is to be drawn and shows what is there.
 */
package nephele.editor.surface;
