package nephele.editor.brush;

import nephele.engine.level.BoxFace;

/** The shapes that can be drawn by dragging a box, with their numbers. */
public sealed interface ShapeOptions {
    /** The most steps of stairs. */
    int MOST_STEPS = 1000;

    /** The box itself. */
    record Box() implements ShapeOptions {}

    /**
     * Half of the box, below a slope.
     *
     * @param rising the high side; {@code null} for +x or +z, whichever is longer
     */
    record Wedge(BoxFace rising) implements ShapeOptions {}

    /**
     * Boxes of growing height side by side.
     *
     * @param rising the high side; {@code null} for +x or +z, whichever is longer
     * @param steps 1 to {@link #MOST_STEPS}
     */
    record Stairs(BoxFace rising, int steps) implements ShapeOptions {}

    /**
     * Blocks of half an elliptic ring over an opening; the passage runs along the shorter horizontal side.
     *
     * @param segments number of blocks, 2 to 256
     * @param thicknessMetres from the opening to the outside at the feet and at the crown
     */
    record Arch(int segments, double thicknessMetres) implements ShapeOptions {}

    /**
     * An upright cylinder that touches the sides of the box.
     *
     * @param sides 3 to 62
     */
    record Cylinder(int sides) implements ShapeOptions {}

    /** Walls, floor and ceiling inside the box. */
    record Room(double wallMetres) implements ShapeOptions {}
}
