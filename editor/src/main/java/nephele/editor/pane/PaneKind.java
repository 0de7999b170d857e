package nephele.editor.pane;

/** The kind of a pane's view: a perspective, or one of three plans. */
public enum PaneKind {
    /** A perspective view from any place. */
    PERSPECTIVE,
    /** Orthographic, from above: x to the right, −z upwards in the picture. */
    TOP,
    /** Orthographic, along −z: x to the right, y upwards. */
    FRONT,
    /** Orthographic, along −x: −z to the right, y upwards. */
    SIDE
}
